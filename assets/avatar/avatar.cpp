#include "assets/avatar/avatar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <set>

#include "assets/gltf/gltf_values.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "mesh.hpp"
#include "nodes.hpp"
#include "rig.hpp"

namespace deixis::assets {

namespace {

using motion::Bone;

/// The file's figure as an avatar: its rig in the T pose, its mesh bound to it.
class Assembler {
  public:
    Assembler(const gltf::Document& document, const NodeTree& tree, Rig rig, FigureMesh mesh,
              std::optional<double> height_m, std::vector<std::string> remarks)
        : doc_(document),
          tree_(tree),
          rig_(std::move(rig)),
          mesh_(std::move(mesh)),
          file_(document.file),
          height_m_(height_m) {
        avatar_.remarks = std::move(remarks);
    }

    Avatar run() {
        if (!isFinite())
            gltf::reject(file_, "its nodes' scales and positions give points that are not finite");
        toMetres();
        toFloor();
        chooseJoints();
        makeSkeleton();
        findTips();
        bindSlots();
        if (avatar_.skeleton.joints.size() > max_avatar_joints)
            gltf::reject(file_,
                         fmt::format("its skin follows {} joints, at most {} can be drawn",
                                     avatar_.skeleton.joints.size(), max_avatar_joints),
                         "Merge joints of hair, clothes and face, then export the file again");
        avatar_.vertices = std::move(mesh_.vertices);
        avatar_.textures = std::move(mesh_.textures);
        joinParts();
        return std::move(avatar_);
    }

  private:
    [[nodiscard]] const RigJoint& rigJoint(int joint) const {
        return rig_.joints[static_cast<std::size_t>(joint)];
    }

