#include "assets/avatar/avatar_glb.hpp"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "assets/gltf/glb_writer.hpp"
#include "png.hpp"

namespace deixis::assets {

namespace {

constexpr int vertex_target = 34962, index_target = 34963;
constexpr int repeat_wrap = 10497, clamp_wrap = 33071, mirror_wrap = 33648;
constexpr int nearest_filter = 9728, linear_filter = 9729, mipmap_filter = 9987;

AvatarTexture halved(const AvatarTexture& texture) {
    AvatarTexture out = texture;
    out.width = std::max(1, texture.width / 2);
    out.height = std::max(1, texture.height / 2);
    out.rgba.clear();
    const auto at = [&](int x, int y, int channel) -> int {
        const int column = std::min(x, texture.width - 1), row = std::min(y, texture.height - 1);
        const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
                           static_cast<std::size_t>(column);
        return texture.rgba[4 * pixel + static_cast<std::size_t>(channel)];
    };
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const int sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                                at(2 * x + 1, 2 * y + 1, c);
                out.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
            }
    return out;
}

int wrapNumber(TextureWrap wrap) {
    if (wrap == TextureWrap::clamp) return clamp_wrap;
    return wrap == TextureWrap::mirror ? mirror_wrap : repeat_wrap;
}

void addTextures(const Avatar& avatar, GlbWriter& glb, GltfJson& root) {
    if (avatar.textures.empty()) return;
    for (const char* list : {"images", "samplers", "textures"}) root[list] = GltfJson::array();
    for (const AvatarTexture& whole : avatar.textures) {
        AvatarTexture texture = whole;
        while (std::max(texture.width, texture.height) > largest_texture_side) texture = halved(texture);
        const std::size_t view = glb.addBytes(pngBytes(texture.width, texture.height, texture.rgba));
        const std::size_t index = root["images"].size();
        root["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
        root["samplers"].push_back({{"magFilter", texture.nearest ? nearest_filter : linear_filter},
                                    {"minFilter", texture.nearest ? nearest_filter : mipmap_filter},
                                    {"wrapS", wrapNumber(texture.wrap_u)},
                                    {"wrapT", wrapNumber(texture.wrap_v)}});
        root["textures"].push_back({{"sampler", index}, {"source", index}});
    }
}

GltfJson materialOf(const AvatarPart& part) {
    GltfJson material{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.8}}}};
    if (part.texture >= 0) material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", part.texture}};
    if (part.alpha_cutoff > 0.0F) {
        material["alphaMode"] = "MASK";
        material["alphaCutoff"] = part.alpha_cutoff;
    }
    if (part.double_sided) material["doubleSided"] = true;
    return material;
}

GltfJson addVertices(const Avatar& avatar, GlbWriter& glb) {
    std::vector<float> positions, normals, colours, weights, uvs;
    std::vector<std::uint16_t> joints;
    std::array<float, 3> min{}, max{};
    for (const SkinnedVertex& v : avatar.vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            const bool first = positions.size() < 3;
            float& low = min[static_cast<std::size_t>(axis)];
            float& high = max[static_cast<std::size_t>(axis)];
            low = first ? v.position[axis] : std::min(low, v.position[axis]);
            high = first ? v.position[axis] : std::max(high, v.position[axis]);
            positions.push_back(v.position[axis]);
            normals.push_back(v.normal[axis]);
            colours.push_back(v.colour[axis]);
        }
        joints.insert(joints.end(), v.joints.begin(), v.joints.end());
        weights.insert(weights.end(), v.weights.begin(), v.weights.end());
        uvs.insert(uvs.end(), {v.uv.x, v.uv.y});
    }
    const std::size_t count = avatar.vertices.size();
    GltfJson attributes;
    attributes["POSITION"] = glb.add(positions, count, "VEC3", vertex_target);
    glb.setBounds(attributes["POSITION"].get<std::size_t>(), min, max);
    attributes["NORMAL"] = glb.add(normals, count, "VEC3", vertex_target);
    attributes["COLOR_0"] = glb.add(colours, count, "VEC3", vertex_target);
    attributes["JOINTS_0"] = glb.add(joints, count, "VEC4", vertex_target);
    attributes["WEIGHTS_0"] = glb.add(weights, count, "VEC4", vertex_target);
    if (!avatar.textures.empty()) attributes["TEXCOORD_0"] = glb.add(uvs, count, "VEC2", vertex_target);
    return attributes;
}

