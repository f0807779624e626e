// A glTF file and all that it names, as bytes in memory; private to reading avatars.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::assets {

struct AvatarFile {
    tinygltf::Model model;     ///< images hold their files' bytes, not yet decoded
    std::string content_hash;  ///< SHA-256 of the file; where it names others, of all of them together
    std::vector<std::filesystem::path> beside{};  ///< the files that it names
};

/// GLB or glTF JSON, told apart by the first bytes. Only files in the folder of `path` and below are opened.
[[nodiscard]] Result<AvatarFile> readAvatarFile(const std::filesystem::path& path);
/// The same from bytes; `file` stands for it in errors. Without a folder, no other files are opened.
[[nodiscard]] Result<AvatarFile> readAvatarBytes(std::string_view bytes, const std::string& file,
                                                 const std::optional<std::filesystem::path>& folder);

}  // namespace deixis::assets
