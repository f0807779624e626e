#include "pointing_body.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "motion/humanoid/hand_shapes.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"

namespace deixis::motion {

namespace {

/// The reference humanoid's rotations on the avatar's joints.
LocalPose onAvatar(const Skeleton& avatar, const HumanoidMap& map, const LocalPose& reference) {
    LocalPose pose = restPose(avatar);
    for (std::size_t i = 0; i < bone_count; ++i)
        if (const int joint = map.joint[i]; joint >= 0)
            pose.joints[static_cast<std::size_t>(joint)].orientation = reference.joints[i].orientation;
    return pose;
}

void findIndexFinger(PointingBody& body, Side side) {
    const ArmBones bones = armBones(side);
    const auto world = worldPose(body.skeleton, body.pointing_hands);
    const Pose hand_from_root = inverse(world[body.joint(bones.hand)]);
    const auto index = static_cast<std::size_t>(side);
    body.fingertip_in_hand[index] =
        transformPoint(hand_from_root, fingertipPosition(body.skeleton, body.map, world, side));
    body.knuckle_in_hand[index] =
        body.map.has(bones.index_proximal)
            ? transformPoint(hand_from_root, world[body.joint(bones.index_proximal)].position)
            : Vec3(0.0);
}

}  // namespace

Pose PointingBody::world(const LocalPose& pose, std::size_t joint) const {
    Pose out = pose.joints[joint];
    for (int parent = skeleton.joints[joint].parent; parent >= 0;
         parent = skeleton.joints[static_cast<std::size_t>(parent)].parent)
        out = pose.joints[static_cast<std::size_t>(parent)] * out;
    return out;
}

Vec3 PointingBody::eye(const LocalPose& pose) const {
    if (!map.has(Bone::leftEye) || !map.has(Bone::rightEye)) return world(pose, joint(Bone::head)).position;
    return 0.5 * (world(pose, joint(Bone::leftEye)).position + world(pose, joint(Bone::rightEye)).position);
}

Result<PointingBody> makePointingBody(const Skeleton& avatar) {
    PointingBody body;
    body.skeleton = avatar;
    body.map = mapByVrmNames(avatar);
    auto missing = missingBones(body.map, pointingBones());
    if (!body.map.has(Bone::spine)) missing.emplace_back(boneName(Bone::spine));
    if (!missing.empty())
        return fail("", "the avatar has no bone '" + missing.front() + "'",
                    "A pointing avatar needs hips, spine, head and both arms, by their VRM names");
    for (const Joint& joint : avatar.joints)
        if (std::abs(joint.rest.orientation.w) < 1.0 - 1e-9)
            return fail("", "the avatar's joint '" + joint.name + "' has a rest rotation",
                        "A pointing avatar stands in a T pose without rest rotations");

    const Skeleton& reference = referenceHumanoid();
    LocalPose pose = relaxedPose(reference);
    body.relaxed = onAvatar(avatar, body.map, pose);
    applyPointingHand(pose, Side::left, 1.0);
    applyPointingHand(pose, Side::right, 1.0);
    body.pointing_hands = onAvatar(avatar, body.map, pose);
    for (const Side side : {Side::left, Side::right}) {
        findIndexFinger(body, side);
        const auto first = static_cast<std::size_t>(side == Side::left ? Bone::leftThumbMetacarpal
                                                                       : Bone::rightThumbMetacarpal);
        const auto last =
            static_cast<std::size_t>(side == Side::left ? Bone::leftLittleDistal : Bone::rightLittleDistal);
        for (std::size_t i = first; i <= last; ++i)
            if (body.map.joint[i] >= 0)
                body.fingers[static_cast<std::size_t>(side)].push_back(
                    static_cast<std::size_t>(body.map.joint[i]));
    }
    return body;
}

}  // namespace deixis::motion
