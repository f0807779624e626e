// One primitive of a glTF mesh as plain arrays; private to reading avatars.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assets/gltf/gltf_values.hpp"

namespace deixis::assets {

struct PrimitiveData {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec3> colours;  ///< COLOR_0; empty where there are none
    std::vector<glm::vec2> uvs;      ///< empty where there are none
    /// Joints of the skin with their weights, by falling weight, at most 4, sum 1; empty without a skin.
    std::vector<std::vector<std::pair<std::uint32_t, float>>> influences;
    std::vector<std::uint32_t> triangles;
    bool more_than_four = false;  ///< a vertex had more influences
    bool unweighted = false;      ///< a vertex had none: it follows the skin's first joint
};

/// What is wanted of a primitive beside positions and normals.
struct PrimitiveWants {
    std::optional<std::size_t> skin_joints;  ///< how many joints the skin has; none: not skinned
    int uv_set = -1;
};

/// Triangles of any kind (lists, strips, fans; with indices or without); none where it has points or lines.
/// Normals that are missing are computed from the triangles.
[[nodiscard]] std::optional<PrimitiveData> readPrimitive(const gltf::Document& document,
                                                         const gltf::Values& values,
                                                         const gltf::Primitive& primitive,
                                                         const PrimitiveWants& wants);

}  // namespace deixis::assets
