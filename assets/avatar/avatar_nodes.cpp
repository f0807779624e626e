#include "avatar_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace deixis::assets {

namespace {

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Result<glm::dmat4> localMatrix(const tinygltf::Node& node, std::size_t index, const std::string& file) {
    const auto bad = [&](const char* what) {
        return fail(file, fmt::format("node {} \"{}\" {}", index, node.name, what), "Export the file anew");
    };
    for (const auto* values : {&node.translation, &node.rotation, &node.scale, &node.matrix})
        if (!finite(*values)) return bad("holds a number that is not finite");
    glm::dmat4 matrix(1.0);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    } else {
        if (node.translation.size() == 3)
            matrix = glm::translate(matrix, {node.translation[0], node.translation[1], node.translation[2]});
        if (node.rotation.size() == 4) {
            const Quat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
            if (!(std::abs(glm::length(q) - 1.0) < 1e-2))
                return bad("has a rotation that is not of unit length");
            if (q != no_rotation) matrix *= glm::mat4_cast(glm::normalize(q));
        }
        if (node.scale.size() == 3)
            matrix = glm::scale(matrix, Vec3(node.scale[0], node.scale[1], node.scale[2]));
    }
    return matrix;
}

Result<void> findParents(const tinygltf::Model& model, const std::string& file, std::vector<int>& parents) {
    const auto bad = [&](std::string message) {
        return fail(file, std::move(message), "Export the file anew");
    };
    parents.assign(model.nodes.size(), -1);
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        for (const int child : model.nodes[i].children) {
            if (child < 0 || static_cast<std::size_t>(child) >= model.nodes.size())
                return bad(fmt::format("node {} has a child {} that does not exist", i, child));
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent >= 0) return bad(fmt::format("node {} has two parents", child));
            parent = static_cast<int>(i);
        }
    return {};
}

}  // namespace

Result<NodeTree> readNodes(const tinygltf::Model& model, const std::string& file) {
    NodeTree tree;
    if (auto found = findParents(model, file, tree.parent); !found) return tl::unexpected(found.error());
    tree.world.assign(model.nodes.size(), glm::dmat4(1.0));
    std::vector<int> waiting;
    for (std::size_t i = 0; i < tree.parent.size(); ++i)
        if (tree.parent[i] < 0) waiting.push_back(static_cast<int>(i));
    std::size_t reached = 0;
    while (!waiting.empty()) {
        const auto at = static_cast<std::size_t>(waiting.back());
        waiting.pop_back();
        ++reached;
        const auto local = localMatrix(model.nodes[at], at, file);
        if (!local) return tl::unexpected(local.error());
        const int parent = tree.parent[at];
        tree.world[at] = parent < 0 ? *local : tree.world[static_cast<std::size_t>(parent)] * *local;
        waiting.insert(waiting.end(), model.nodes[at].children.begin(), model.nodes[at].children.end());
    }
    if (reached != model.nodes.size()) return fail(file, "the nodes form a ring", "Export the file anew");

    tree.drawn.assign(model.nodes.size(), model.scenes.empty());
    const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
    if (scene < model.scenes.size()) waiting = model.scenes[scene].nodes;
    while (!waiting.empty()) {
        const int at = waiting.back();
        waiting.pop_back();
        if (at < 0 || static_cast<std::size_t>(at) >= model.nodes.size())
            return fail(file, fmt::format("the scene has a node {} that does not exist", at),
                        "Export the file anew");
        if (tree.drawn[static_cast<std::size_t>(at)]) continue;
        tree.drawn[static_cast<std::size_t>(at)] = true;
        const auto& children = model.nodes[static_cast<std::size_t>(at)].children;
        waiting.insert(waiting.end(), children.begin(), children.end());
    }
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

glm::dmat4 matrixAt(const std::vector<float>& values, std::size_t index) {
    glm::dmat4 matrix(1.0);
    for (std::size_t i = 0; i < 16; ++i)
        matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] =
            static_cast<double>(values[index * 16 + i]);
    return matrix;
}

}  // namespace deixis::assets
