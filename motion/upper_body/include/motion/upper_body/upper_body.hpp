// The upper body of Yoon et al. (2021, appendix A.2): ten joints as nine directions, 15 times a second. What
// the gesture model, the unit gestures and the studio's timeline work on.
//
// The figure faces +z, y is up, its left is +x. The hips stand; the spine joint is the origin of positions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::motion {

constexpr double upper_body_fps = 15.0;
constexpr double upper_body_frame_time_s = 1.0 / upper_body_fps;

enum class UpperJoint : unsigned char {
    spine,
    neck,
    nose,
    head_top,
    left_shoulder,
    left_elbow,
    left_wrist,
    right_shoulder,
    right_elbow,
    right_wrist
};
constexpr std::size_t upper_joint_count = 10;

/// Places in UpperBodyPose::directions, each named by the joint that its bone leads to.
enum class UpperBone : unsigned char {
    neck,      ///< from the spine
    nose,      ///< from the neck
    head_top,  ///< from the nose
    left_shoulder,
    left_upper_arm,
    left_forearm,
    right_shoulder,
    right_upper_arm,
    right_forearm
};
constexpr std::size_t upper_bone_count = 9;
constexpr std::size_t upper_body_numbers = 3 * upper_bone_count;

struct UpperBoneEnds {
    UpperJoint from, to;
    double length_m;  ///< mean over people, as SGToolkit's program has it (data_utils.py)
};
/// By UpperBone. A bone stands after the one that leads to its start.
constexpr std::array<UpperBoneEnds, upper_bone_count> upper_bones{
    {{UpperJoint::spine, UpperJoint::neck, 0.26},
     {UpperJoint::neck, UpperJoint::nose, 0.18},
     {UpperJoint::nose, UpperJoint::head_top, 0.14},
     {UpperJoint::neck, UpperJoint::left_shoulder, 0.22},
     {UpperJoint::left_shoulder, UpperJoint::left_elbow, 0.36},
     {UpperJoint::left_elbow, UpperJoint::left_wrist, 0.33},
     {UpperJoint::neck, UpperJoint::right_shoulder, 0.22},
     {UpperJoint::right_shoulder, UpperJoint::right_elbow, 0.36},
     {UpperJoint::right_elbow, UpperJoint::right_wrist, 0.33}}};

/// The directions of the bones, unit length.
struct UpperBodyPose {
    std::array<Vec3, upper_bone_count> directions{};

    [[nodiscard]] const Vec3& operator[](UpperBone bone) const {
        return directions[static_cast<std::size_t>(bone)];
    }
    Vec3& operator[](UpperBone bone) { return directions[static_cast<std::size_t>(bone)]; }
    bool operator==(const UpperBodyPose&) const = default;
};

/// Frame i is at i / 15 s.
struct UpperBodyMotion {
    std::vector<UpperBodyPose> frames;

    bool operator==(const UpperBodyMotion&) const = default;
};

/// Frames of a motion that accompanies a sound of that length: ceil(15 duration_s), at least 1. Playing, the
/// last one lasts to the sound's end.
[[nodiscard]] std::size_t frameCountOf(double duration_s);

/// Somebody at ease: upright, arms hanging, a little bent. The reference humanoid's relaxed pose, and its own
/// mirror image.
[[nodiscard]] const UpperBodyPose& relaxedUpperBody();

/// Metres, by UpperJoint, with the mean lengths of upper_bones; the spine at the origin.
using UpperBodyJoints = std::array<Vec3, upper_joint_count>;
[[nodiscard]] UpperBodyJoints jointsOf(const UpperBodyPose& pose);
/// The directions from joint to joint, whatever the lengths. Where two joints are in one place, the relaxed
/// pose's.
[[nodiscard]] UpperBodyPose poseFromJoints(const UpperBodyJoints& joints);

/// x y z of each direction, in order: a row of SGToolkit's files.
[[nodiscard]] std::array<double, upper_body_numbers> numbersOf(const UpperBodyPose& pose);
/// The directions are made unit length. Fails unless there are 27 finite numbers and no direction is (almost)
/// 0 0 0.
[[nodiscard]] Result<UpperBodyPose> poseFromNumbers(std::span<const double> numbers);

/// Each direction along the arc between both, at share `t` from 0 to 1. Opposite ones have no arc: they jump
/// in the middle.
[[nodiscard]] UpperBodyPose interpolate(const UpperBodyPose& a, const UpperBodyPose& b, double t);
/// Between frames, clamped to the motion, which has at least one.
[[nodiscard]] UpperBodyPose sample(const UpperBodyMotion& motion, double time_s);
/// The motion at another speed, from its first frame to its last, by interpolation: `speed` 2 takes half of
/// the time. Above 0. At least 1 frame.
[[nodiscard]] UpperBodyMotion atSpeed(const UpperBodyMotion& motion, double speed);

/// Left and right change sides (mirror plane x = 0). Mirrored twice, each number is itself again.
[[nodiscard]] UpperBodyPose mirrored(const UpperBodyPose& pose);
[[nodiscard]] UpperBodyMotion mirrored(const UpperBodyMotion& motion);

}  // namespace deixis::motion
