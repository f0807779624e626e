// Whole files in and out, with errors that name the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace deixis {

[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path);

/// Writes to a neighbour and renames it into place: a reader sees the old file or the new one, never a half.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace deixis
