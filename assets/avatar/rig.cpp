#include "rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <numeric>
#include <set>

#include "motion/retarget/retarget.hpp"

namespace deixis::assets {

namespace {

using motion::Bone;
using enum motion::Bone;

constexpr std::size_t max_joints_in_file = 4096;

/// The map by the joints' own names.
motion::HumanoidMap humanoidByNames(const motion::Skeleton& skeleton) {
    const motion::HumanoidMap exact = motion::mapByVrmNames(skeleton);
    return motion::missingBones(exact).empty() ? exact : motion::detectHumanoid(skeleton);
}

class RigReader {
  public:
    RigReader(const gltf::Document& document, const NodeTree& tree, const HumanoidWords* said)
        : doc_(document), tree_(tree), file_(document.file), said_(said) {
        if (doc_.humanoid && !doc_.humanoid->nodes.empty()) vrm_ = &*doc_.humanoid;
    }

    Rig run(std::vector<std::string>& remarks) {
        std::vector<int> nodes = skinnedNodes();
        if (vrm_ != nullptr)
            for (const auto& [bone, node] : vrm_->nodes) nodes.push_back(node);
        makeJoints(nodes);
        auto found = findHumanoid();
        if ((!found || !motion::missingBones(rig_.humanoid).empty()) &&
            (vrm_ == nullptr || said_ != nullptr)) {
            // Figures of rigid parts have no skin, and some skins leave bones out that nothing hangs on.
            for (std::size_t i = 0; i < doc_.nodes.size(); ++i)
                if (tree_.drawn[i]) nodes.push_back(static_cast<int>(i));
            makeJoints(nodes);
            found = findHumanoid();
        }
        if (!found) throw gltf::Rejection{found.error()};
        if (const auto missing = motion::missingBones(rig_.humanoid); !missing.empty())
            gltf::reject(file_,
                         fmt::format("no joint was found for {}, expected the bones of a humanoid",
                                     fmt::join(missing, ", ")),
                         "Name the joints as VRM, Mixamo or another common rig does, save the figure as "
                         "VRM, or " +
                             wordFile());
        if (said_ != nullptr && !said_->words.empty()) remarks.push_back("bones as " + said_->file + " says");
        hangBones(remarks);
        faceForward(remarks);
        return std::move(rig_);
    }

  private:
    RigJoint& joint(int index) { return rig_.joints[static_cast<std::size_t>(index)]; }
    [[nodiscard]] Vec3 boneAt(Bone bone) const {
        return rig_.joints[static_cast<std::size_t>(rig_.humanoid[bone])].rest;
    }

    /// The joints of all skins that are drawn, in the skins' order.
    [[nodiscard]] std::vector<int> skinnedNodes() const {
        std::vector<int> nodes;
        std::set<int> skins;
        for (std::size_t i = 0; i < doc_.nodes.size(); ++i) {
            const gltf::Node& node = doc_.nodes[i];
            if (!tree_.drawn[i] || node.mesh < 0 || node.skin < 0 || !skins.insert(node.skin).second)
                continue;
            const auto& joints = doc_.skins[static_cast<std::size_t>(node.skin)].joints;
            nodes.insert(nodes.end(), joints.begin(), joints.end());
        }
        return nodes;
    }

    void makeJoints(const std::vector<int>& nodes) {
        rig_.joints.clear();
        rig_.joint_of_node.assign(doc_.nodes.size(), -1);
        for (const int node : nodes) {
            int& slot = rig_.joint_of_node[static_cast<std::size_t>(node)];
            if (slot >= 0) continue;
            slot = static_cast<int>(rig_.joints.size());
            RigJoint made;
            made.node = node;
            made.name = doc_.nodes[static_cast<std::size_t>(node)].name;
            made.rest = Vec3(tree_.world[static_cast<std::size_t>(node)][3]);
            const glm::dmat3 axes(tree_.world[static_cast<std::size_t>(node)]);
            if (!(std::abs(glm::determinant(axes)) > 1e-24))
                gltf::reject(file_, fmt::format("node {} \"{}\" has no extent: it is scaled to nothing", node,
                                                made.name));
            rig_.joints.push_back(std::move(made));
        }
        if (rig_.joints.size() > max_joints_in_file)
            gltf::reject(file_,
                         fmt::format("has {} joints, expected a figure with at most {}", rig_.joints.size(),
                                     max_joints_in_file),
                         "");
        for (RigJoint& made : rig_.joints)
            made.parent = nearestJoint(doc_.nodes[static_cast<std::size_t>(made.node)].parent);
        std::vector<int> follows = rig_.joint_of_node;
        for (std::size_t i = 0; i < follows.size(); ++i) follows[i] = nearestJoint(static_cast<int>(i));
        rig_.joint_of_node = std::move(follows);
    }

