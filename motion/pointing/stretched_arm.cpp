#include "motion/pointing/stretched_arm.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/pointing/rays.hpp"

namespace deixis::motion {

Side handFor(const Vec3& target) {
    return target.x > 0.0 ? Side::left : Side::right;
}

StretchedArm stretchedArm(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world,
                          Side side, const Vec3& target) {
    const ArmBones bones = armBones(side);
    const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(map[bone])].position; };
    const Vec3 shoulder = at(bones.upper_arm);
    const Vec3 elbow = at(bones.lower_arm);
    const Vec3 hand = at(bones.hand);
    const double length_m = glm::length(elbow - shoulder) + glm::length(hand - elbow) +
                            glm::length(fingertipPosition(skeleton, map, world, side) - hand);

    const auto straight = [&](const Vec3& from, double way_m) {
        const Vec3 there = target - from;
        const double all_m = glm::length(there);
        return way_m < all_m ? from + way_m / all_m * there : target;
    };
    const Vec3 eye = eyePosition(map, world);
    const Vec3 sight = glm::normalize(target - eye);
    const Vec3 from_shoulder = eye - shoulder;
    const double middle = -glm::dot(from_shoulder, sight);  // the line's nearest to the shoulder
    const double under_root = middle * middle - glm::dot(from_shoulder, from_shoulder) + length_m * length_m;
    const double way_m = middle + std::sqrt(std::max(under_root, 0.0));
    if (under_root < 0.0 || way_m <= 0.0) return {shoulder, straight(shoulder, length_m)};
    return {shoulder, straight(eye, way_m)};
}

}  // namespace deixis::motion
