// Random poses of an upper body that a person can take, made on the reference humanoid's joints.
#pragma once

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/axes.hpp"
#include "motion/skeleton/bone_index.hpp"

namespace deixis::tests {

inline Quat turned(double x_deg, double y_deg, double z_deg) {
    return glm::angleAxis(radiansFromDegrees(y_deg), motion::y_axis) *
           glm::angleAxis(radiansFromDegrees(x_deg), motion::x_axis) *
           glm::angleAxis(radiansFromDegrees(z_deg), motion::z_axis);
}

/// Trunk, head and shoulders turned a little; upper arms anywhere to the front and the side, from hanging to
/// overhead, twisted by up to 50 degrees; elbows bent by `low_flexion` to 140 degrees.
inline motion::LocalPose randomPose(Random& random, double low_flexion_deg = 15.0) {
    using motion::Bone;
    motion::LocalPose pose = motion::relaxedPose(motion::referenceHumanoid());
    const auto set = [&](Bone bone, const Quat& turn) {
        pose.joints[motion::indexOf(bone)].orientation = turn;
    };
    const auto some = [&](double range) { return random.uniform(-range, range); };
    for (const Bone bone : {Bone::spine, Bone::chest, Bone::upperChest})
        set(bone, turned(some(8), some(8), some(5)));
    for (const Bone bone : {Bone::neck, Bone::head}) set(bone, turned(some(15), some(25), some(8)));
    for (const bool left : {true, false}) {
        const auto bone = [&](Bone b) { return left ? b : motion::mirroredBone(b); };
        const auto mirrored = [&](const Quat& q) { return left ? q : Quat(q.w, q.x, -q.y, -q.z); };
        set(bone(Bone::leftShoulder), mirrored(turned(0, some(10), random.uniform(-5, 15))));
        // From lying outwards (T pose): ahead by yaw, down or up by the turn about the line ahead.
        const Quat swing = turned(0, random.uniform(-100, 15), random.uniform(-85, 80));
        set(bone(Bone::leftUpperArm), mirrored(swing * turned(some(50), 0, 0)));
        set(bone(Bone::leftLowerArm), mirrored(turned(0, -random.uniform(low_flexion_deg, 140), 0)));
    }
    return pose;
}

}  // namespace deixis::tests
