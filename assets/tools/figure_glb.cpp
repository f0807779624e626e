#include "figure_glb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace deixis::assets {

namespace {

constexpr int target_vertices = 34962, target_indices = 34963;

/// Numbers as fmt writes them: the shortest digits, whole ones without a point.
template <typename T>
GltfJson shortest(const std::array<T, 3>& values) {
    return GltfJson::parse(fmt::format("[{}]", fmt::join(values, ",")));
}

GltfJson vectorJson(const Vec3& v) {
    return shortest(std::array{v.x, v.y, v.z});
}

/// Joints first, in their order; then the tips; last the node of the mesh.
GltfJson nodesJson(const std::vector<FigureJoint>& joints) {
    std::vector<GltfJson> children(joints.size(), GltfJson::array());
    GltfJson tips = GltfJson::array();
    for (std::size_t j = 0; j < joints.size(); ++j)
        if (joints[j].parent >= 0) children[static_cast<std::size_t>(joints[j].parent)].push_back(j);
    GltfJson nodes = GltfJson::array();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const FigureJoint& joint = joints[j];
        if (joint.tip) {
            children[j].push_back(joints.size() + tips.size());
            tips.push_back({{"name", joint.name + "_end"}, {"translation", vectorJson(*joint.tip)}});
        }
        nodes.push_back({{"name", joint.name}, {"translation", vectorJson(joint.in_parent)}});
        if (!children[j].empty()) nodes.back()["children"] = children[j];
    }
    nodes.insert(nodes.end(), tips.begin(), tips.end());
    nodes.push_back({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
    return nodes;
}

void setPositionBounds(GlbWriter& glb, std::size_t accessor, const std::vector<float>& positions) {
    std::array<float, 3> min{}, max{};
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::size_t axis = i % 3;
        min[axis] = i < 3 ? positions[i] : std::min(min[axis], positions[i]);
        max[axis] = i < 3 ? positions[i] : std::max(max[axis], positions[i]);
    }
    glb.setBounds(accessor, shortest(min), shortest(max));
}

}  // namespace

std::string figureGlb(const std::string& generator, const std::vector<FigureJoint>& joints,
                      const FigureVertices& vertices, const std::vector<std::uint32_t>& indices,
                      const GltfJson& material) {
    GlbWriter glb;
    const std::size_t count = vertices.positions.size() / 3;
    GltfJson attributes;
    const auto add = [&](const char* name, const auto& values, const char* type) {
        attributes[name] = glb.add(values, count, type, target_vertices);
    };
    add("POSITION", vertices.positions, "VEC3");
    setPositionBounds(glb, 0, vertices.positions);
    add("NORMAL", vertices.normals, "VEC3");
    if (!vertices.colours.empty()) add("COLOR_0", vertices.colours, "VEC3");
    add("JOINTS_0", vertices.joints, "VEC4");
    add("WEIGHTS_0", vertices.weights, "VEC4");
    const std::size_t corners = glb.add(indices, indices.size(), "SCALAR", target_indices);
    std::vector<float> inverse_bind;
    GltfJson skin_joints = GltfJson::array();
    for (const FigureJoint& joint : joints) {
        for (int i = 0; i < 12; ++i) inverse_bind.push_back(i % 5 == 0 ? 1.0F : 0.0F);
        for (int axis = 0; axis < 3; ++axis)
            inverse_bind.push_back(static_cast<float>(-joint.position[axis]));
        inverse_bind.push_back(1.0F);
        skin_joints.push_back(skin_joints.size());
    }
    const std::size_t matrices = glb.add(inverse_bind, joints.size(), "MAT4");

    GltfJson root;
    root["asset"] = {{"version", "2.0"}, {"generator", generator}};
    root["scene"] = 0;
    const GltfJson nodes = nodesJson(joints);
    root["scenes"] = GltfJson::array({{{"name", "avatar"}, {"nodes", {0, nodes.size() - 1}}}});
    root["nodes"] = nodes;
    const GltfJson primitive = {{"attributes", attributes}, {"indices", corners}, {"material", 0}};
    root["meshes"] = GltfJson::array({{{"name", "body"}, {"primitives", GltfJson::array({primitive})}}});
    root["materials"] = GltfJson::array({material});
    root["skins"] = GltfJson::array({{{"name", "humanoid"},
                                      {"inverseBindMatrices", matrices},
                                      {"skeleton", 0},
                                      {"joints", skin_joints}}});
    return glb.file(std::move(root));
}

}  // namespace deixis::assets
