#include "motion/humanoid/hand_shapes.hpp"

#include <algorithm>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/axes.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

// Left hand of the T pose (palm down, fingers along +x): a finger closes by turning about -z.
struct Curl {
    Bone bone;
    double degrees;
};
const Curl closed_fingers[] = {
    {leftIndexProximal, 2},   {leftIndexIntermediate, 2},    {leftIndexDistal, 1},
    {leftMiddleProximal, 78}, {leftMiddleIntermediate, 100}, {leftMiddleDistal, 55},
    {leftRingProximal, 82},   {leftRingIntermediate, 100},   {leftRingDistal, 55},
    {leftLittleProximal, 84}, {leftLittleIntermediate, 98},  {leftLittleDistal, 52},
};

Quat about(const Vec3& axis, double degrees) {
    return glm::angleAxis(radiansFromDegrees(degrees), axis);
}

// The thumb swings under the palm and lies across the closed middle finger.
struct Turn {
    Bone bone;
    Quat rotation;
};
const Turn closed_thumb[] = {
    {leftThumbMetacarpal, about(x_axis, 28) * about(y_axis, 12)},
    {leftThumbProximal, about(y_axis, 30) * about(x_axis, 12)},
    {leftThumbDistal, about(y_axis, 48)},
};

/// The same turn on the other side of the plane x = 0.
Quat mirroredTurn(const Quat& q) {
    return {q.w, q.x, -q.y, -q.z};
}

}  // namespace

void applyPointingHand(LocalPose& pose, Side side, double amount) {
    static const LocalPose relaxed = relaxedPose(referenceHumanoid());
    const double share = std::clamp(amount, 0.0, 1.0);
    const auto set = [&](Bone left_bone, const Quat& left_turn) {
        const Bone bone = side == Side::left ? left_bone : mirroredBone(left_bone);
        const auto joint = static_cast<std::size_t>(bone);
        const Quat closed = side == Side::left ? left_turn : mirroredTurn(left_turn);
        pose.joints[joint].orientation = glm::slerp(relaxed.joints[joint].orientation, closed, share);
    };
    for (const Curl& curl : closed_fingers) set(curl.bone, about(z_axis, -curl.degrees));
    for (const Turn& turn : closed_thumb) set(turn.bone, turn.rotation);
}

}  // namespace deixis::motion
