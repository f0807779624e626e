// Makes Deixis's own avatar: deixis_make_avatar OUT.glb
//
// A distance field of rounded bodies is turned into one closed mesh, simplified, painted, bound to
// motion::referenceHumanoid() and written as glTF 2.0 binary. No clock, no randomness, no function whose
// result differs between compilers beyond what the rounding of the output hides: the same bytes everywhere.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "core/files.hpp"
#include "eye.hpp"
#include "figure_glb.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "paint.hpp"
#include "skin_weights.hpp"
#include "split.hpp"
#include "surface.hpp"

namespace {

using namespace deixis;
using namespace deixis::avatar_maker;

constexpr std::size_t triangle_target = 16000;

glm::vec3 rounded(const Vec3& v, double step) {
    return {static_cast<float>(std::floor(v.x / step + 0.5) * step),
            static_cast<float>(std::floor(v.y / step + 0.5) * step),
            static_cast<float>(std::floor(v.z / step + 0.5) * step)};
}
glm::vec3 roundedNormal(const Vec3& n) {
    const glm::vec3 coarse = rounded(n, 1e-4);
    return glm::vec3(glm::normalize(Vec3(coarse)));
}

/// Of each vertex, by the area of its triangles.
std::vector<Vec3> meanNormals(const Mesh& mesh) {
    std::vector<Vec3> normals(mesh.positions.size(), Vec3(0.0));
    for (const Triangle& t : mesh.triangles) {
        const Vec3& p = mesh.positions[t[0]];
        const Vec3 cross = glm::cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p);
        for (const std::uint32_t v : t) normals[v] += cross;
    }
    for (Vec3& normal : normals) normal = glm::normalize(normal);
    return normals;
}

bool nearEye(const Vec3& p) {
    return std::abs(std::abs(p.x) - 0.031) < 0.028 && std::abs(p.y - 1.622) < 0.018 && p.z > 0.05;
}

/// Thin patches of colour need small triangles: the mouth and the brows; and so does the bend of the lids.
double longestEdge(const Vec3& p) {
    const double x = std::abs(p.x);
    const bool collar = x < 0.08 && p.y > 1.435 && p.y < 1.488;
    const bool mouth = x < 0.028 && p.y > 1.540 && p.y < 1.562 && p.z > 0.06;
    const bool brow = x > 0.01 && x < 0.054 && p.y > 1.646 && p.y < 1.664 && p.z > 0.055;
    if (collar) return 0.0065;
    if (mouth) return 0.0012;
    if (nearEye(p) || (x < 0.034 && p.y > 1.534 && p.y < 1.568 && p.z > 0.06)) return 0.0032;
    return brow ? 0.0022 : 1.0;
}

std::vector<assets::FigureJoint> joints() {
    const motion::Skeleton& skeleton = motion::referenceHumanoid();
    const auto world = motion::worldPose(skeleton, motion::restPose(skeleton));
    std::vector<assets::FigureJoint> joints;
    for (std::size_t j = 0; j < world.size(); ++j) {
        const motion::Joint& joint = skeleton.joints[j];
        joints.push_back({joint.name, joint.parent, joint.rest.position, world[j].position, joint.end_site});
    }
    return joints;
}

