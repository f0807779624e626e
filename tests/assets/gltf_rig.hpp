// Small humanoid glTF files made by hand, and skinning as the glTF specification has it: matrices down the
// tree of nodes, times inverse bind matrices, weighted. Written from glTF 2.0, 3.5 and 3.7.3; it shares
// nothing with the reader.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

namespace deixis::tests {

/// What makes a file differ from the plain one: motion::referenceHumanoid() in the T pose, no rotations.
struct RigOptions {
    double armature_scale = 1.0;
    bool z_up_armature = false;    ///< bones in z-up axes under a turned armature, as Blender's exporters do
    bool rest_rotations = false;   ///< every joint has axes of its own
    double arms_down_deg = 0.0;    ///< A pose
    bool matrices = false;         ///< nodes with matrices instead of translation, rotation and scale
    bool shuffled = false;         ///< joints of the skin in another order than the tree's
    bool short_joints = false;     ///< JOINTS_0 as u16, WEIGHTS_0 as normalised u16
    bool faces_back = false;       ///< along -z, as VRM 0.x does
    double mesh_unit = 1.0;        ///< metres in the unit of the mesh
    bool bound_in_t_pose = false;  ///< though the rest pose is another
    bool feet_on_root = false;     ///< feet hang on the armature
    bool sparse = false;           ///< every accessor is sparse
    std::function<std::string(const std::string&)> rename = [](const std::string& name) { return name; };
};

struct Rig {
    std::vector<std::string> names;        ///< of the bones, nodes 1...; node 0 is the armature
    std::vector<int> parent;               ///< of each node
    std::vector<glm::dmat4> rest_local;    ///< of each node
    std::vector<glm::dmat4> t_world;       ///< of each node in the T pose, as the file has its axes
    std::vector<glm::dmat4> inverse_bind;  ///< of each bone
    std::vector<int> skin_joints;          ///< nodes, in the skin's order
    std::vector<Vec3> vertices;            ///< in the mesh's unit
    std::vector<std::vector<std::pair<int, double>>> weights;  ///< by bone
    glm::dmat4 avatar_from_file{1.0};
};

inline Quat someRotation(Random& random) {
    const Vec3 axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    return glm::angleAxis(random.uniform(-3.0, 3.0), glm::normalize(axis + Vec3(0.0, 0.0, 1e-3)));
}

inline Rig makeRig(const RigOptions& options, std::uint64_t seed = 7) {
    const motion::Skeleton& reference = motion::referenceHumanoid();
    const auto t_pose = motion::worldPose(reference, motion::restPose(reference));
    Random random(seed);
    Rig rig;
    const std::size_t bones = t_pose.size();
    const Quat facing = options.faces_back ? Quat(0.0, 0.0, 1.0, 0.0) : no_rotation;
    rig.avatar_from_file = glm::mat4_cast(glm::conjugate(facing));

    glm::dmat4 armature = glm::mat4_cast(facing);
    if (options.z_up_armature) armature = glm::rotate(armature, -pi / 2, Vec3(1, 0, 0));
    armature = glm::scale(armature, Vec3(options.armature_scale));
    rig.parent.push_back(-1);
    rig.t_world.push_back(armature);
    std::vector<glm::dmat4> rest_world{armature};
    const glm::dmat4 turned_axes = glm::mat4_cast(facing);
    for (std::size_t b = 0; b < bones; ++b) {
        const motion::Joint& joint = reference.joints[b];
        rig.names.push_back(joint.name);
        const bool foot = joint.name == "leftFoot" || joint.name == "rightFoot";
        rig.parent.push_back(options.feet_on_root && foot ? 0 : joint.parent + 1);
        glm::dmat4 world = turned_axes * glm::translate(glm::dmat4(1.0), t_pose[b].position);
        if (options.rest_rotations) world *= glm::mat4_cast(someRotation(random));
        world = glm::scale(world, Vec3(options.armature_scale));
        rig.t_world.push_back(world);
        // Which bend the rest pose has: that of the upper arm at or above the bone.
        glm::dmat4 bend(1.0);
        for (int at = static_cast<int>(b); at >= 0;
             at = reference.joints[static_cast<std::size_t>(at)].parent) {
            const std::string& name = reference.joints[static_cast<std::size_t>(at)].name;
            if (name != "leftUpperArm" && name != "rightUpperArm") continue;
            const double angle = radiansFromDegrees(options.arms_down_deg) * (name[0] == 'l' ? -1.0 : 1.0);
            const Vec3 pivot = t_pose[static_cast<std::size_t>(at)].position;
            bend = glm::translate(glm::dmat4(1.0), pivot) *
                   glm::rotate(glm::dmat4(1.0), angle, Vec3(0, 0, 1)) *
                   glm::translate(glm::dmat4(1.0), -pivot);
        }
        rest_world.push_back(turned_axes * bend * glm::inverse(turned_axes) * world);
    }
    for (std::size_t n = 0; n < rest_world.size(); ++n) {
        const int parent = rig.parent[n];
        rig.rest_local.push_back(parent < 0 ? rest_world[n]
                                            : glm::inverse(rest_world[static_cast<std::size_t>(parent)]) *
                                                  rest_world[n]);
    }
    const auto& bound = options.bound_in_t_pose ? rig.t_world : rest_world;
    const glm::dmat4 world_from_mesh = glm::scale(glm::dmat4(1.0), Vec3(options.mesh_unit));
    for (std::size_t b = 0; b < bones; ++b)
        rig.inverse_bind.push_back(glm::inverse(bound[b + 1]) * world_from_mesh);
    for (std::size_t b = 0; b < bones; ++b) rig.skin_joints.push_back(static_cast<int>(b) + 1);
    if (options.shuffled) std::reverse(rig.skin_joints.begin(), rig.skin_joints.end());

    // A triangle at each bone, part of which follows the bone above; those of the toes touch the floor.
    for (std::size_t b = 0; b < bones; ++b)
        for (int corner = 0; corner < 3; ++corner) {
            Vec3 p = t_pose[b].position + 0.03 * Vec3(corner == 0, corner == 1, corner == 2);
            if (rig.names[b].find("Toes") != std::string::npos && corner == 0) p.y = 0.0;
            const glm::dmat4 bind_from_t = bound[b + 1] * glm::inverse(rig.t_world[b + 1]) * turned_axes;
            rig.vertices.emplace_back(glm::inverse(world_from_mesh) * bind_from_t * glm::dvec4(p, 1.0));
            const int above = reference.joints[b].parent;
            if (above >= 0 && corner == 2)
                rig.weights.push_back({{static_cast<int>(b), 0.75}, {above, 0.25}});
            else
                rig.weights.push_back({{static_cast<int>(b), 1.0}});
        }
    return rig;
}

/// The vertices, given each node's world matrix, in the avatar's axes.
inline std::vector<Vec3> skinnedBySpecification(const Rig& rig, const std::vector<glm::dmat4>& world) {
    std::vector<Vec3> out;
    for (std::size_t v = 0; v < rig.vertices.size(); ++v) {
        glm::dvec4 sum(0.0);
        for (const auto& [bone, weight] : rig.weights[v])
            sum += weight *
                   (world[static_cast<std::size_t>(bone) + 1] *
                    rig.inverse_bind[static_cast<std::size_t>(bone)] * glm::dvec4(rig.vertices[v], 1.0));
        out.emplace_back(rig.avatar_from_file * sum);
    }
    return out;
}

/// World matrices of the nodes where each bone is turned (in avatar axes, after its T pose) by `turn`, with
/// all that hangs on it; by going down the tree from node to node.
inline std::vector<glm::dmat4> posed(const Rig& rig, const std::vector<Quat>& turn) {
    const glm::dmat4 avatar_from_file = rig.avatar_from_file;
    const glm::dmat4 file_from_avatar = glm::inverse(avatar_from_file);
    const motion::Skeleton& reference = motion::referenceHumanoid();
    std::vector<glm::dmat4> moved(turn.size());
    std::vector<glm::dmat4> world{rig.t_world[0]};
    for (std::size_t b = 0; b < turn.size(); ++b) {
        const Vec3 pivot(avatar_from_file * rig.t_world[b + 1][3]);
        const glm::dmat4 own = glm::translate(glm::dmat4(1.0), pivot) * glm::mat4_cast(turn[b]) *
                               glm::translate(glm::dmat4(1.0), -pivot);
        const int above = reference.joints[b].parent;
        moved[b] = above < 0 ? own : moved[static_cast<std::size_t>(above)] * own;
        world.push_back(file_from_avatar * moved[b] * avatar_from_file * rig.t_world[b + 1]);
    }
    return world;
}

/// A glTF binary, put together from JSON text and bytes.
class GlbText {
  public:
    template <typename T>
    int accessor(const std::vector<T>& values, int component_type, const std::string& type, std::size_t count,
                 const std::string& members = {}) {
        const std::string shape = fmt::format(R"("componentType":{},"count":{},"type":"{}"{})",
                                              component_type, count, type, members);
        return sparse ? sparseAccessor(values, shape, count, type != "MAT4")
                      : accessor(fmt::format(R"("bufferView":{},{})", view(values), shape));
    }
    int accessor(const std::string& members) {
        accessors_.push_back("{" + members + "}");
        return static_cast<int>(accessors_.size()) - 1;
    }
    template <typename T>
    int view(const std::vector<T>& values, const std::string& members = {}) {
        while (bytes_.size() % 4 != 0) bytes_.push_back('\0');
        const std::size_t offset = bytes_.size();
        bytes_.resize(offset + values.size() * sizeof(T));
        std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
        views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset,
                                     values.size() * sizeof(T), members));
        return static_cast<int>(views_.size()) - 1;
    }

    bool sparse = false;  ///< of accessors that are added from then on
    std::vector<std::string> nodes, meshes, skins;
    std::string more;  ///< further members of the root, each with a comma before it

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    /// `uri` is empty in a binary.
    [[nodiscard]] std::string json(const std::string& uri = {}) const {
        const std::string source = uri.empty() ? "" : fmt::format(R"(,"uri":"{}")", uri);
        return fmt::format(
            R"({{"asset":{{"version":"2.0"}},"nodes":[{}],"meshes":[{}],"skins":[{}],"accessors":[{}],)"
            R"("bufferViews":[{}],"buffers":[{{"byteLength":{}{}}}]{}}})",
            fmt::join(nodes, ","), fmt::join(meshes, ","), fmt::join(skins, ","), fmt::join(accessors_, ","),
            fmt::join(views_, ","), bytes_.size(), source, more);
    }
    [[nodiscard]] std::string glb() const {
        std::string text = json();
        std::string data = bytes_;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4, '\0');
        std::string out = "glTF";
        const auto add = [&](std::size_t number) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                out.push_back(static_cast<char>(number >> shift & 0xFFU));
        };
        add(2);
        add(28 + text.size() + data.size());
        add(text.size());
        add(0x4E4F534A);
        out += text;
        add(data.size());
        add(0x004E4942);
        return out + data;
    }

  private:
    /// As glTF 2.0, section 3.6.2.3 has them: every third element is wrong below and replaced; without
    /// values below, all of them are. Indices of all three types in turn.
    template <typename T>
    int sparseAccessor(std::vector<T> values, const std::string& shape, std::size_t count, bool with_base) {
        const std::size_t width = values.size() / count;
        std::vector<T> replacing;
        std::vector<std::uint32_t> indices;
        for (std::size_t i = with_base ? 1 : 0; i < count; i += with_base ? 3 : 1) {
            const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * width);
            const auto last = first + static_cast<std::ptrdiff_t>(width);
            replacing.insert(replacing.end(), first, last);
            std::fill(first, last, T{7});
            indices.push_back(static_cast<std::uint32_t>(i));
        }
        const std::string base = with_base ? fmt::format(R"("bufferView":{},)", view(values)) : "";
        const int turn = static_cast<int>(accessors_.size() % 3);
        const int index_view = turn == 0   ? view(std::vector<std::uint8_t>(indices.begin(), indices.end()))
                               : turn == 1 ? view(std::vector<std::uint16_t>(indices.begin(), indices.end()))
                                           : view(indices);
        return accessor(fmt::format(
            R"({}{},"sparse":{{"count":{},"indices":{{"bufferView":{},"componentType":{}}},"values":{{"bufferView":{}}}}})",
            base, shape, indices.size(), index_view,
            std::array{5121, 5123, 5125}[static_cast<std::size_t>(turn)], view(replacing)));
    }

    std::string bytes_;
    std::vector<std::string> views_, accessors_;
};

