// The containers of glTF: the binary's chunks, data URIs and the files that a glTF file names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace deixis::assets::gltf {

struct Chunks {
    std::string_view json, bin;
    bool has_bin = false;
};

/// The chunks of a GLB (glTF 2.0, section 4.4), or the whole text of a .gltf. Throws Rejection.
[[nodiscard]] Chunks splitChunks(std::string_view bytes, const std::string& file);

/// The bytes of a data URI (RFC 2397, base64 alone). Throws Rejection.
[[nodiscard]] std::string decodeDataUri(std::string_view uri, const std::string& where);

/// The path, below the glTF file's folder, that an address other than a data URI stands for. Refused are a
/// scheme, absolute paths and paths that leave the folder. Throws Rejection; `where` names the place in the
/// file for it.
[[nodiscard]] std::string neighbourPath(std::string_view uri, const std::string& where);

/// The bytes of the file at a path that neighbourPath() gave, below `folder`. Refused are links that leave
/// the folder, and what is no plain file of `min_bytes` bytes or more. Throws Rejection.
[[nodiscard]] std::string readNeighbour(const std::string& relative, const std::filesystem::path& folder,
                                        std::size_t min_bytes, const std::string& where);

}  // namespace deixis::assets::gltf
