#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "arm_twist.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "reference_points.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

/// Rotation that takes the direction `from_first` to `to_first` exactly, and `from_second` into the
/// half-plane of `to_first` and `to_second`.
Quat turnOfAxes(const Vec3& from_first, const Vec3& from_second, const Vec3& to_first,
                const Vec3& to_second) {
    const auto axes = [](const Vec3& first, const Vec3& second) {
        const Vec3 x = glm::normalize(first);
        const Vec3 y = glm::normalize(second - glm::dot(second, x) * x);
        return glm::dmat3(x, y, glm::cross(x, y));
    };
    return glm::normalize(
        glm::quat_cast(axes(to_first, to_second) * glm::transpose(axes(from_first, from_second))));
}

struct Trunk {
    Quat spine{1.0, 0.0, 0.0, 0.0}, chest{1.0, 0.0, 0.0, 0.0}, upper_chest{1.0, 0.0, 0.0, 0.0};
};

/// The trunk bends more and more upwards. The line from spine to neck says how it leans, the shoulders where
/// it faces; how they rise is their own.
Trunk trunkOf(const UpperBodyPose& pose) {
    const Vec3 rest_rise = restOffset(chest) + restOffset(upperChest) + restOffset(neck);
    const Vec3 rise = pose[UpperBone::neck];
    // The topmost bone leans farther than the whole line does.
    constexpr double lean_of_top = 1.5;
    const Quat lean = rotationBetween(rest_rise, rise);
    const double half_rad = std::acos(std::clamp(lean.w, -1.0, 1.0));
    const double sine = std::sin(half_rad);
    constexpr double most_rad = 2.5;  // lying on the back is no pose of these
    const double top_rad = std::min(lean_of_top * 2.0 * half_rad, most_rad);
    const Vec3 top_rise =
        sine > 1e-9 ? glm::angleAxis(top_rad, Vec3(lean.x, lean.y, lean.z) / sine) * rest_rise : rest_rise;
    const Vec3 along = glm::normalize(top_rise);
    constexpr double weight_of_front = 0.02;  // shoulders above each other tell no front
    Vec3 shoulders = pose[UpperBone::left_shoulder] - pose[UpperBone::right_shoulder];
    shoulders += weight_of_front * Vec3(1.0, 0.0, 0.0);
    if (glm::length(glm::cross(shoulders, along)) < 1e-6) shoulders = glm::cross(along, Vec3(0.0, 0.0, 1.0));
    Trunk trunk;
    trunk.upper_chest = turnOfAxes(rest_rise, Vec3(1.0, 0.0, 0.0), along, shoulders);
    trunk.spine = glm::slerp(no_rotation, trunk.upper_chest, 1.0 / 3.0);
    trunk.chest = glm::slerp(no_rotation, trunk.upper_chest, 2.0 / 3.0);
    const Vec3 found = trunk.spine * restOffset(chest) + trunk.chest * restOffset(upperChest) +
                       trunk.upper_chest * restOffset(neck);
    const Quat rest_of_way = rotationBetween(found, rise);
    for (Quat* turn : {&trunk.spine, &trunk.chest, &trunk.upper_chest}) *turn = rest_of_way * *turn;
    return trunk;
}

/// The shoulder blade's bone, so that the upper arm starts in this direction from the neck.
Quat shoulderOf(Bone shoulder, Bone upper_arm, const Quat& upper_chest, const Vec3& from_neck) {
    const Vec3 start = upper_chest * (restOffset(shoulder) - restOffset(neck));
    const Vec3 bone = upper_chest * restOffset(upper_arm);
    // Where the ray from the neck meets the sphere about the bone's start, within which the neck lies.
    const double middle = glm::dot(start, from_neck);
    const double under_root = middle * middle - glm::dot(start, start) + glm::dot(bone, bone);
    const Vec3 end = (middle + std::sqrt(std::max(under_root, 0.0))) * from_neck;
    return rotationBetween(bone, end - start) * upper_chest;
}

struct HeadTurns {
    Quat neck{1.0, 0.0, 0.0, 0.0}, head{1.0, 0.0, 0.0, 0.0};
};

/// The line from nose to head top leans the head, the nose turns it; the neck bends as is left.
HeadTurns headOf(const UpperBodyPose& pose, const Quat& upper_chest) {
    const Vec3 rest_face = top_in_head - nose_in_head;
    const Vec3 face = pose[UpperBone::head_top];
    const Vec3 to_nose = pose[UpperBone::nose];
    // In one line both tell no side: the chest's takes over by and by.
    constexpr double clear_sine = 0.4;
    const Vec3 seen_side = glm::cross(face, to_nose);
    const double unclear = std::max(0.0, clear_sine - glm::length(seen_side));
    Vec3 side = seen_side + unclear * (upper_chest * Vec3(1.0, 0.0, 0.0));
    if (glm::length(glm::cross(side, face)) < 1e-6)
        side = glm::cross(face, upper_chest * Vec3(0.0, 0.0, 1.0));
    if (glm::length(glm::cross(side, face)) < 1e-6) side = glm::cross(face, upper_chest * up);
    HeadTurns turns;
    turns.head = turnOfAxes(rest_face, Vec3(1.0, 0.0, 0.0), face, side);
    // Where the head starts: as far from the neck as it is, and so that the nose lies on its line.
    const Vec3 nose = turns.head * nose_in_head;
    const double middle = glm::dot(to_nose, nose);
    const double under_root =
        middle * middle - glm::dot(nose, nose) + glm::dot(restOffset(head), restOffset(head));
    const Vec3 start = (middle + std::sqrt(std::max(under_root, 0.0))) * to_nose - nose;
    turns.neck = glm::slerp(upper_chest, turns.head, 0.5);
    if (glm::length(start) > 1e-6)
        turns.neck = rotationBetween(turns.neck * restOffset(head), start) * turns.neck;
    return turns;
}

}  // namespace

LocalPose avatarPose(const UpperBodyPose& pose) {
    static const LocalPose relaxed = relaxedPose(referenceHumanoid());
    LocalPose out = relaxed;
    std::array<Quat, bone_count> world;
    world.fill(no_rotation);
    const auto set = [&](Bone bone, const Quat& turn) {
        world[indexOf(bone)] = turn;
        const auto parent = static_cast<std::size_t>(referenceHumanoid().joints[indexOf(bone)].parent);
        out.joints[indexOf(bone)].orientation = glm::normalize(glm::conjugate(world[parent]) * turn);
    };
    const Trunk trunk = trunkOf(pose);
    set(spine, trunk.spine);
    set(chest, trunk.chest);
    set(upperChest, trunk.upper_chest);
    const HeadTurns head_turns = headOf(pose, trunk.upper_chest);
    set(neck, head_turns.neck);
    set(head, head_turns.head);
    for (const Side side : {Side::left, Side::right}) {
        const bool left = side == Side::left;
        const ArmBones arm = armBones(side);
        set(arm.shoulder, shoulderOf(arm.shoulder, arm.upper_arm, trunk.upper_chest,
                                     pose[left ? UpperBone::left_shoulder : UpperBone::right_shoulder]));
        const ArmTurns turns = armTurns(side, trunk.upper_chest,
                                        pose[left ? UpperBone::left_upper_arm : UpperBone::right_upper_arm],
                                        pose[left ? UpperBone::left_forearm : UpperBone::right_forearm]);
        set(arm.upper_arm, turns.upper_arm);
        set(arm.lower_arm, turns.forearm);
        out.joints[indexOf(arm.hand)].orientation = turns.hand_in_forearm;
    }
    return out;
}

}  // namespace deixis::motion
