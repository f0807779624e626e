#include "mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <set>

#include "materials.hpp"
#include "primitive.hpp"

namespace deixis::assets {

namespace {

constexpr std::size_t max_vertices = 4'000'000;
constexpr double same_place =
    3e-6;  ///< of the mesh's size: matrices that move no vertex apart by more are the same

/// How the vertices of one mesh are bound, in the file's rest pose: one matrix for each joint of its skin
/// that a vertex follows; avatar axes from mesh.
struct Binding {
    std::vector<glm::dmat4> rest_from_mesh;
    std::vector<int> joints;  ///< of the rig
};

/// The corners of a box: if two matrices agree on them, they agree within.
std::vector<Vec3> boxCorners(const std::vector<glm::vec3>& positions) {
    Vec3 low(positions.front());
    Vec3 high = low;
    for (const glm::vec3& p : positions) {
        low = glm::min(low, Vec3(p));
        high = glm::max(high, Vec3(p));
    }
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z);
    return corners;
}

bool agree(const glm::dmat4& a, const glm::dmat4& b, const std::vector<Vec3>& corners) {
    const double size = glm::length(transformed(a, corners.back()) - transformed(a, corners.front()));
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
        return glm::length(transformed(a, p) - transformed(b, p)) < same_place * std::max(size, 1.0);
    });
}

glm::dmat4 matrixOf(const Pose& pose) {
    glm::dmat4 matrix = glm::mat4_cast(pose.orientation);
    matrix[3] = glm::dvec4(pose.position, 1.0);
    return matrix;
}

glm::vec3 unit(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0F, 1.0F, 0.0F);
}

/// What takes normals where the matrix takes points.
glm::dmat3 normalMatrix(const glm::dmat4& matrix) {
    const glm::dmat3 m(matrix);
    return std::abs(glm::determinant(m)) > 1e-30 ? glm::transpose(glm::inverse(m)) : m;
}

class FigureReader {
  public:
    FigureReader(const gltf::Document& document, const gltf::Values& values, const NodeTree& tree,
                 const Rig& rig, std::vector<std::string>& remarks)
        : doc_(document),
          values_(values),
          rig_(rig),
          tree_(tree),
          remarks_(remarks),
          materials_(document, values, remarks),
          avatar_from_file_(glm::mat4_cast(rig.avatar_from_file)) {}

    FigureMesh run() {
        for (std::size_t node = 0; node < doc_.nodes.size(); ++node)
            if (tree_.drawn[node] && doc_.nodes[node].mesh >= 0) readNode(node);
        const bool empty = std::all_of(out_.indices.begin(), out_.indices.end(),
                                       [](const auto& indices) { return indices.empty(); });
        if (empty)
            gltf::reject(doc_.file,
                         "no mesh with triangles follows the figure's joints, by a skin or as their child",
                         "Export the avatar with its mesh and its armature");
        out_.parts = materials_.parts();
        out_.indices.resize(out_.parts.size());
        out_.textures = materials_.takeTextures();
        for (const std::string& remark : once_) remarks_.push_back(remark);
        return std::move(out_);
    }

  private:
    void readNode(std::size_t node) {
        const gltf::Node& n = doc_.nodes[node];
        const gltf::Mesh& mesh = doc_.meshes[static_cast<std::size_t>(n.mesh)];
        Binding binding;
        if (n.skin >= 0) {
            binding = skinBinding(doc_.skins[static_cast<std::size_t>(n.skin)]);
        } else {
            const int joint = rig_.joint_of_node[node];
            if (!followsHips(joint)) {
                const int hips = rig_.humanoid[motion::Bone::hips];
                once_.insert(
                    fmt::format("the mesh of node \"{}\" is attached to no joint from \"{}\" (the hips) "
                                "downwards: left out. If another joint is the hips, say so in {}",
                                n.name, rig_.joints[static_cast<std::size_t>(hips)].name,
                                humanoidFileOf(doc_.file).filename().string()));
                return;
            }
            binding.joints = {joint};
            binding.rest_from_mesh = {avatar_from_file_ * tree_.world[node]};
        }
        std::optional<std::size_t> skin_joints;
        if (n.skin >= 0) skin_joints = binding.joints.size();
        for (const gltf::Primitive& primitive : mesh.primitives) {
            const MaterialLook look = materials_.look(primitive.material);
            const auto data = readPrimitive(doc_, values_, primitive, {skin_joints, look.uv_set});
            if (!data) {
                once_.insert(fmt::format("the mesh \"{}\" has points or lines: left out", mesh.name));
                continue;
            }
            if (out_.vertices.size() + data->positions.size() > max_vertices)
                gltf::reject(doc_.file, fmt::format("has more than {} vertices", max_vertices), "");
            if (!data->positions.empty()) add(*data, look, binding, mesh.name);
        }
    }

