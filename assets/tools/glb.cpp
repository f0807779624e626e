#include "glb.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

#include "motion/humanoid/reference_humanoid.hpp"

namespace deixis::avatar_maker {

namespace {

constexpr int target_vertices = 34962, target_indices = 34963;
constexpr int type_u8 = 5121, type_u32 = 5125, type_float = 5126;

/// The binary chunk with the JSON of its views and accessors.
class Buffer {
  public:
    template <typename T>
    void add(const std::vector<T>& values, std::size_t count, int component_type, std::string_view type,
             int target, const std::string& bounds = {}) {
        const std::size_t offset = bytes_.size();
        const std::size_t size = values.size() * sizeof(T);
        bytes_.resize(offset + size);
        std::memcpy(bytes_.data() + offset, values.data(), size);
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        const std::string target_json = target == 0 ? "" : fmt::format(R"(,"target":{})", target);
        views_.push_back(
            fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset, size, target_json));
        accessors_.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                         views_.size() - 1, component_type, count, type, bounds));
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::string viewsJson() const { return fmt::format("[{}]", fmt::join(views_, ",")); }
    [[nodiscard]] std::string accessorsJson() const {
        return fmt::format("[{}]", fmt::join(accessors_, ","));
    }

  private:
    std::string bytes_;
    std::vector<std::string> views_, accessors_;
};

std::string vectorJson(const Vec3& v) {
    return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

/// Joints first, in the skeleton's order; then the tips; last the node of the mesh.
std::string nodesJson(const motion::Skeleton& skeleton) {
    const auto count = static_cast<std::size_t>(skeleton.size());
    std::vector<std::vector<std::size_t>> children(count);
    std::vector<std::string> tips;
    for (std::size_t j = 0; j < count; ++j) {
        const motion::Joint& joint = skeleton.joints[j];
        if (joint.parent >= 0) children[static_cast<std::size_t>(joint.parent)].push_back(j);
    }
    for (std::size_t j = 0; j < count; ++j)
        if (const motion::Joint& joint = skeleton.joints[j]; joint.end_site) {
            children[j].push_back(count + tips.size());
            tips.push_back(fmt::format(R"({{"name":"{}_end","translation":{}}})", joint.name,
                                       vectorJson(*joint.end_site)));
        }
    std::vector<std::string> nodes;
    for (std::size_t j = 0; j < count; ++j) {
        const motion::Joint& joint = skeleton.joints[j];
        const std::string below =
            children[j].empty() ? "" : fmt::format(R"(,"children":[{}])", fmt::join(children[j], ","));
        nodes.push_back(fmt::format(R"({{"name":"{}","translation":{}{}}})", joint.name,
                                    vectorJson(joint.rest.position), below));
    }
    nodes.insert(nodes.end(), tips.begin(), tips.end());
    nodes.push_back(R"({"name":"body","mesh":0,"skin":0})");
    return fmt::format("[{}]", fmt::join(nodes, ","));
}

std::string positionBounds(const std::vector<float>& positions) {
    std::array<float, 3> least{}, greatest{};
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::size_t axis = i % 3;
        least[axis] = i < 3 ? positions[i] : std::min(least[axis], positions[i]);
        greatest[axis] = i < 3 ? positions[i] : std::max(greatest[axis], positions[i]);
    }
    return fmt::format(R"(,"min":[{}],"max":[{}])", fmt::join(least, ","), fmt::join(greatest, ","));
}

std::vector<float> inverseBindMatrices(const motion::Skeleton& skeleton) {
    std::vector<float> matrices;
    for (const Pose& joint : motion::worldPose(skeleton, motion::restPose(skeleton))) {
        const auto x = static_cast<float>(-joint.position.x);
        const auto y = static_cast<float>(-joint.position.y);
        const auto z = static_cast<float>(-joint.position.z);
        for (const float value :
             {1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, x, y, z, 1.0F})
            matrices.push_back(value);
    }
    return matrices;
}

void appendU32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>(value >> shift & 0xFFU));
}

}  // namespace

std::string glbOf(const std::vector<assets::SkinnedVertex>& vertices,
                  const std::vector<std::uint32_t>& indices) {
    const motion::Skeleton& skeleton = motion::referenceHumanoid();
    std::vector<float> positions, normals, colours, weights;
    std::vector<std::uint8_t> joints;
    for (const assets::SkinnedVertex& v : vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            positions.push_back(v.position[axis]);
            normals.push_back(v.normal[axis]);
            colours.push_back(v.colour[axis]);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            joints.push_back(static_cast<std::uint8_t>(v.joints[i]));
            weights.push_back(v.weights[i]);
        }
    }
    Buffer buffer;
    buffer.add(positions, vertices.size(), type_float, "VEC3", target_vertices, positionBounds(positions));
    buffer.add(normals, vertices.size(), type_float, "VEC3", target_vertices);
    buffer.add(colours, vertices.size(), type_float, "VEC3", target_vertices);
    buffer.add(joints, vertices.size(), type_u8, "VEC4", target_vertices);
    buffer.add(weights, vertices.size(), type_float, "VEC4", target_vertices);
    buffer.add(indices, indices.size(), type_u32, "SCALAR", target_indices);
    buffer.add(inverseBindMatrices(skeleton), static_cast<std::size_t>(skeleton.size()), type_float, "MAT4",
               0);

    std::vector<int> skin_joints;
    for (int j = 0; j < skeleton.size(); ++j) skin_joints.push_back(j);
    std::size_t tip_count = 0;
    for (const motion::Joint& joint : skeleton.joints) tip_count += joint.end_site ? 1 : 0;
    const std::size_t body = skin_joints.size() + tip_count;
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"deixis_make_avatar"}},)"
        R"("scene":0,"scenes":[{{"name":"avatar","nodes":[0,{}]}}],"nodes":{},)"
        R"("meshes":[{{"name":"body","primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1,"COLOR_0":2,)"
        R"("JOINTS_0":3,"WEIGHTS_0":4}},"indices":5,"material":0}}]}}],)"
        R"("materials":[{{"name":"body","pbrMetallicRoughness":{{"metallicFactor":0,"roughnessFactor":0.8}}}}],)"
        R"("skins":[{{"name":"humanoid","inverseBindMatrices":6,"skeleton":0,"joints":[{}]}}],)"
        R"("accessors":{},"bufferViews":{},"buffers":[{{"byteLength":{}}}]}})",
        body, nodesJson(skeleton), fmt::join(skin_joints, ","), buffer.accessorsJson(), buffer.viewsJson(),
        buffer.bytes().size());
    json.resize((json.size() + 3) / 4 * 4, ' ');

    constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    std::string glb = "glTF";
    appendU32(glb, 2);
    appendU32(glb, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.bytes().size()));
    appendU32(glb, static_cast<std::uint32_t>(json.size()));
    appendU32(glb, json_chunk);
    glb += json;
    appendU32(glb, static_cast<std::uint32_t>(buffer.bytes().size()));
    appendU32(glb, binary_chunk);
    glb += buffer.bytes();
    return glb;
}

}  // namespace deixis::avatar_maker
