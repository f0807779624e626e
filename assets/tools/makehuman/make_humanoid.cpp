// MakeHuman's base mesh with one of MPFB's rigs as glTF 2.0 binary:
// deixis_make_humanoid BASE.obj RIG.json WEIGHTS.json OUT.glb
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <glm/geometric.hpp>

#include "../figure_glb.hpp"
#include "base_mesh.hpp"
#include "core/files.hpp"

namespace {

using namespace deixis;
using namespace deixis::humanoid_maker;

/// What the file holds of the mesh: the vertices of the body alone.
struct Body {
    assets::FigureVertices vertices;
    std::vector<std::uint32_t> indices;
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
                    body.vertices.positions.push_back(static_cast<float>(mesh.vertices[v][axis]));
                    body.vertices.normals.push_back(normal[axis]);
                }
                body.vertices.weights.insert(body.vertices.weights.end(), weights[v].weights.begin(),
                                             weights[v].weights.end());
                body.vertices.joints.insert(body.vertices.joints.end(), weights[v].bones.begin(),
                                            weights[v].bones.end());
            }
            body.indices.push_back(static_cast<std::uint32_t>(place[v]));
        }
    return body;
}

/// The bones, each with a tip where none hangs on it.
std::vector<assets::FigureJoint> jointsOf(const std::vector<RigBone>& bones) {
    std::vector<assets::FigureJoint> joints;
    for (const RigBone& bone : bones) {
        const Vec3 above = bone.parent < 0 ? Vec3(0.0) : bones[static_cast<std::size_t>(bone.parent)].head;
        joints.push_back({bone.name, bone.parent, bone.head - above, bone.head, bone.tail - bone.head});
    }
    for (const RigBone& bone : bones)
        if (bone.parent >= 0) joints[static_cast<std::size_t>(bone.parent)].tip.reset();
    return joints;
}

Result<void> make(char** arguments) {
    const auto mesh = readBaseMesh(arguments[1]);
    if (!mesh) return tl::unexpected(mesh.error());
    const auto bones = readRig(arguments[2], *mesh);
    if (!bones) return tl::unexpected(bones.error());
    const auto weights = readWeights(arguments[3], *mesh, *bones);
    if (!weights) return tl::unexpected(weights.error());
    const Body body = bodyOf(*mesh, *weights);
    const auto material = assets::GltfJson::parse(
        R"({"name":"skin","pbrMetallicRoughness":)"
        R"({"baseColorFactor":[0.60,0.36,0.25,1.0],"metallicFactor":0.0,"roughnessFactor":0.7}})");
    const std::string bytes =
        assets::figureGlb("deixis_make_humanoid", jointsOf(*bones), body.vertices, body.indices, material);
    if (auto written = writeFile(arguments[4], bytes); !written) return written;
    fmt::print("{}: {} vertices, {} triangles, {} bones\n", arguments[4], body.vertices.positions.size() / 3,
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