    /// Where a slot holds a vertex in the T pose.
    [[nodiscard]] Vec3 placedBy(const BindSlot& slot, const Vec3& position) const {
        const RigJoint& joint = rigJoint(slot.joint);
        return joint.placed + joint.turn * (transformPoint(slot.rest_from_bind, position) - joint.rest);
    }
    [[nodiscard]] Vec3 placed(const SkinnedVertex& v) const {
        Vec3 sum(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            if (v.weights[i] > 0.0F)
                sum +=
                    static_cast<double>(v.weights[i]) * placedBy(mesh_.slots[v.joints[i]], Vec3(v.position));
        return sum;
    }

    [[nodiscard]] bool isFinite() const {
        const auto finite = [](const Vec3& v) {
            return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        };
        return std::all_of(
                   rig_.joints.begin(), rig_.joints.end(),
                   [&](const RigJoint& joint) { return finite(joint.rest) && finite(joint.placed); }) &&
               std::all_of(mesh_.vertices.begin(), mesh_.vertices.end(), [&](const SkinnedVertex& v) {
                   return finite(placed(v)) && finite(Vec3(v.position));
               });
    }

    /// Lowest and highest point in the T pose, of the mesh and of the figure's joints.
    [[nodiscard]] std::pair<double, double> extent() const {
        double low = std::numeric_limits<double>::max();
        double high = -low;
        const auto add = [&](double y) {
            low = std::min(low, y);
            high = std::max(high, y);
        };
        for (const SkinnedVertex& v : mesh_.vertices) add(placed(v).y);
        for (const Bone bone : {Bone::head, Bone::leftFoot, Bone::rightFoot, Bone::leftToes, Bone::rightToes})
            if (const int joint = rig_.humanoid[bone]; joint >= 0) add(rigJoint(joint).placed.y);
        return {low, high};
    }

    /// The height that a person asks for. Without: glTF is in metres, but not all exporters know; what is no
    /// figure's height is scaled by a usual unit. Fails where it is then not as tall as people are.
    void toMetres() {
        const auto [low, high] = extent();
        const double height = high - low;
        const std::string hint = fmt::format(
            "Say how tall it should be: avatar_height_m = 1.7 under [study], or height_m = 1.7 in {}",
            humanoidFileOf(file_).string());
        if (!(height > 1e-9 && height < 1e9))
            gltf::reject(file_, fmt::format("is {:.4g} units tall, expected a figure with a height", height),
                         "Export the file again");
        const double unit = height_m_ ? *height_m_ / height : likelyUnit(height);
        const double height_m = height * unit;
        if (!height_m_ && !(height_m >= shortest_avatar_m && height_m <= tallest_avatar_m))
            gltf::reject(
                file_,
                unit == 1.0
                    ? fmt::format("is {:.2f} m tall, expected {:g} to {:g} m, like people", height_m,
                                  shortest_avatar_m, tallest_avatar_m)
                    : fmt::format(
                          "is {:.4g} units tall, which in no common unit is {:g} to {:g} m, like people",
                          height, shortest_avatar_m, tallest_avatar_m),
                hint);
        if (unit == 1.0) return;
        scale(unit);
        constexpr double near_m = 1e-3;
        if (const auto [low_m, high_m] = extent(); !(std::abs(high_m - low_m - height_m) < near_m))
            gltf::reject(file_, "its mesh is bound so far from its joints that rounding moves it",
                         "Export the file again, with its mesh near its armature");
        avatar_.remarks.push_back(
            height_m_ ? fmt::format("{:.4g} units high: scaled to {:.2f} m, as requested", height, height_m)
                      : fmt::format("{:.4g} units high: scaled by {:g} to {:.2f} m", height, unit, height_m));
    }

    [[nodiscard]] static double likelyUnit(double height) {
        constexpr double shortest_m = 0.4, tallest_m = 3.2, usual_m = 1.7;
        double best = 1.0;
        if (height >= shortest_m && height <= tallest_m) return best;
        for (const double unit : {1e-4, 1e-3, 1e-2, 0.0254, 0.1, 10.0, 1e2, 1e3})
            if (std::abs(std::log(height * unit / usual_m)) < std::abs(std::log(height * best / usual_m)))
                best = unit;
        return best;
    }

    void scale(double unit) {
        unit_ = unit;
        for (RigJoint& joint : rig_.joints) {
            joint.rest *= unit;
            joint.placed *= unit;
        }
        for (BindSlot& slot : mesh_.slots) slot.rest_from_bind.position *= unit;
        for (SkinnedVertex& v : mesh_.vertices) v.position *= static_cast<float>(unit);
    }

    /// Soles on the floor, hips over the origin.
    void toFloor() {
        constexpr double nothing_m = 1e-3;
        Vec3 shift(0.0);
        const Vec3 hips = rigJoint(rig_.humanoid[Bone::hips]).placed;
        if (const double low = extent().first; std::abs(low) > nothing_m) shift.y = -low;
        if (std::hypot(hips.x, hips.z) > nothing_m) shift -= Vec3(hips.x, 0.0, hips.z);
        for (RigJoint& joint : rig_.joints) joint.placed += shift;
        avatar_.height_m = extent().second;
    }

    /// Bones, and joints that vertices follow; what else the file has would move nothing.
    void chooseJoints() {
        slot_used_.assign(mesh_.slots.size(), false);
        for (const SkinnedVertex& v : mesh_.vertices)
            for (std::size_t i = 0; i < 4; ++i)
                if (v.weights[i] > 0.0F) slot_used_[v.joints[i]] = true;
        kept_.assign(rig_.joints.size(), false);
        for (const int joint : rig_.humanoid.joint)
            if (joint >= 0) kept_[static_cast<std::size_t>(joint)] = true;
        for (std::size_t s = 0; s < mesh_.slots.size(); ++s)
            if (slot_used_[s]) kept_[static_cast<std::size_t>(mesh_.slots[s].joint)] = true;
    }

    [[nodiscard]] int keptParent(int joint) const {
        for (joint = rigJoint(joint).parent; joint >= 0; joint = rigJoint(joint).parent)
            if (kept_[static_cast<std::size_t>(joint)]) return joint;
        return -1;
    }

    /// Parents before children; the file's own order is kept where it does that.
    [[nodiscard]] std::vector<int> order() const {
        std::vector<int> joints;
        std::vector<int> depth(rig_.joints.size(), 0);
        bool in_order = true;
        for (std::size_t j = 0; j < rig_.joints.size(); ++j) {
            if (!kept_[j]) continue;
            joints.push_back(static_cast<int>(j));
            in_order = in_order && keptParent(static_cast<int>(j)) < static_cast<int>(j);
            for (int at = keptParent(static_cast<int>(j)); at >= 0; at = keptParent(at)) ++depth[j];
        }
        if (!in_order)
            std::stable_sort(joints.begin(), joints.end(), [&](int a, int b) {
                return depth[static_cast<std::size_t>(a)] < depth[static_cast<std::size_t>(b)];
            });
        return joints;
    }

    void makeSkeleton() {
        std::vector<std::string> names(rig_.joints.size());
        std::set<std::string> taken;
        for (std::size_t b = 0; b < motion::bone_count; ++b) {
            const std::string name(motion::boneName(static_cast<Bone>(b)));
            taken.insert(name);
            if (const int joint = rig_.humanoid.joint[b]; joint >= 0)
                names[static_cast<std::size_t>(joint)] = name;
        }
        // A clip moves the hips in the stage: what stands above them stays at the origin.
        std::vector<bool> above_hips(rig_.joints.size(), false);
        for (int at = rigJoint(rig_.humanoid[Bone::hips]).parent; at >= 0; at = rigJoint(at).parent)
            above_hips[static_cast<std::size_t>(at)] = true;
        skeleton_joint_.assign(rig_.joints.size(), -1);
        origin_.assign(rig_.joints.size(), Vec3(0.0));
        for (const int j : order()) {
            const auto index = static_cast<std::size_t>(j);
            const RigJoint& from = rigJoint(j);
            if (!above_hips[index]) origin_[index] = from.placed;
            motion::Joint joint;
            joint.name = names[index];
            for (int n = 1; joint.name.empty(); ++n) {
                const std::string wanted = from.name.empty() ? "joint" : from.name;
                std::string name = n == 1 ? wanted : fmt::format("{}#{}", wanted, n);
                if (taken.insert(name).second) joint.name = std::move(name);
            }
            const int parent = keptParent(j);
            joint.parent = parent < 0 ? -1 : skeleton_joint_[static_cast<std::size_t>(parent)];
            joint.rest.position =
                origin_[index] - (parent < 0 ? Vec3(0.0) : origin_[static_cast<std::size_t>(parent)]);
            joint.rest.position =
                exactly(joint.rest.position, doc_.nodes[static_cast<std::size_t>(from.node)]);
            skeleton_joint_[index] = avatar_.skeleton.size();
            avatar_.skeleton.joints.push_back(std::move(joint));
        }
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            if (const int joint = rig_.humanoid.joint[b]; joint >= 0)
                avatar_.humanoid.joint[b] = skeleton_joint_[static_cast<std::size_t>(joint)];
    }

    /// joint_from_bind of each slot, and a skeleton joint for it: the joint itself, or where that one already
    /// holds a mesh in another way, a joint that rests on it.
    void bindSlots() {
        avatar_.joint_from_bind.resize(avatar_.skeleton.joints.size());
        std::vector<bool> taken(avatar_.skeleton.joints.size(), false);
        for (std::size_t j = 0; j < rig_.joints.size(); ++j)
            if (skeleton_joint_[j] >= 0)
                avatar_.joint_from_bind[static_cast<std::size_t>(skeleton_joint_[j])] =
                    jointFromBind({static_cast<int>(j), {}});
        std::vector<std::uint16_t> joint_of_slot(mesh_.slots.size(), 0);
        for (std::size_t s = 0; s < mesh_.slots.size(); ++s) {
            if (!slot_used_[s]) continue;
            auto joint =
                static_cast<std::size_t>(skeleton_joint_[static_cast<std::size_t>(mesh_.slots[s].joint)]);
            if (taken[joint]) {
                motion::Joint rider;
                rider.name = fmt::format("{}/{}", avatar_.skeleton.joints[joint].name, s);
                rider.parent = static_cast<int>(joint);
                joint = avatar_.skeleton.joints.size();
                avatar_.skeleton.joints.push_back(std::move(rider));
                avatar_.joint_from_bind.emplace_back();
                taken.push_back(false);
            }
            taken[joint] = true;
            avatar_.joint_from_bind[joint] = jointFromBind(mesh_.slots[s]);
            joint_of_slot[s] = static_cast<std::uint16_t>(joint);
        }
        for (SkinnedVertex& v : mesh_.vertices)
            for (std::uint16_t& joint : v.joints) joint = joint_of_slot[joint];
    }

    [[nodiscard]] Pose jointFromBind(const BindSlot& slot) const {
        const RigJoint& joint = rigJoint(slot.joint);
        const Vec3 offset = joint.placed - origin_[static_cast<std::size_t>(slot.joint)];
        const Pose joint_from_rest{offset - joint.turn * joint.rest, joint.turn};
        return joint_from_rest * slot.rest_from_bind;
    }

    /// Tips of joints that end a chain: the file's own node there, else as far as the skin reaches.
    void findTips() {
        std::vector<bool> has_child(avatar_.skeleton.joints.size(), false);
        for (const motion::Joint& joint : avatar_.skeleton.joints)
            if (joint.parent >= 0) has_child[static_cast<std::size_t>(joint.parent)] = true;
        for (std::size_t j = 0; j < rig_.joints.size(); ++j) {
            if (skeleton_joint_[j] < 0 || has_child[static_cast<std::size_t>(skeleton_joint_[j])]) continue;
            motion::Joint& joint = avatar_.skeleton.joints[static_cast<std::size_t>(skeleton_joint_[j])];
            joint.end_site = tipByNode(rig_.joints[j]);
        }
        for (const bool left : {true, false}) {
            const auto bone = [&](Bone b) { return left ? b : motion::mirroredBone(b); };
            const Vec3 out(left ? 1.0 : -1.0, 0.0, 0.0);
            for (const Bone b : {Bone::leftHand, Bone::leftThumbDistal, Bone::leftIndexDistal,
                                 Bone::leftMiddleDistal, Bone::leftRingDistal, Bone::leftLittleDistal})
                reachTip(bone(b), has_child, out);
            for (const Bone b : {Bone::leftFoot, Bone::leftToes}) reachTip(bone(b), has_child, Vec3(0, 0, 1));
        }
    }

    /// The first node below the joint that carries nothing, from the joint in the T pose.
    [[nodiscard]] std::optional<Vec3> tipByNode(const RigJoint& joint) const {
        for (const int child : doc_.nodes[static_cast<std::size_t>(joint.node)].children) {
            const gltf::Node& node = doc_.nodes[static_cast<std::size_t>(child)];
            if (node.mesh >= 0 || !node.children.empty()) continue;
            const Vec3 rest =
                unit_ * (rig_.avatar_from_file * Vec3(tree_.world[static_cast<std::size_t>(child)][3]));
            const Vec3 tip = joint.turn * (rest - joint.rest);
            if (glm::length(tip) < 1e-4) continue;
            return exactly(tip, node);
        }
        return std::nullopt;
    }

    /// Gives a bone that ends a chain and has no tip one as far as the vertices that follow it reach.
    void reachTip(Bone bone, const std::vector<bool>& has_child, const Vec3& direction) {
        const int rig_joint = rig_.humanoid[bone];
        if (rig_joint < 0) return;
        const auto index = static_cast<std::size_t>(skeleton_joint_[static_cast<std::size_t>(rig_joint)]);
        motion::Joint& joint = avatar_.skeleton.joints[index];
        if (has_child[index] || joint.end_site) return;
        double reach = 0.0;
        for (const SkinnedVertex& v : mesh_.vertices) {
            float weight = 0.0F;
            for (std::size_t i = 0; i < 4; ++i)
                if (mesh_.slots[v.joints[i]].joint == rig_joint) weight += v.weights[i];
            if (weight >= 0.5F)
                reach = std::max(reach, glm::dot(placed(v) - rigJoint(rig_joint).placed, direction));
        }
        if (reach > 1e-3) joint.end_site = reach * direction;
    }

    /// Sums and differences cost the last digits; a node that is but moved has them.
    [[nodiscard]] static Vec3 exactly(const Vec3& position, const gltf::Node& node) {
        return glm::length(position - node.translation) < 1e-12 ? node.translation : position;
    }

    void joinParts() {
        for (std::size_t i = 0; i < mesh_.parts.size(); ++i) {
            if (mesh_.indices[i].empty()) continue;
            AvatarPart part = mesh_.parts[i];
            part.first_index = static_cast<std::uint32_t>(avatar_.indices.size());
            part.index_count = static_cast<std::uint32_t>(mesh_.indices[i].size());
            avatar_.indices.insert(avatar_.indices.end(), mesh_.indices[i].begin(), mesh_.indices[i].end());
            avatar_.parts.push_back(part);
        }
    }

    const gltf::Document& doc_;
    const NodeTree& tree_;
    Rig rig_;
    FigureMesh mesh_;
    const std::string& file_;
    std::optional<double> height_m_;  ///< as asked for
    std::vector<bool> slot_used_, kept_;
    std::vector<int> skeleton_joint_;  ///< of each joint of the rig; -1 where it is left out
    std::vector<Vec3> origin_;         ///< where the skeleton has each joint of the rig in the T pose
    double unit_ = 1.0;                ///< metres in the file's unit
    Avatar avatar_;
};

/// `said`: by a person, in the file beside the avatar's; or null.
Result<Avatar> avatarOf(std::string_view bytes, const std::string& file,
                        const std::optional<std::filesystem::path>& folder, const HumanoidWords* said,
                        const AvatarOptions& options) try {
    const gltf::Document document = gltf::readDocument(bytes, file, gltf::Content::figure);
    const gltf::Values values(document, folder);
    const auto neighbours = values.neighbours();
    const NodeTree tree = readNodes(document);
    std::vector<std::string> remarks;
    Rig rig = readRig(document, tree, said, remarks);
    turnToTPose(rig, remarks);
    FigureMesh mesh = readFigureMesh(document, values, tree, rig, remarks);
    const auto height_m = options.height_m ? options.height_m : said ? said->height_m : std::nullopt;
    Avatar avatar =
        Assembler(document, tree, std::move(rig), std::move(mesh), height_m, std::move(remarks)).run();
    avatar.content_hash = sha256Hex(bytes);
    std::string hashes;
    for (const auto& neighbour : neighbours) {
        hashes += sha256Hex(neighbour.bytes);
        avatar.files.push_back(neighbour.path);
    }
    const auto add = [&](const std::string& more) {
        avatar.content_hash = sha256Hex(avatar.content_hash + more);
    };
    if (!hashes.empty()) add(hashes);
    if (said != nullptr) add(sha256Hex(said->text));
    if (options.height_m) add(fmt::format(", {:.17g} m", *options.height_m));
    return avatar;
} catch (const gltf::Rejection& rejection) {
    return tl::unexpected(rejection.error);
}

}  // namespace

Result<Avatar> loadAvatar(const std::filesystem::path& path, const AvatarOptions& options) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto said = humanoidWordsBeside(path);
    if (!said) return tl::unexpected(said.error());
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    auto avatar = avatarOf(*bytes, path.string(), folder, *said ? &**said : nullptr, options);
    if (avatar) avatar->files.insert(avatar->files.begin(), path);
    return avatar;
}

Result<Avatar> readAvatar(std::string_view bytes, const std::string& name, const AvatarOptions& options) {
    return avatarOf(bytes, name, std::nullopt, nullptr, options);
}

}  // namespace deixis::assets
