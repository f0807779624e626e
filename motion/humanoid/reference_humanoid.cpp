#include "motion/humanoid/reference_humanoid.hpp"

#include <utility>

namespace deixis::motion {

namespace {

struct Placed {
    Bone bone;
    Vec3 position;  // T pose, metres, avatar frame; the left side only, mirrored for the right
};

using enum Bone;

const Placed placed[] = {
    {hips, {0, 0.930, 0}},
    {spine, {0, 1.025, -0.005}},
    {chest, {0, 1.140, -0.012}},
    {upperChest, {0, 1.260, -0.015}},
    {neck, {0, 1.440, -0.020}},
    {head, {0, 1.530, 0.000}},
    {jaw, {0, 1.560, 0.015}},
    {leftEye, {0.031, 1.622, 0.068}},
    {leftUpperLeg, {0.090, 0.900, 0}},
    {leftLowerLeg, {0.095, 0.490, 0.005}},
    {leftFoot, {0.098, 0.085, -0.030}},
    {leftToes, {0.105, 0.025, 0.100}},
    {leftShoulder, {0.030, 1.395, -0.005}},
    {leftUpperArm, {0.175, 1.390, -0.015}},
    {leftLowerArm, {0.470, 1.390, -0.015}},
    {leftHand, {0.725, 1.390, -0.015}},
    {leftThumbMetacarpal, {0.747, 1.378, 0.008}},
    {leftThumbProximal, {0.779, 1.368, 0.034}},
    {leftThumbDistal, {0.805, 1.362, 0.054}},
    {leftIndexProximal, {0.818, 1.388, 0.013}},
    {leftIndexIntermediate, {0.862, 1.388, 0.016}},
    {leftIndexDistal, {0.889, 1.388, 0.018}},
    {leftMiddleProximal, {0.822, 1.390, -0.010}},
    {leftMiddleIntermediate, {0.870, 1.390, -0.010}},
    {leftMiddleDistal, {0.900, 1.390, -0.010}},
    {leftRingProximal, {0.817, 1.388, -0.031}},
    {leftRingIntermediate, {0.861, 1.388, -0.034}},
    {leftRingDistal, {0.889, 1.388, -0.036}},
    {leftLittleProximal, {0.808, 1.384, -0.050}},
    {leftLittleIntermediate, {0.842, 1.384, -0.055}},
    {leftLittleDistal, {0.863, 1.384, -0.058}},
};

const Placed tips[] = {
    {jaw, {0, 1.520, 0.090}},
    {leftEye, {0.031, 1.622, 0.086}},
    {leftToes, {0.108, 0.015, 0.165}},
    {leftThumbDistal, {0.828, 1.357, 0.071}},
    {leftIndexDistal, {0.912, 1.387, 0.020}},
    {leftMiddleDistal, {0.924, 1.389, -0.010}},
    {leftRingDistal, {0.912, 1.387, -0.038}},
    {leftLittleDistal, {0.883, 1.383, -0.061}},
};

Vec3 mirrored(const Vec3& p) {
    return {-p.x, p.y, p.z};
}

Skeleton build() {
    std::array<Vec3, bone_count> position{};
    std::array<std::optional<Vec3>, bone_count> tip{};
    for (const Placed& p : placed) {
        position[static_cast<std::size_t>(p.bone)] = p.position;
        if (const Bone other = mirroredBone(p.bone); other != p.bone)
            position[static_cast<std::size_t>(other)] = mirrored(p.position);
    }
    for (const Placed& p : tips) {
        tip[static_cast<std::size_t>(p.bone)] = p.position;
        if (const Bone other = mirroredBone(p.bone); other != p.bone)
            tip[static_cast<std::size_t>(other)] = mirrored(p.position);
    }
    Skeleton skeleton;
    for (std::size_t i = 0; i < bone_count; ++i) {
        const auto bone = static_cast<Bone>(i);
        const auto parent = parentBone(bone);
        Joint joint;
        joint.name = std::string(boneName(bone));
        joint.parent = parent ? static_cast<int>(*parent) : -1;
        joint.rest.position =
            parent ? position[i] - position[static_cast<std::size_t>(*parent)] : position[i];
        if (tip[i]) joint.end_site = *tip[i] - position[i];
        skeleton.joints.push_back(std::move(joint));
    }
    return skeleton;
}

void turn(LocalPose& pose, const HumanoidMap& map, Bone bone, const Vec3& axis, double degrees) {
    if (!map.has(bone)) return;
    auto& joint = pose.joints[static_cast<std::size_t>(map[bone])];
    joint.orientation = joint.orientation * glm::angleAxis(radiansFromDegrees(degrees), axis);
}

}  // namespace

const Skeleton& referenceHumanoid() {
    static const Skeleton skeleton = build();
    return skeleton;
}

LocalPose relaxedPose(const Skeleton& skeleton) {
    const HumanoidMap map = mapByVrmNames(skeleton);
    LocalPose pose = restPose(skeleton);
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (const double s : {1.0, -1.0}) {
        const bool left = s > 0;
        const auto bone = [&](Bone b) { return left ? b : mirroredBone(b); };
        turn(pose, map, bone(leftShoulder), z, -4 * s);
        turn(pose, map, bone(leftUpperArm), z, -73 * s);
        turn(pose, map, bone(leftUpperArm), x, 20);
        turn(pose, map, bone(leftLowerArm), y, -14 * s);
        turn(pose, map, bone(leftHand), z, -4 * s);
        for (const Bone b : {leftIndexProximal, leftMiddleProximal, leftRingProximal, leftLittleProximal})
            turn(pose, map, bone(b), z, -16 * s);
        for (const Bone b :
             {leftIndexIntermediate, leftMiddleIntermediate, leftRingIntermediate, leftLittleIntermediate})
            turn(pose, map, bone(b), z, -22 * s);
        for (const Bone b : {leftIndexDistal, leftMiddleDistal, leftRingDistal, leftLittleDistal})
            turn(pose, map, bone(b), z, -12 * s);
        turn(pose, map, bone(leftThumbProximal), y, 10 * s);
    }
    return pose;
}

}  // namespace deixis::motion