void addMesh(const Avatar& avatar, GlbWriter& glb, GltfJson& root) {
    std::vector<AvatarPart> parts = avatar.parts;
    if (parts.empty()) {
        parts.emplace_back();
        parts.back().index_count = static_cast<std::uint32_t>(avatar.indices.size());
    }
    const GltfJson attributes = addVertices(avatar, glb);
    GltfJson primitives = GltfJson::array();
    root["materials"] = GltfJson::array();
    for (const AvatarPart& part : parts) {
        const auto first = avatar.indices.begin() + part.first_index;
        const std::vector<std::uint32_t> corners(first, first + part.index_count);
        primitives.push_back({{"attributes", attributes},
                              {"indices", glb.add(corners, corners.size(), "SCALAR", index_target)},
                              {"material", root["materials"].size()}});
        root["materials"].push_back(materialOf(part));
    }
    root["meshes"] = GltfJson::array({{{"name", "body"}, {"primitives", primitives}}});
}

/// Joints first, in their order; then the tips; last the node of the mesh.
void addNodes(const motion::Skeleton& skeleton, GltfJson& root) {
    const auto place = [](const Vec3& v) { return GltfJson{v.x, v.y, v.z}; };
    const std::size_t count = skeleton.joints.size();
    std::vector<GltfJson> children(count, GltfJson::array());
    GltfJson nodes = GltfJson::array(), tips = GltfJson::array(), roots = GltfJson::array();
    for (std::size_t j = 0; j < count; ++j) {
        const motion::Joint& joint = skeleton.joints[j];
        (joint.parent >= 0 ? children[static_cast<std::size_t>(joint.parent)] : roots).push_back(j);
        nodes.push_back({{"name", joint.name}, {"translation", place(joint.rest.position)}});
        if (!joint.end_site) continue;
        children[j].push_back(count + tips.size());
        tips.push_back({{"name", joint.name + "_end"}, {"translation", place(*joint.end_site)}});
    }
    for (std::size_t j = 0; j < count; ++j)
        if (!children[j].empty()) nodes[j]["children"] = children[j];
    nodes.insert(nodes.end(), tips.begin(), tips.end());
    roots.push_back(nodes.size());
    nodes.push_back({{"name", "body"}, {"mesh", 0}, {"skin", 0}});
    root["scene"] = 0;
    root["scenes"] = GltfJson::array({{{"name", "avatar"}, {"nodes", roots}}});
    root["nodes"] = nodes;
}

void addSkin(const Avatar& avatar, GlbWriter& glb, GltfJson& root) {
    std::vector<float> inverse_bind;
    GltfJson joints = GltfJson::array();
    for (const Pose& pose : avatar.joint_from_bind) {
        glm::dmat4 matrix = glm::mat4_cast(pose.orientation);
        matrix[3] = glm::dvec4(pose.position, 1.0);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) inverse_bind.push_back(static_cast<float>(matrix[column][row]));
        joints.push_back(joints.size());
    }
    const std::size_t matrices = glb.add(inverse_bind, joints.size(), "MAT4");
    root["skins"] = GltfJson::array(
        {{{"name", "humanoid"}, {"inverseBindMatrices", matrices}, {"skeleton", 0}, {"joints", joints}}});
}

}  // namespace

std::string writeAvatarGlb(const Avatar& avatar) {
    GlbWriter glb;
    GltfJson root;
    root["asset"] = {{"version", "2.0"}, {"generator", "Deixis"}};
    addNodes(avatar.skeleton, root);
    addMesh(avatar, glb, root);
    addTextures(avatar, glb, root);
    addSkin(avatar, glb, root);
    return glb.file(std::move(root));
}

}  // namespace deixis::assets