inline std::string matrixJson(const glm::dmat4& m) {
    std::vector<double> values;
    for (int i = 0; i < 16; ++i) values.push_back(m[i / 4][i % 4]);
    return fmt::format("{:.17g}", fmt::join(values, ","));
}

/// The nodes of a rig: armature and bones.
inline void addNodes(GlbText& file, const Rig& rig, const RigOptions& options) {
    for (std::size_t n = 0; n < rig.parent.size(); ++n) {
        std::vector<std::size_t> children;
        for (std::size_t c = 0; c < rig.parent.size(); ++c)
            if (rig.parent[c] == static_cast<int>(n)) children.push_back(c);
        std::string node =
            fmt::format(R"({{"name":"{}")", n == 0 ? "Armature" : options.rename(rig.names[n - 1]));
        if (!children.empty()) node += fmt::format(R"(,"children":[{}])", fmt::join(children, ","));
        const glm::dmat4& m = rig.rest_local[n];
        if (options.matrices) {
            node += fmt::format(R"(,"matrix":[{}])", matrixJson(m));
        } else {
            const Vec3 scale(glm::length(Vec3(m[0])), glm::length(Vec3(m[1])), glm::length(Vec3(m[2])));
            const Quat q = glm::normalize(
                glm::quat_cast(glm::dmat3(Vec3(m[0]) / scale.x, Vec3(m[1]) / scale.y, Vec3(m[2]) / scale.z)));
            node += fmt::format(
                R"(,"translation":[{:.17g},{:.17g},{:.17g}],"rotation":[{:.17g},{:.17g},{:.17g},{:.17g}],)"
                R"("scale":[{:.17g},{:.17g},{:.17g}])",
                m[3].x, m[3].y, m[3].z, q.x, q.y, q.z, q.w, scale.x, scale.y, scale.z);
        }
        file.nodes.push_back(node + "}");
    }
}

