// Whole files that may be packed with gzip.
#pragma once

#include <filesystem>
#include <string>

#include "core/files.hpp"

namespace deixis::assets {

/// The file's bytes, unpacked where they begin as gzip data do; at most 4 GiB then.
[[nodiscard]] Result<std::string> readUnpacked(const std::filesystem::path& path);

}  // namespace deixis::assets
