// The rules of sparse accessors (glTF 2.0, section 3.6.2.3), for both readers of glTF files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace deixis::assets::gltf {

/// What is wrong with replacing `count` of `elements` elements by indices of this component type; none: it
/// may be done, and an index takes componentSize(index_type) bytes.
[[nodiscard]] std::optional<std::string> sparseProblem(std::size_t count, int index_type,
                                                       std::size_t elements);

/// The replaced elements: `count` indices, close together in `bytes`, that rise and lie below `elements`. The
/// error is what is wrong, without the place. Only where sparseProblem finds nothing.
[[nodiscard]] tl::expected<std::vector<std::size_t>, std::string> sparseIndices(const char* bytes,
                                                                                std::size_t count,
                                                                                int index_type,
                                                                                std::size_t elements);

}  // namespace deixis::assets::gltf
