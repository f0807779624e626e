// Where a figure's nodes stand at rest; private to reading avatars. What does not hold of a file is told by
// gltf::Rejection in all that is private here.
#pragma once

#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "assets/gltf/gltf_document.hpp"
#include "core/pose.hpp"

namespace deixis::assets {

struct NodeTree {
    std::vector<glm::dmat4> world;  ///< file_from_node at rest (glTF 2.0, 3.5.3)
    std::vector<bool> drawn;        ///< whether the node stands in the scene that is shown
};

/// Refuses, naming the node, a rotation that is not of unit length.
[[nodiscard]] NodeTree readNodes(const gltf::Document& document);

[[nodiscard]] Vec3 transformed(const glm::dmat4& a_from_b, const Vec3& point_in_b);

/// A matrix that turns, scales alike in all directions and moves.
struct Similarity {
    Pose pose;  ///< after scaling
    double scale = 1.0;
};
/// Whether the matrix is one, to 5e-6 of its size; `out` is its closest one.
[[nodiscard]] bool similarity(const glm::dmat4& matrix, Similarity& out);

}  // namespace deixis::assets