/// Adds the rig's mesh, one triangle a bone without indices, with its skin and a node that shows it.
inline void addMesh(GlbText& file, const Rig& rig, const RigOptions& options,
                    const std::string& material = {}) {
    constexpr int type_u8 = 5121, type_u16 = 5123, type_float = 5126;
    std::vector<int> place(rig.parent.size(), 0);  // of each node in the skin
    for (std::size_t j = 0; j < rig.skin_joints.size(); ++j)
        place[static_cast<std::size_t>(rig.skin_joints[j])] = static_cast<int>(j);
    std::vector<float> positions, weights, matrices;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint16_t> short_joints, short_weights;
    for (std::size_t v = 0; v < rig.vertices.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(rig.vertices[v][axis]));
        for (std::size_t k = 0; k < 4; ++k) {
            const bool there = k < rig.weights[v].size();
            const auto joint = there ? place[static_cast<std::size_t>(rig.weights[v][k].first) + 1] : 0;
            const double weight = there ? rig.weights[v][k].second : 0.0;
            joints.push_back(static_cast<std::uint8_t>(joint));
            short_joints.push_back(static_cast<std::uint16_t>(joint));
            weights.push_back(static_cast<float>(weight));
            short_weights.push_back(static_cast<std::uint16_t>(weight * 65535.0 + 0.5));
        }
    }
    for (const int node : rig.skin_joints)
        for (int i = 0; i < 16; ++i)
            matrices.push_back(
                static_cast<float>(rig.inverse_bind[static_cast<std::size_t>(node) - 1][i / 4][i % 4]));
    const std::size_t count = rig.vertices.size();
    const int position = file.accessor(positions, type_float, "VEC3", count);
    const int joint = options.short_joints ? file.accessor(short_joints, type_u16, "VEC4", count)
                                           : file.accessor(joints, type_u8, "VEC4", count);
    const int weight = options.short_joints
                           ? file.accessor(short_weights, type_u16, "VEC4", count, R"(,"normalized":true)")
                           : file.accessor(weights, type_float, "VEC4", count);
    const int inverse = file.accessor(matrices, type_float, "MAT4", rig.skin_joints.size());
    file.meshes.push_back(fmt::format(
        R"({{"name":"body","primitives":[{{"attributes":{{"POSITION":{},"JOINTS_0":{},"WEIGHTS_0":{}}}{}}}]}})",
        position, joint, weight, material));
    file.skins.push_back(fmt::format(R"({{"inverseBindMatrices":{},"joints":[{}]}})", inverse,
                                     fmt::join(rig.skin_joints, ",")));
    // Where the node of a skinned mesh stands does not matter.
    file.nodes.push_back(fmt::format(R"({{"name":"shown","mesh":{},"skin":{},"translation":[5,6,7]}})",
                                     file.meshes.size() - 1, file.skins.size() - 1));
}

inline GlbText rigFile(const Rig& rig, const RigOptions& options) {
    GlbText file;
    file.sparse = options.sparse;
    addNodes(file, rig, options);
    addMesh(file, rig, options);
    return file;
}

}  // namespace deixis::tests
