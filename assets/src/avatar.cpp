#include "assets/avatar.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <set>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "gltf_accessor.hpp"

namespace deixis::assets {

namespace {

constexpr auto export_anew = "Export the file anew";

/// A rotation and translation from a column-major matrix; none where it scales, shears or mirrors.
std::optional<Pose> rigidPose(const std::array<double, 16>& m) {
    const glm::dmat3 rotation(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
    const glm::dmat3 product = glm::transpose(rotation) * rotation;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(product[c][r] - (c == r ? 1.0 : 0.0)) < 1e-3)) return std::nullopt;
    if (glm::determinant(rotation) < 0.0) return std::nullopt;
    Pose pose;
    pose.position = Vec3(m[12], m[13], m[14]);
    if (rotation != glm::dmat3(1.0)) pose.orientation = glm::normalize(glm::quat_cast(rotation));
    return pose;
}

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Reads one avatar; the members are what the steps hand on to each other.
class Reader {
  public:
    Reader(const tinygltf::Model& model, std::string file) : model_(model), file_(std::move(file)) {}

    Result<Avatar> run() {
        for (const auto step :
             {&Reader::findParents, &Reader::readSkeleton, &Reader::readBindPoses, &Reader::readMesh})
            if (auto done = (this->*step)(); !done) return tl::unexpected(done.error());
        return std::move(avatar_);
    }

  private:
    [[nodiscard]] auto bad(std::string message) const { return fail(file_, std::move(message), export_anew); }

    [[nodiscard]] bool nodeExists(int node) const {
        return node >= 0 && static_cast<std::size_t>(node) < model_.nodes.size();
    }
    [[nodiscard]] const tinygltf::Node& node(int index) const {
        return model_.nodes[static_cast<std::size_t>(index)];
    }

    Result<void> findParents() {
        parent_.assign(model_.nodes.size(), -1);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            for (const int child : model_.nodes[i].children) {
                if (!nodeExists(child))
                    return bad(fmt::format("node {} has a child {} that does not exist", i, child));
                int& parent = parent_[static_cast<std::size_t>(child)];
                if (parent >= 0) return bad(fmt::format("node {} has two parents", child));
                parent = static_cast<int>(i);
            }
        for (std::size_t i = 0; i < parent_.size(); ++i) {
            std::size_t steps = 0;
            for (int at = static_cast<int>(i); at >= 0; at = parent_[static_cast<std::size_t>(at)])
                if (++steps > parent_.size()) return bad("the nodes form a ring");
        }
        return {};
    }

    [[nodiscard]] Result<Pose> localPose(int index) const {
        const tinygltf::Node& n = node(index);
        const auto refuse = [&](const char* what) {
            return bad(fmt::format("node \"{}\" {}; bones may only turn and move", n.name, what));
        };
        for (const auto* values : {&n.translation, &n.rotation, &n.scale, &n.matrix})
            if (!finite(*values)) return refuse("holds a number that is not finite");
        if (n.matrix.size() == 16) {
            std::array<double, 16> m;
            std::copy(n.matrix.begin(), n.matrix.end(), m.begin());
            const auto pose = rigidPose(m);
            if (!pose) return refuse("scales or mirrors");
            return *pose;
        }
        for (const double s : n.scale)
            if (std::abs(s - 1.0) > 1e-4) return refuse("scales");
        Pose pose;
        if (n.translation.size() == 3)
            pose.position = Vec3(n.translation[0], n.translation[1], n.translation[2]);
        if (n.rotation.size() == 4) {
            const Quat q(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]);
            if (!(std::abs(glm::length(q) - 1.0) < 1e-2))
                return refuse("has a rotation that is not of unit length");
            pose.orientation = glm::normalize(q);
        }
        return pose;
    }