/// Vertices and triangles as they are written: a place where two colours meet has a vertex for each.
class Output {
  public:
    void addBody(const PaintedMesh& body) {
        const std::vector<Vec3> mean = meanNormals(body.mesh);
        std::vector<std::set<Material>> materials_at(mean.size());
        for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t)
            for (const std::uint32_t v : body.mesh.triangles[t]) materials_at[v].insert(body.materials[t]);
        std::map<std::pair<std::uint32_t, Material>, std::uint32_t> index_of;
        for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t)
            for (const std::uint32_t v : body.mesh.triangles[t]) {
                const Material material = body.materials[t];
                const auto [at, is_new] = index_of.try_emplace({v, material}, size());
                if (is_new) {
                    const Vec3& p = body.mesh.positions[v];
                    // Where two materials meet, each keeps its own direction: the crease stays sharp. So does
                    // the skin at the eyes, whose opening is not to be seen.
                    const bool on_border = materials_at[v].size() > 1 || nearEye(p);
                    const Vec3 exact =
                        on_border
                            ? fieldNormal([&](const Vec3& q) { return materialDistance(q, material); }, p)
                            : surfaceNormal(p);
                    addVertex(p, glm::dot(mean[v], exact) > (on_border ? 0.2 : 0.75) ? exact : mean[v],
                              materialColour(material), skinWeightsAt(p));
                }
                indices_.push_back(at->second);
            }
    }

    /// A part about `centre` that follows one bone.
    void addEyePart(const EyePart& part, const Vec3& centre, motion::Bone bone) {
        SkinWeights weights;
        weights.joints[0] = static_cast<std::uint8_t>(bone);
        weights.weights[0] = 1.0F;
        const std::vector<Vec3> normals = meanNormals(part.mesh);
        std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> index_of;
        for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t)
            for (const std::uint32_t v : part.mesh.triangles[t]) {
                const glm::vec3& colour = part.colours[t];
                const auto [at, is_new] = index_of.try_emplace({v, colour.r, colour.g, colour.b}, size());
                const Vec3& p = part.mesh.positions[v];
                if (is_new) addVertex(centre + p, normals[v], colour, weights);
                indices_.push_back(at->second);
            }
    }

    [[nodiscard]] const assets::FigureVertices& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

  private:
    [[nodiscard]] std::uint32_t size() const {
        return static_cast<std::uint32_t>(vertices_.positions.size() / 3);
    }

    void addVertex(const Vec3& p, const Vec3& normal, const glm::vec3& colour, const SkinWeights& weights) {
        const auto append = [](std::vector<float>& to, const glm::vec3& v) {
            to.insert(to.end(), {v.x, v.y, v.z});
        };
        append(vertices_.positions, rounded(p, 1e-5));
        append(vertices_.normals, roundedNormal(normal));
        append(vertices_.colours, colour);
        vertices_.joints.insert(vertices_.joints.end(), weights.joints.begin(), weights.joints.end());
        vertices_.weights.insert(vertices_.weights.end(), weights.weights.begin(), weights.weights.end());
    }

    assets::FigureVertices vertices_;
    std::vector<std::uint32_t> indices_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: deixis_make_avatar OUT.glb\n");
        return 2;
    }
    Mesh surface = extractSurface();
    simplify(surface, triangle_target);
    refine(surface, longestEdge);
    const PaintedMesh body = paint(std::move(surface));
    if (!isClosed(body.mesh.triangles)) {
        fmt::print(stderr, "deixis_make_avatar: the mesh is not closed\n");
        return 1;
    }
    Output output;
    output.addBody(body);
    const auto figure_joints = joints();
    const EyePart lids = makeLids();
    for (const motion::Bone bone : {motion::Bone::leftEye, motion::Bone::rightEye}) {
        const Vec3 centre = figure_joints[static_cast<std::size_t>(bone)].position;
        output.addEyePart(makeEyeball(), centre, bone);
        output.addEyePart(bone == motion::Bone::leftEye ? lids : mirrored(lids), centre, motion::Bone::head);
    }
    const auto material = assets::GltfJson::parse(
        R"({"name":"body","pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.8}})");
    const auto written = writeFile(argv[1], assets::figureGlb("deixis_make_avatar", figure_joints,
                                                              output.vertices(), output.indices(), material));
    if (!written) {
        fmt::print(stderr, "deixis_make_avatar: {}\n", written.error().text());
        return 1;
    }
    fmt::print("{}: {} vertices, {} triangles\n", argv[1], output.vertices().positions.size() / 3,
               output.indices().size() / 3);
    return 0;
}