    [[nodiscard]] int nearestJoint(int node) const {
        for (; node >= 0; node = doc_.nodes[static_cast<std::size_t>(node)].parent)
            if (const int found = rig_.joint_of_node[static_cast<std::size_t>(node)]; found >= 0)
                return found;
        return -1;
    }

    /// What helps where a joint was taken for a wrong bone.
    [[nodiscard]] std::string wordFile() const {
        return fmt::format("say in {} which joint is which bone", humanoidFileOf(file_).string());
    }
    [[nodiscard]] std::string played(Bone bone) const {
        return fmt::format("{} (\"{}\")", motion::boneName(bone),
                           rig_.joints[static_cast<std::size_t>(rig_.humanoid[bone])].name);
    }

    /// Fails where a person names a joint that is not there.
    Result<void> findHumanoid() {
        rig_.humanoid = motion::HumanoidMap{};
        if (vrm_ != nullptr)
            for (const auto& [bone, node] : vrm_->nodes)
                rig_.humanoid[bone] = rig_.joint_of_node[static_cast<std::size_t>(node)];
        if (vrm_ != nullptr && said_ == nullptr) return {};
        // The finder wants a skeleton: parents first, names that differ.
        std::vector<int> order(rig_.joints.size());
        std::iota(order.begin(), order.end(), 0);
        const auto depth = [&](int j) {
            int steps = 0;
            for (; j >= 0; j = joint(j).parent) ++steps;
            return steps;
        };
        std::vector<int> depths(order.size());
        std::transform(order.begin(), order.end(), depths.begin(), depth);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            return depths[static_cast<std::size_t>(a)] < depths[static_cast<std::size_t>(b)];
        });
        std::vector<int> place(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        motion::Skeleton skeleton;
        std::set<std::string> names;
        for (const int j : order) {
            motion::Joint made;
            made.name = joint(j).name;
            for (int n = 2; !names.insert(made.name).second; ++n)
                made.name = fmt::format("{}#{}", joint(j).name, n);
            const int parent = joint(j).parent;
            made.parent = parent < 0 ? -1 : place[static_cast<std::size_t>(parent)];
            made.rest.position = joint(j).rest - (parent < 0 ? Vec3(0.0) : joint(parent).rest);
            skeleton.joints.push_back(std::move(made));
        }
        motion::HumanoidMapping found;
        if (vrm_ == nullptr) found.map = humanoidByNames(skeleton);
        for (std::size_t b = 0; b < motion::bone_count && vrm_ != nullptr; ++b)
            if (const int joint_of_rig = rig_.humanoid.joint[b]; joint_of_rig >= 0)
                found.map.joint[b] = place[static_cast<std::size_t>(joint_of_rig)];
        if (said_ != nullptr)
            if (auto applied = applyHumanoidWords(*said_, skeleton, found); !applied) return applied;
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            rig_.humanoid.joint[b] =
                found.map.joint[b] < 0 ? -1 : order[static_cast<std::size_t>(found.map.joint[b])];
        return {};
    }

    [[nodiscard]] bool isAbove(int above, int below) const {
        for (; below >= 0; below = rig_.joints[static_cast<std::size_t>(below)].parent)
            if (below == above) return true;
        return false;
    }

    /// In some rigs feet or hands hang on the root, moved by solvers that a clip has not: each bone hangs on
    /// the bone above it.
    void hangBones(std::vector<std::string>& remarks) {
        for (std::size_t b = 0; b < motion::bone_count; ++b) {
            const auto bone = static_cast<Bone>(b);
            auto above = motion::parentBone(bone);
            while (above && !rig_.humanoid.has(*above)) above = motion::parentBone(*above);
            if (!rig_.humanoid.has(bone) || !above) continue;
            const int own = rig_.humanoid[bone];
            const int upper = rig_.humanoid[*above];
            if (own != upper && isAbove(upper, own)) continue;
            if (isAbove(own, upper))
                gltf::reject(
                    file_,
                    fmt::format("the joint \"{}\" is {} but is above \"{}\", which is {}", joint(own).name,
                                motion::boneName(bone), joint(upper).name, motion::boneName(*above)),
                    "Name the joints as VRM, Mixamo or another common rig does, or " + wordFile());
            joint(own).parent = upper;
            remarks.push_back(
                fmt::format("the joint \"{}\" was attached to \"{}\"", joint(own).name, joint(upper).name));
        }
    }