    [[nodiscard]] bool followsHips(int joint) const {
        const int hips = rig_.humanoid[motion::Bone::hips];
        while (joint >= 0 && joint != hips) joint = rig_.joints[static_cast<std::size_t>(joint)].parent;
        return joint >= 0;
    }

    /// rest_from_mesh of each joint of a skin: its place in the scene after its inverse bind matrix (glTF
    /// 2.0, 3.7.3.3). The place of the node with the mesh does not matter.
    [[nodiscard]] Binding skinBinding(const gltf::Skin& skin) const {
        if (skin.joints.empty()) gltf::reject(doc_.file, "the skin has no joints");
        Binding binding;
        std::vector<double> inverse;
        if (skin.inverse_bind >= 0) {
            inverse = values_.numbers(skin.inverse_bind, "inverseBindMatrices");
            const bool matrices = doc_.accessorWidth(skin.inverse_bind) == 16;
            if (!matrices || inverse.size() < 16 * skin.joints.size())
                gltf::reject(doc_.file,
                             fmt::format("{} inverse bind matrices, expected one for each of {} joints",
                                         matrices ? inverse.size() / 16 : 0, skin.joints.size()));
        }
        for (std::size_t j = 0; j < skin.joints.size(); ++j) {
            const auto node = static_cast<std::size_t>(skin.joints[j]);
            glm::dmat4 rest = avatar_from_file_ * tree_.world[node];
            if (!inverse.empty()) rest *= glm::make_mat4(&inverse[16 * j]);
            binding.rest_from_mesh.push_back(rest);
            binding.joints.push_back(rig_.joint_of_node[node]);
        }
        return binding;
    }

    /// The slot of a joint in which the file's rest pose is `rest_from_bind`.
    std::uint16_t slot(int joint, const Pose& rest_from_bind, const std::vector<Vec3>& corners) {
        for (const std::size_t known : slots_of_joint_[joint]) {
            if (agree(matrixOf(out_.slots[known].rest_from_bind), matrixOf(rest_from_bind), corners))
                return static_cast<std::uint16_t>(known);
        }
        out_.slots.push_back({joint, rest_from_bind});
        slots_of_joint_[joint].push_back(out_.slots.size() - 1);
        return static_cast<std::uint16_t>(out_.slots.size() - 1);
    }

