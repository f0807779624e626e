// From bone rotations in the world to a clip of the avatar that stands where it should; private to
// retargeting.
#pragma once

#include <vector>

#include "retarget_alignment.hpp"

namespace deixis::motion {

struct AvatarRest {
    const Skeleton& skeleton;
    const HumanoidMap& map;
    std::vector<Pose> world;
    BodyShape shape;
    TrunkAxes axes;
    double leg_length_m;  ///< hip joint to ankle along the bones
};
[[nodiscard]] AvatarRest avatarRest(const Skeleton& skeleton, const HumanoidMap& map);

/// Thigh and shin, mean of both sides.
[[nodiscard]] double legLength(const BodyShape& shape);

struct BodyFrame {
    BoneTurns rotation;  ///< world rotation of each bone, y up
    Vec3 hip_centre;     ///< midpoint between the hip joints, at the avatar's scale, metres
};

using BoneSet = std::array<bool, bone_count>;

/// How the feet come to the floor: one shift for the clip, which keeps jumps; or one for each frame, for a
/// person who keeps a foot on the floor while the recorded height of the hips wavers.
enum class Ground : unsigned char { clip, frame };

/// Turns the motion so that its first frame faces +z with the hips over the origin, and moves it up or down
/// so that the feet stand on the floor. Bones outside `driven` keep their rest, fingers the relaxed hand.
[[nodiscard]] Clip assemble(const AvatarRest& avatar, std::vector<BodyFrame> frames, const BoneSet& driven,
                            Ground ground, double frame_time_s);

/// "leftHand, head": names of required bones that `has` lacks; empty where none is missing.
[[nodiscard]] std::string missingBones(const BoneSet& has);

}  // namespace deixis::motion