    /// The skin and the mesh that it bends: those of the first node that has both.
    Result<void> readSkeleton() {
        for (std::size_t i = 0; i < model_.nodes.size() && mesh_ < 0; ++i)
            if (model_.nodes[i].skin >= 0 && model_.nodes[i].mesh >= 0) {
                mesh_ = model_.nodes[i].mesh;
                skin_ = model_.nodes[i].skin;
            }
        if (mesh_ < 0)
            return fail(file_, "no node has a mesh and a skin, expected one skinned mesh",
                        "Export the avatar with its armature");
        if (static_cast<std::size_t>(mesh_) >= model_.meshes.size() ||
            static_cast<std::size_t>(skin_) >= model_.skins.size())
            return bad(fmt::format("mesh {} or skin {} does not exist", mesh_, skin_));
        const std::vector<int>& joints = model_.skins[static_cast<std::size_t>(skin_)].joints;
        if (joints.empty()) return bad("the skin has no joints");

        std::vector<int> skin_joint_of(model_.nodes.size(), -1);
        for (std::size_t j = 0; j < joints.size(); ++j) {
            if (!nodeExists(joints[j]))
                return bad(fmt::format("joint {} is node {}, which does not exist", j, joints[j]));
            int& slot = skin_joint_of[static_cast<std::size_t>(joints[j])];
            if (slot >= 0) return bad(fmt::format("node {} is a joint twice", joints[j]));
            slot = static_cast<int>(j);
        }
        const auto parentOf = [&](int n) { return parent_[static_cast<std::size_t>(n)]; };
        const auto depth = [&](int n) {
            int steps = 0;
            for (; n >= 0; n = parentOf(n)) ++steps;
            return steps;
        };
        const auto parentJoint = [&](int n) {
            for (n = parentOf(n); n >= 0; n = parentOf(n))
                if (skin_joint_of[static_cast<std::size_t>(n)] >= 0)
                    return skin_joint_of[static_cast<std::size_t>(n)];
            return -1;
        };
        // Parents must stand before children; the file's own order is kept where it does that.
        std::vector<std::size_t> order(joints.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        bool in_order = true;
        for (std::size_t j = 0; j < joints.size(); ++j)
            in_order = in_order && parentJoint(joints[j]) < static_cast<int>(j);
        if (!in_order)
            std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                return depth(joints[a]) < depth(joints[b]);
            });
        joint_of_skin_.resize(joints.size());
        for (std::size_t j = 0; j < order.size(); ++j) joint_of_skin_[order[j]] = static_cast<int>(j);

