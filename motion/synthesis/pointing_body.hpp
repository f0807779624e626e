// An avatar as the pointing systems see it: its bones, its stance at ease and its pointing hands.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

struct PointingBody {
    Skeleton skeleton;
    HumanoidMap map;
    LocalPose relaxed;
    LocalPose pointing_hands;  ///< `relaxed` with both hands in the pointing shape
    /// Joints of each hand's fingers, by Side.
    std::array<std::vector<std::size_t>, 2> fingers;
    /// Index fingertip and index knuckle in the frame of each hand in the pointing shape, by Side, metres.
    std::array<Vec3, 2> fingertip_in_hand{};
    std::array<Vec3, 2> knuckle_in_hand{};

    /// Joint of a bone that the body must have.
    [[nodiscard]] std::size_t joint(Bone bone) const { return static_cast<std::size_t>(map[bone]); }
    [[nodiscard]] const Vec3& offset(Bone bone) const { return skeleton.joints[joint(bone)].rest.position; }
    /// Orientation of a bone in a pose, to change; null where the body lacks the bone.
    [[nodiscard]] Quat* find(LocalPose& pose, Bone bone) const {
        return map.has(bone) ? &pose.joints[joint(bone)].orientation : nullptr;
    }
    /// root_from_joint of one joint.
    [[nodiscard]] Pose world(const LocalPose& pose, std::size_t joint) const;
    [[nodiscard]] Vec3 eye(const LocalPose& pose) const;
};

/// Fails where the avatar lacks a bone of the trunk, the head or an arm, or has rest rotations.
[[nodiscard]] Result<PointingBody> makePointingBody(const Skeleton& avatar);

}  // namespace deixis::motion
