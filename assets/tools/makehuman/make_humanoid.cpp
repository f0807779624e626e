// MakeHuman's base mesh with one of MPFB's rigs as glTF 2.0 binary:
// deixis_make_humanoid BASE.obj RIG.json WEIGHTS.json OUT.glb
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <glm/geometric.hpp>
#include <sstream>

#include "base_mesh.hpp"
#include "core/files.hpp"

namespace {

using namespace deixis;
using namespace deixis::humanoid_maker;

/// What the file holds of the mesh: the vertices of the body alone.
struct Body {
    std::vector<float> positions, normals, weights;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint16_t> indices;
};

Body bodyOf(const BaseMesh& mesh, const std::vector<VertexWeights>& weights) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3(0.0));
    for (const auto& t : mesh.body) {
        const Vec3 cross =
            glm::cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        for (const std::uint32_t v : t) normals[v] += cross;
    }
    Body body;
    std::vector<int> place(mesh.vertices.size(), -1);
    int count = 0;
    for (const auto& t : mesh.body)
        for (const std::uint32_t v : t) {
            if (place[v] < 0) {
                place[v] = count++;
                const glm::vec3 normal(glm::normalize(normals[v]));
                for (int axis = 0; axis < 3; ++axis) {
                    body.positions.push_back(static_cast<float>(mesh.vertices[v][axis]));
                    body.normals.push_back(normal[axis]);
                }
                body.weights.insert(body.weights.end(), weights[v].weights.begin(), weights[v].weights.end());
                body.joints.insert(body.joints.end(), weights[v].bones.begin(), weights[v].bones.end());
            }
            body.indices.push_back(static_cast<std::uint16_t>(place[v]));
        }
    return body;
}

class Writer {
  public:
    Writer() {
        model_.asset.version = "2.0";
        model_.asset.generator = "deixis_make_humanoid";
        model_.buffers.resize(1);
    }

