// Names of files on their way to the disk: a rename or removal is lost in a power cut until the disk has the
// folder's new entries, too.
#pragma once

#include <filesystem>

#include "core/error.hpp"

namespace deixis {

/// Waits until the disk has the folder's entries as they are now, as far as the file system allows.
void syncFolder(const std::filesystem::path& folder);

/// Gives a file another name, also that of a file which is then replaced, and waits until the disk has its
/// bytes and both names.
[[nodiscard]] Result<void> moveFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace deixis