        std::set<std::string> names;
        for (const std::size_t from : order) {
            const int n = joints[from];
            motion::Joint joint;
            joint.name = node(n).name;
            if (!names.insert(joint.name).second || joint.name.empty())
                return bad(fmt::format("joint name \"{}\" is empty or used twice", joint.name));
            const int skin_parent = parentJoint(n);
            joint.parent = skin_parent < 0 ? -1 : joint_of_skin_[static_cast<std::size_t>(skin_parent)];
            // Nodes between two joints, or above the root, count as part of the lower joint's rest pose.
            for (int at = n; at >= 0; at = parentOf(at)) {
                if (at != n && skin_joint_of[static_cast<std::size_t>(at)] >= 0) break;
                const auto local = localPose(at);
                if (!local) return tl::unexpected(local.error());
                joint.rest = at == n ? *local : *local * joint.rest;
            }
            for (const int child : node(n).children)
                if (node(child).name == joint.name + "_end") {
                    const auto local = localPose(child);
                    if (!local) return tl::unexpected(local.error());
                    joint.end_site = local->position;
                }
            avatar_.skeleton.joints.push_back(std::move(joint));
        }
        if (avatar_.skeleton.joints.front().parent >= 0) return bad("the skin has no root joint");
        avatar_.humanoid = motion::mapByVrmNames(avatar_.skeleton);
        return {};
    }

    Result<void> readBindPoses() {
        avatar_.joint_from_bind.assign(avatar_.skeleton.joints.size(), Pose{});
        const int accessor = model_.skins[static_cast<std::size_t>(skin_)].inverseBindMatrices;
        if (accessor < 0) return {};
        const auto rows = readGltfRows(model_, accessor, file_, "inverseBindMatrices");
        if (!rows) return tl::unexpected(rows.error());
        if (rows->width != 16 || rows->size() < joint_of_skin_.size())
            return bad(fmt::format("{} inverse bind matrices, expected one for each of {} joints",
                                   rows->width == 16 ? rows->size() : 0, joint_of_skin_.size()));
        for (std::size_t j = 0; j < joint_of_skin_.size(); ++j) {
            std::array<double, 16> m;
            std::copy_n(rows->values.begin() + static_cast<std::ptrdiff_t>(j * 16), 16, m.begin());
            const auto pose = rigidPose(m);
            if (!pose)
                return bad(
                    fmt::format("inverse bind matrix {} scales or mirrors; bones may only turn and move", j));
            avatar_.joint_from_bind[static_cast<std::size_t>(joint_of_skin_[j])] = *pose;
        }
        return {};
    }

    Result<void> readMesh() {
        for (const auto& primitive : model_.meshes[static_cast<std::size_t>(mesh_)].primitives)
            if (auto done = readPrimitive(primitive); !done) return done;
        if (avatar_.indices.empty()) return bad("the mesh has no triangles");
        return {};
    }

    /// An attribute with one row of an expected width for each vertex.
    [[nodiscard]] Result<GltfRows> attribute(const tinygltf::Primitive& primitive, const std::string& name,
                                             std::size_t width, std::size_t count) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return bad("the mesh has no " + name);
        auto rows = readGltfRows(model_, found->second, file_, name);
        if (!rows) return rows;
        const bool wide_enough = rows->width == width || (name == "COLOR_0" && rows->width == 4);
        if (!wide_enough)
            return bad(fmt::format("{} has {} numbers a vertex, expected {}", name, rows->width, width));
        if (count != 0 && rows->size() != count)
            return bad(fmt::format("{} has {} rows, expected {}", name, rows->size(), count));
        return rows;
    }

    [[nodiscard]] glm::vec3 baseColour(const tinygltf::Primitive& primitive) const {
        if (primitive.material < 0 || static_cast<std::size_t>(primitive.material) >= model_.materials.size())
            return glm::vec3(1.0F);
        const auto& factor = model_.materials[static_cast<std::size_t>(primitive.material)]
                                 .pbrMetallicRoughness.baseColorFactor;
        if (factor.size() < 3) return glm::vec3(1.0F);
        return {static_cast<float>(factor[0]), static_cast<float>(factor[1]), static_cast<float>(factor[2])};
    }

    Result<void> readPrimitive(const tinygltf::Primitive& primitive) {
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1)
            return bad(fmt::format("primitive mode {} is not supported, expected triangles", primitive.mode));
        const auto positions = attribute(primitive, "POSITION", 3, 0);
        if (!positions) return tl::unexpected(positions.error());
        const std::size_t count = positions->size();
        const auto normals = attribute(primitive, "NORMAL", 3, count);
        if (!normals) return tl::unexpected(normals.error());
        const auto weights = attribute(primitive, "WEIGHTS_0", 4, count);
        if (!weights) return tl::unexpected(weights.error());
        if (primitive.attributes.count("JOINTS_0") == 0) return bad("the mesh has no JOINTS_0");
        const auto joints = readGltfIntegers(model_, primitive.attributes.at("JOINTS_0"), file_, "JOINTS_0");
        if (!joints) return tl::unexpected(joints.error());
        if (joints->width != 4 || joints->values.size() != 4 * count)
            return bad(fmt::format("JOINTS_0 has {} numbers, expected 4 for each of {} vertices",
                                   joints->values.size(), count));
        GltfRows colours;
        if (primitive.attributes.count("COLOR_0") > 0) {
            auto read = attribute(primitive, "COLOR_0", 3, count);
            if (!read) return tl::unexpected(read.error());
            colours = std::move(*read);
        }

        const glm::vec3 base = baseColour(primitive);
        const std::size_t first = avatar_.vertices.size();
        for (std::size_t v = 0; v < count; ++v) {
            SkinnedVertex vertex;
            const float* p = &positions->values[v * 3];
            const float* n = &normals->values[v * 3];
            vertex.position = {p[0], p[1], p[2]};
            vertex.normal = {n[0], n[1], n[2]};
            vertex.colour = base;
            if (colours.width > 0) {
                const float* c = &colours.values[v * colours.width];
                vertex.colour *= glm::vec3(c[0], c[1], c[2]);
            }
            float sum = 0.0F;
            for (std::size_t i = 0; i < 4; ++i) {
                const float weight = weights->values[v * 4 + i];
                const std::uint32_t joint = joints->values[v * 4 + i];
                if (weight < 0.0F) return bad(fmt::format("vertex {} has the negative weight {}", v, weight));
                if (joint >= joint_of_skin_.size())
                    return bad(fmt::format("vertex {} names joint {}; the skin has {}", v, joint,
                                           joint_of_skin_.size()));
                vertex.joints[i] = static_cast<std::uint16_t>(joint_of_skin_[joint]);
                vertex.weights[i] = weight;
                sum += weight;
            }
            if (!(std::abs(sum - 1.0F) < 0.02F))
                return bad(fmt::format("the weights of vertex {} sum to {}, expected 1", v, sum));
            for (float& weight : vertex.weights) weight /= sum;
            avatar_.vertices.push_back(vertex);
        }
        return readIndices(primitive, first, count);
    }

    Result<void> readIndices(const tinygltf::Primitive& primitive, std::size_t first, std::size_t count) {
        std::vector<std::uint32_t> indices;
        if (primitive.indices < 0) {
            indices.resize(count);
            std::iota(indices.begin(), indices.end(), 0U);
        } else {
            auto read = readGltfIntegers(model_, primitive.indices, file_, "indices");
            if (!read) return tl::unexpected(read.error());
            if (read->width != 1) return bad("indices are not single numbers");
            indices = std::move(read->values);
        }
        if (indices.size() % 3 != 0)
            return bad(fmt::format("{} indices are no whole number of triangles", indices.size()));
        for (const std::uint32_t index : indices) {
            if (index >= count)
                return bad(fmt::format("index {} is out of range; there are {} vertices", index, count));
            avatar_.indices.push_back(static_cast<std::uint32_t>(first + index));
        }
        return {};
    }

    const tinygltf::Model& model_;
    std::string file_;
    std::vector<int> parent_;         // of each node
    std::vector<int> joint_of_skin_;  // skeleton joint of each joint of the skin
    int mesh_ = -1, skin_ = -1;
    Avatar avatar_;
};

}  // namespace

Result<Avatar> loadAvatar(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const std::string file = path.string();
    if (bytes->size() < 12 || bytes->compare(0, 4, "glTF") != 0)
        return fail(file, "not a glTF binary, which starts with the letters glTF",
                    "Export the avatar as .glb (or .vrm)");
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    tinygltf::Model model;
    std::string problem, warning;
    try {
        const bool loaded = loader.LoadBinaryFromMemory(
            &model, &problem, &warning, reinterpret_cast<const unsigned char*>(bytes->data()),
            static_cast<unsigned int>(bytes->size()), path.parent_path().string());
        while (!problem.empty() && (problem.back() == '\n' || problem.back() == '.')) problem.pop_back();
        if (!loaded) return fail(file, fmt::format("not a readable glTF binary: {}", problem), export_anew);
        auto avatar = Reader(model, file).run();
        if (avatar) avatar->content_hash = sha256Hex(*bytes);
        return avatar;
    } catch (const std::exception& error) {  // tinygltf lets its JSON library's exceptions through
        return fail(file, fmt::format("not a readable glTF binary: {}", error.what()), export_anew);
    }
}

}  // namespace deixis::assets