    /// Finds which way the figure looks, and turns it to y up, facing +z.
    void faceForward(std::vector<std::string>& remarks) {
        const Vec3 rise = boneAt(head) - boneAt(hips);
        const Vec3 across =
            (boneAt(leftUpperLeg) - boneAt(rightUpperLeg)) + (boneAt(leftUpperArm) - boneAt(rightUpperArm));
        const double size = glm::length(rise);
        if (!(size > 0.0) || !std::isfinite(size))
            gltf::reject(file_,
                         fmt::format("{} and {} are in one place, expected a standing figure", played(hips),
                                     played(head)),
                         "If other joints are these bones, " + wordFile());
        const auto nearestAxis = [](const Vec3& v) {
            int best = 0;
            for (int i = 1; i < 3; ++i)
                if (std::abs(v[i]) > std::abs(v[best])) best = i;
            Vec3 axis(0.0);
            axis[best] = v[best] < 0.0 ? -1.0 : 1.0;
            return axis;
        };
        const Vec3 rises = nearestAxis(rise);
        Vec3 left = across - glm::dot(across, rises) * rises;
        if (!(glm::length(left) > 1e-6 * size))
            gltf::reject(
                file_,
                fmt::format(
                    "{} and {}, {} and {} are not apart to left and right, expected a standing figure",
                    played(leftUpperLeg), played(rightUpperLeg), played(leftUpperArm), played(rightUpperArm)),
                "If other joints are these bones, " + wordFile());
        left = glm::normalize(left);
        constexpr double about_straight = 0.966;  // within 15 degrees, asymmetry rather than facing
        if (const Vec3 axis = nearestAxis(left); glm::dot(axis, left) > about_straight) left = axis;
        const glm::dmat3 file_from_avatar(left, rises, glm::cross(left, rises));
        if (file_from_avatar == glm::dmat3(1.0)) return;
        rig_.avatar_from_file = glm::conjugate(glm::normalize(glm::quat_cast(file_from_avatar)));
        for (RigJoint& made : rig_.joints) made.rest = rig_.avatar_from_file * made.rest;
        remarks.emplace_back(rises.y > 0.5 ? "turned to face +z" : "turned upright, to face +z");
    }

    const gltf::Document& doc_;
    const NodeTree& tree_;
    const std::string& file_;
    const HumanoidWords* said_;
    const gltf::Humanoid* vrm_ = nullptr;  ///< as VRM's extension says; none without
    Rig rig_;
};

/// Turns limbs, each with all that hangs on it.
class LimbTurner {
  public:
    explicit LimbTurner(Rig& rig) : rig_(rig) {
        for (RigJoint& joint : rig.joints) {
            joint.placed = joint.rest;
            joint.turn = no_rotation;
        }
    }

    /// By the largest angle that had to be turned, radians.
    [[nodiscard]] double largest() const { return largest_rad_; }

    [[nodiscard]] bool has(Bone bone) const { return rig_.humanoid.has(bone); }
    [[nodiscard]] Vec3 at(Bone bone) const {
        return rig_.joints[static_cast<std::size_t>(rig_.humanoid[bone])].placed;
    }

    /// Turns the bone so that the next one lies in this direction, where it is off by more than `tolerance`.
    void point(Bone bone, Bone next, const Vec3& direction, double tolerance_rad) {
        if (!has(bone) || !has(next)) return;
        const Vec3 now = at(next) - at(bone);
        if (!(glm::length(now) > 0.0)) return;
        const double off = angleBetween(now, direction);
        if (off > tolerance_rad) turn(bone, rotationBetween(now, direction));
    }

