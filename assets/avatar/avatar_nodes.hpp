// The nodes of a glTF file as a checked tree; private to reading avatars.
#pragma once

#include <tiny_gltf.h>

#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::assets {

struct NodeTree {
    std::vector<int> parent;        ///< of each node; -1 for a root
    std::vector<glm::dmat4> world;  ///< file_from_node at rest (glTF 2.0, 3.5.3)
    std::vector<bool> drawn;        ///< whether the node stands in the scene that is shown
};

/// Fails, naming the node, where nodes form no tree or a transform is not finite or has no extent.
[[nodiscard]] Result<NodeTree> readNodes(const tinygltf::Model& model, const std::string& file);

[[nodiscard]] Vec3 transformed(const glm::dmat4& a_from_b, const Vec3& point_in_b);

/// A matrix that turns, scales alike in all directions and moves.
struct Similarity {
    Pose pose;  ///< after scaling
    double scale = 1.0;
};
/// Whether the matrix is one, to 5e-6 of its size; `out` is its closest one.
[[nodiscard]] bool similarity(const glm::dmat4& matrix, Similarity& out);

/// Matrix number `index` of a row of column-major ones.
[[nodiscard]] glm::dmat4 matrixAt(const std::vector<float>& values, std::size_t index);

}  // namespace deixis::assets