    template <typename T>
    int add(const std::vector<T>& values, std::size_t count, int component_type, int type, int target) {
        auto& data = model_.buffers[0].data;
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = values.size() * sizeof(T);
        view.target = target;
        data.resize((data.size() + view.byteLength + 3) / 4 * 4);
        std::memcpy(data.data() + view.byteOffset, values.data(), view.byteLength);
        model_.bufferViews.push_back(view);
        tinygltf::Accessor accessor;
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.componentType = component_type;
        accessor.count = count;
        accessor.type = type;
        model_.accessors.push_back(accessor);
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    /// The bones, each with a tip where none hangs on it.
    void addBones(const std::vector<RigBone>& bones) {
        tinygltf::Skin skin;
        std::vector<float> inverse;
        for (std::size_t b = 0; b < bones.size(); ++b) {
            const RigBone& bone = bones[b];
            const Vec3 above =
                bone.parent < 0 ? Vec3(0.0) : bones[static_cast<std::size_t>(bone.parent)].head;
            addNode(bone.name, bone.head - above, bone.parent);
            skin.joints.push_back(static_cast<int>(b));
            for (int i = 0; i < 12; ++i) inverse.push_back(i % 5 == 0 ? 1.0F : 0.0F);
            for (int axis = 0; axis < 3; ++axis) inverse.push_back(static_cast<float>(-bone.head[axis]));
            inverse.push_back(1.0F);
        }
        for (std::size_t b = 0; b < bones.size(); ++b) {
            const bool ends = std::none_of(bones.begin(), bones.end(), [&](const RigBone& other) {
                return other.parent == static_cast<int>(b);
            });
            if (ends) addNode(bones[b].name + "_end", bones[b].tail - bones[b].head, static_cast<int>(b));
        }
        skin.inverseBindMatrices =
            add(inverse, bones.size(), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_MAT4, 0);
        skin.skeleton = 0;
        model_.skins.push_back(skin);
    }

    void addBody(const Body& body) {
        const std::size_t count = body.positions.size() / 3;
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = 0;
        const int positions = add(body.positions, count, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                                  TINYGLTF_TARGET_ARRAY_BUFFER);
        auto& accessor = model_.accessors[static_cast<std::size_t>(positions)];
        accessor.minValues = accessor.maxValues = {body.positions.begin(), body.positions.begin() + 3};
        for (std::size_t i = 0; i < body.positions.size(); ++i) {
            const auto value = static_cast<double>(body.positions[i]);
            accessor.minValues[i % 3] = std::min(accessor.minValues[i % 3], value);
            accessor.maxValues[i % 3] = std::max(accessor.maxValues[i % 3], value);
        }
        primitive.attributes["POSITION"] = positions;
        primitive.attributes["NORMAL"] = add(body.normals, count, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                             TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
        primitive.attributes["JOINTS_0"] = add(body.joints, count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                               TINYGLTF_TYPE_VEC4, TINYGLTF_TARGET_ARRAY_BUFFER);
        primitive.attributes["WEIGHTS_0"] = add(body.weights, count, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                                TINYGLTF_TYPE_VEC4, TINYGLTF_TARGET_ARRAY_BUFFER);
        primitive.indices = add(body.indices, body.indices.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        tinygltf::Mesh mesh;
        mesh.name = "body";
        mesh.primitives.push_back(primitive);
        model_.meshes.push_back(mesh);

        tinygltf::Material material;
        material.name = "skin";
        material.pbrMetallicRoughness.baseColorFactor = {0.60, 0.36, 0.25, 1.0};
        material.pbrMetallicRoughness.metallicFactor = 0.0;
        material.pbrMetallicRoughness.roughnessFactor = 0.7;
        model_.materials.push_back(material);

        tinygltf::Node node;
        node.name = "body";
        node.mesh = 0;
        node.skin = 0;
        model_.nodes.push_back(node);
        tinygltf::Scene scene;
        scene.nodes = {0, static_cast<int>(model_.nodes.size()) - 1};
        model_.scenes.push_back(scene);
        model_.defaultScene = 0;
    }

    std::string bytes() {
        std::ostringstream out;
        tinygltf::TinyGLTF writer;
        return writer.WriteGltfSceneToStream(&model_, out, false, true) ? out.str() : std::string();
    }

  private:
    void addNode(const std::string& name, const Vec3& position, int parent) {
        tinygltf::Node node;
        node.name = name;
        node.translation = {position.x, position.y, position.z};
        model_.nodes.push_back(node);
        if (parent >= 0)
            model_.nodes[static_cast<std::size_t>(parent)].children.push_back(
                static_cast<int>(model_.nodes.size()) - 1);
    }

    tinygltf::Model model_;
};

Result<void> make(char** arguments) {
    const auto mesh = readBaseMesh(arguments[1]);
    if (!mesh) return tl::unexpected(mesh.error());
    const auto bones = readRig(arguments[2], *mesh);
    if (!bones) return tl::unexpected(bones.error());
    const auto weights = readWeights(arguments[3], *mesh, *bones);
    if (!weights) return tl::unexpected(weights.error());
    const Body body = bodyOf(*mesh, *weights);
    if (body.positions.size() / 3 > 65535)
        return fail(arguments[1], "has more than 65,535 vertices in its body");
    Writer writer;
    writer.addBones(*bones);
    writer.addBody(body);
    const std::string bytes = writer.bytes();
    if (bytes.empty()) return fail(arguments[4], "cannot be written");
    if (auto written = writeFile(arguments[4], bytes); !written) return written;
    fmt::print("{}: {} vertices, {} triangles, {} bones\n", arguments[4], body.positions.size() / 3,
               body.indices.size() / 3, bones->size());
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        fmt::print(stderr, "usage: deixis_make_humanoid BASE.obj RIG.json WEIGHTS.json OUT.glb\n");
        return 2;
    }
    try {
        const auto made = make(argv);
        if (made) return 0;
        fmt::print(stderr, "deixis_make_humanoid: {}\n", made.error().text());
    } catch (const std::exception& error) {  // JSON of another shape than MPFB's
        fmt::print(stderr, "deixis_make_humanoid: {}\n", error.what());
    }
    return 1;
}
