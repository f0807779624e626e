// Making files and their names durable: a rename or removal can be lost in a power cut until the folder's
// new entries are on disk, too. One file is written by writeFile() (files.hpp).
#pragma once

#include <filesystem>

#include "core/error.hpp"

namespace deixis {

/// Waits until the disk has the folder's entries as they are now, as far as the file system allows.
void syncFolder(const std::filesystem::path& folder);

/// Waits until the disk has all that was written on the file system of this folder: cheaper than one file
/// after another, where there are many.
void syncFileSystem(const std::filesystem::path& folder);

/// Gives a file another name, also that of a file which is then replaced, and waits until the disk has its
/// bytes and both names. Fails, with the old name kept, where the disk does not take the bytes.
[[nodiscard]] Result<void> moveFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace deixis
