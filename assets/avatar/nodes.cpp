#include "nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace deixis::assets {

namespace {

glm::dmat4 localMatrix(const gltf::Document& document, std::size_t index) {
    const gltf::Node& node = document.nodes[index];
    if (node.matrix) return *node.matrix;
    if (!(std::abs(glm::length(node.rotation) - 1.0) < 1e-2))
        gltf::reject(document.file, fmt::format("node {} \"{}\" has a rotation that is not of unit length",
                                                index, node.name));
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), node.translation);
    if (node.rotation != no_rotation) matrix *= glm::mat4_cast(glm::normalize(node.rotation));
    return glm::scale(matrix, node.scale);
}

/// Visits the nodes that wait and all below them, parents first.
template <typename Visit>
void descend(const gltf::Document& document, std::vector<int> waiting, Visit visit) {
    while (!waiting.empty()) {
        const auto at = static_cast<std::size_t>(waiting.back());
        waiting.pop_back();
        visit(at);
        const auto& children = document.nodes[at].children;
        waiting.insert(waiting.end(), children.begin(), children.end());
    }
}

}  // namespace

NodeTree readNodes(const gltf::Document& document) {
    NodeTree tree;
    tree.world.resize(document.nodes.size());
    std::vector<int> roots;
    for (std::size_t i = 0; i < document.nodes.size(); ++i)
        if (document.nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
    descend(document, roots, [&](std::size_t at) {
        const int parent = document.nodes[at].parent;
        const glm::dmat4 local = localMatrix(document, at);
        tree.world[at] = parent < 0 ? local : tree.world[static_cast<std::size_t>(parent)] * local;
    });
    tree.drawn.assign(document.nodes.size(), document.scenes.empty());
    if (!document.scenes.empty())
        descend(document, document.scenes[static_cast<std::size_t>(document.scene)],
                [&](std::size_t at) { tree.drawn[at] = true; });
    return tree;
}

Vec3 transformed(const glm::dmat4& a_from_b, const Vec3& point_in_b) {
    return Vec3(a_from_b * glm::dvec4(point_in_b, 1.0));
}

bool similarity(const glm::dmat4& matrix, Similarity& out) {
    const glm::dmat3 m(matrix);
    const double determinant = glm::determinant(m);
    if (!(determinant > 0.0) || !std::isfinite(determinant)) return false;
    out.scale = std::cbrt(determinant);
    const glm::dmat3 rotation = m / out.scale;
    const glm::dmat3 product = glm::transpose(rotation) * rotation;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(product[c][r] - (c == r ? 1.0 : 0.0)) < 5e-6)) return false;
    out.pose.orientation = glm::normalize(glm::quat_cast(rotation));
    out.pose.position = Vec3(matrix[3]);
    return true;
}

}  // namespace deixis::assets
