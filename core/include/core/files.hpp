// Whole files in and out, with errors that name the file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace deixis {

/// The maximum number of bytes that are read at once.
inline constexpr std::size_t max_file_bytes = std::size_t{4} << 30U;

/// All of a file, or of a pipe until its other end closes it. Devices are rejected: some never end. So is
/// what has more than `max_bytes`.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path,
                                           std::size_t max_bytes = max_file_bytes);

/// All that comes until the stream ends; likewise bounded. `name` stands for it in errors; `expected_bytes`
/// may be 0.
[[nodiscard]] Result<std::string> readAll(std::istream& in, const std::string& name,
                                          std::size_t expected_bytes = 0,
                                          std::size_t max_bytes = max_file_bytes);

/// Writes to a neighbour and renames it into place: a reader sees the old file or the new one, never a half,
/// and on return the disk has the new one, with its name and the folders made for it. A pipe or device is
/// written to as it is.
[[nodiscard]] Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

/// The same without waiting for the disk: for what can be made again, and for files of a folder that is
/// waited for as a whole (syncFileSystem()).
[[nodiscard]] Result<void> writeFileUnsynced(const std::filesystem::path& path, std::string_view bytes);

}  // namespace deixis