    void add(const PrimitiveData& data, const MaterialLook& look, const Binding& binding,
             const std::string& mesh_name) {
        if (data.more_than_four)
            once_.insert("vertices that follow more than 4 joints keep the 4 with the largest weights");
        if (data.unweighted) once_.insert("vertices without weights follow the first joint of their skin");
        const auto first = static_cast<std::uint32_t>(out_.vertices.size());
        for (std::size_t v = 0; v < data.positions.size(); ++v) {
            SkinnedVertex vertex;
            vertex.position = data.positions[v];
            vertex.normal = data.normals[v];
            vertex.colour = look.factor * (data.colours.empty() ? glm::vec3(1.0F) : data.colours[v]);
            if (!data.uvs.empty()) vertex.uv = look.placed(data.uvs[v]);
            out_.vertices.push_back(vertex);
        }
        const bool mirrored = bind(data, binding, first, mesh_name);
        if (out_.indices.size() <= look.part) out_.indices.resize(look.part + 1);
        for (std::size_t t = 0; t + 2 < data.triangles.size(); t += 3)
            for (const std::size_t corner :
                 mirrored ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2})
                out_.indices[look.part].push_back(first + data.triangles[t + corner]);
    }

    /// Gives the vertices from `first` on their joints and weights, and moves them to the bind pose. Whether
    /// the mesh is mirrored by it.
    bool bind(const PrimitiveData& data, const Binding& binding, std::uint32_t first,
              const std::string& mesh_name) {
        std::set<std::uint32_t> used;
        for (const auto& influences : data.influences)
            for (const auto& influence : influences) used.insert(influence.first);
        if (data.influences.empty()) used.insert(0U);
        const std::vector<Vec3> corners = boxCorners(data.positions);
        std::map<std::uint32_t, std::uint16_t> slot_of;

        // 1. All joints hold the mesh in one way, that is the mesh was bound in the file's rest pose.
        glm::dmat4 common = binding.rest_from_mesh[*used.begin()];
        if (agree(common, glm::dmat4(1.0), corners)) common = glm::dmat4(1.0);
        const bool one_way = std::all_of(used.begin(), used.end(), [&](std::uint32_t j) {
            return agree(binding.rest_from_mesh[j], common, corners);
        });
        if (one_way) {
            moveAll(data, common, first);
            for (const std::uint32_t j : used) slot_of[j] = slot(binding.joints[j], {}, corners);
            setJoints(data, slot_of, first);
            return glm::determinant(glm::dmat3(common)) < 0.0;
        }

        // 2. Each joint turns and moves it in its own way, all with one scale, which goes to the vertices.
        std::map<std::uint32_t, Similarity> ways;
        bool alike = true;
        for (const std::uint32_t j : used) alike = alike && similarity(binding.rest_from_mesh[j], ways[j]);
        const double scale = ways.begin()->second.scale;
        for (const auto& [j, way] : ways) alike = alike && std::abs(way.scale / scale - 1.0) < 1e-4;
        if (alike) {
            glm::dmat4 scaled(scale);
            scaled[3][3] = 1.0;
            moveAll(data, scaled, first);
            std::vector<Vec3> grown = corners;
            for (Vec3& corner : grown) corner *= scale;
            for (const auto& [j, way] : ways) slot_of[j] = slot(binding.joints[j], way.pose, grown);
            setJoints(data, slot_of, first);
            return false;
        }

        // 3. Otherwise the mesh is set into the rest pose for good. What the joints' different scales would
        // do to it in other poses is lost.
        once_.insert(fmt::format(
            "joints scale or shear the mesh \"{}\" differently: it was fixed in the rest pose", mesh_name));
        for (std::size_t v = 0; v < data.positions.size(); ++v) {
            glm::dmat4 blended(0.0);
            for (const auto& [j, weight] : influencesOf(data, v))
                blended += static_cast<double>(weight) * binding.rest_from_mesh[j];
            move(out_.vertices[first + v], blended, normalMatrix(blended));
        }
        for (const std::uint32_t j : used) slot_of[j] = slot(binding.joints[j], {}, corners);
        setJoints(data, slot_of, first);
        return glm::determinant(glm::dmat3(common)) < 0.0;
    }

    static std::vector<std::pair<std::uint32_t, float>> influencesOf(const PrimitiveData& data,
                                                                     std::size_t v) {
        if (data.influences.empty()) return {{0U, 1.0F}};
        return data.influences[v];
    }

    static void move(SkinnedVertex& vertex, const glm::dmat4& matrix, const glm::dmat3& normal_matrix) {
        vertex.position = glm::vec3(transformed(matrix, Vec3(vertex.position)));
        vertex.normal = unit(normal_matrix * Vec3(vertex.normal));
    }

    void moveAll(const PrimitiveData& data, const glm::dmat4& matrix, std::uint32_t first) {
        if (matrix == glm::dmat4(1.0)) return;
        const glm::dmat3 normals = normalMatrix(matrix);
        for (std::size_t v = 0; v < data.positions.size(); ++v)
            move(out_.vertices[first + v], matrix, normals);
    }

    void setJoints(const PrimitiveData& data, const std::map<std::uint32_t, std::uint16_t>& slot_of,
                   std::uint32_t first) {
        for (std::size_t v = 0; v < data.positions.size(); ++v) {
            std::size_t i = 0;
            for (const auto& [j, weight] : influencesOf(data, v)) {
                out_.vertices[first + v].joints[i] = slot_of.at(j);
                out_.vertices[first + v].weights[i++] = weight;
            }
            // Unused places name a joint that is there.
            for (; i < 4; ++i) out_.vertices[first + v].joints[i] = out_.vertices[first + v].joints[0];
        }
    }

    const gltf::Document& doc_;
    const gltf::Values& values_;
    const Rig& rig_;
    const NodeTree& tree_;
    std::vector<std::string>& remarks_;
    MaterialReader materials_;
    glm::dmat4 avatar_from_file_;
    std::map<int, std::vector<std::size_t>> slots_of_joint_;
    std::set<std::string> once_;  ///< remarks that stand once however often they apply
    FigureMesh out_;
};

}  // namespace

FigureMesh readFigureMesh(const gltf::Document& document, const gltf::Values& values, const NodeTree& tree,
                          const Rig& rig, std::vector<std::string>& remarks) {
    return FigureReader(document, values, tree, rig, remarks).run();
}

}  // namespace deixis::assets