    /// Turns the bone about an axis by the angle that takes `now` to `wanted`, both seen along the axis.
    void roll(Bone bone, const Vec3& axis, const Vec3& now, const Vec3& wanted, double tolerance_rad) {
        const Vec3 a = now - glm::dot(now, axis) * axis;
        const Vec3 b = wanted - glm::dot(wanted, axis) * axis;
        if (!(glm::length(a) > 0.07 * glm::length(now))) return;  // along the axis: says nothing
        const double angle = std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b));
        if (std::abs(angle) > tolerance_rad) turn(bone, glm::angleAxis(angle, axis));
    }

    /// Gives the bone and all below it the orientation back that it had at rest.
    void restore(Bone bone) {
        if (!has(bone)) return;
        const Quat back = glm::conjugate(rig_.joints[static_cast<std::size_t>(rig_.humanoid[bone])].turn);
        if (back != no_rotation) turn(bone, back);
    }

  private:
    void turn(Bone bone, const Quat& by) {
        const int pivot_joint = rig_.humanoid[bone];
        const Vec3 pivot = rig_.joints[static_cast<std::size_t>(pivot_joint)].placed;
        largest_rad_ = std::max(largest_rad_, 2.0 * std::acos(std::min(1.0, std::abs(by.w))));
        for (std::size_t j = 0; j < rig_.joints.size(); ++j) {
            int above = static_cast<int>(j);
            while (above >= 0 && above != pivot_joint)
                above = rig_.joints[static_cast<std::size_t>(above)].parent;
            if (above < 0) continue;
            rig_.joints[j].placed = pivot + by * (rig_.joints[j].placed - pivot);
            rig_.joints[j].turn = glm::normalize(by * rig_.joints[j].turn);
        }
    }

    Rig& rig_;
    double largest_rad_ = 0.0;
};

// What a figure's own shape may deviate from the T pose by.
constexpr double arm_tolerance_rad = radiansFromDegrees(1.0);
constexpr double hand_tolerance_rad = radiansFromDegrees(6.0);
constexpr double palm_tolerance_rad = radiansFromDegrees(25.0);
constexpr double leg_tolerance_rad = radiansFromDegrees(4.0);  // from hip to ankle
constexpr double knee_tolerance_rad = radiansFromDegrees(20.0);
constexpr double elbow_tolerance_rad = radiansFromDegrees(60.0);

void turnArm(LimbTurner& limbs, bool left) {
    const auto bone = [&](Bone b) { return left ? b : motion::mirroredBone(b); };
    const Vec3 out(left ? 1.0 : -1.0, 0.0, 0.0);
    const Bone upper = bone(leftUpperArm);
    const Bone lower = bone(leftLowerArm);
    const Bone hand = bone(leftHand);
    limbs.point(upper, lower, out, arm_tolerance_rad);
    // An elbow that is bent at rest tells which way it bends: forwards in the T pose.
    limbs.roll(upper, out, limbs.at(hand) - limbs.at(lower), Vec3(0, 0, 1), elbow_tolerance_rad);
    limbs.point(lower, hand, out, arm_tolerance_rad);
    for (const Bone knuckle : {leftMiddleProximal, leftIndexProximal})
        if (limbs.has(bone(knuckle))) {
            limbs.point(hand, bone(knuckle), out, hand_tolerance_rad);
            break;
        }
    for (const Bone last : {leftLittleProximal, leftRingProximal, leftMiddleProximal})
        if (limbs.has(bone(leftIndexProximal)) && limbs.has(bone(last))) {
            limbs.roll(lower, out, limbs.at(bone(leftIndexProximal)) - limbs.at(bone(last)), Vec3(0, 0, 1),
                       palm_tolerance_rad);
            break;
        }
}

void turnLeg(LimbTurner& limbs, bool left) {
    const auto bone = [&](Bone b) { return left ? b : motion::mirroredBone(b); };
    const Vec3 down(0.0, -1.0, 0.0);
    const Vec3 thigh = limbs.at(bone(leftLowerLeg)) - limbs.at(bone(leftUpperLeg));
    const Vec3 shin = limbs.at(bone(leftFoot)) - limbs.at(bone(leftLowerLeg));
    if (glm::length(thigh) > 0.0 && glm::length(shin) > 0.0 &&
        angleBetween(thigh, shin) > knee_tolerance_rad) {
        limbs.point(bone(leftUpperLeg), bone(leftLowerLeg), down, 0.0);
        limbs.point(bone(leftLowerLeg), bone(leftFoot), down, 0.0);
    }
    limbs.point(bone(leftUpperLeg), bone(leftFoot), down, leg_tolerance_rad);
    limbs.restore(bone(leftFoot));
}

}  // namespace

Rig readRig(const gltf::Document& document, const NodeTree& tree, const HumanoidWords* said,
            std::vector<std::string>& remarks) {
    return RigReader(document, tree, said).run(remarks);
}

void turnToTPose(Rig& rig, std::vector<std::string>& remarks) {
    LimbTurner limbs(rig);
    for (const bool left : {true, false}) {
        turnArm(limbs, left);
        turnLeg(limbs, left);
    }
    if (limbs.largest() > 0.0)
        remarks.push_back(fmt::format("limbs were turned to the T pose, by up to {:.0f} degrees",
                                      degreesFromRadians(limbs.largest())));
}

}  // namespace deixis::assets
