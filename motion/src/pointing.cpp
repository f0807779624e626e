#include "motion/pointing.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

struct Named {
    PointingRay kind;
    std::string_view name;
};
constexpr std::array<Named, 4> names{{{PointingRay::eye_fingertip, "eye-fingertip"},
                                      {PointingRay::index_finger, "index-finger"},
                                      {PointingRay::forearm, "forearm"},
                                      {PointingRay::shoulder_hand, "shoulder-hand"}}};

Vec3 position(const std::vector<Pose>& world, int joint) {
    return world[static_cast<std::size_t>(joint)].position;
}

}  // namespace

std::string_view pointingRayName(PointingRay ray) {
    return names[static_cast<std::size_t>(ray)].name;
}

Result<PointingRay> pointingRayFromName(std::string_view name) {
    for (const Named& named : names)
        if (named.name == name) return named.kind;
    return fail("", "unknown pointing ray '" + std::string(name) + "'",
                "Expected eye-fingertip, index-finger, forearm or shoulder-hand");
}

Vec3 eyePosition(const HumanoidMap& map, const std::vector<Pose>& world) {
    if (map.has(Bone::leftEye) && map.has(Bone::rightEye))
        return 0.5 * (position(world, map[Bone::leftEye]) + position(world, map[Bone::rightEye]));
    return position(world, map[Bone::head]);
}

Vec3 fingertipPosition(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world,
                       Side side) {
    const ArmBones arm = armBones(side);
    for (const Bone bone : {arm.index_distal, arm.index_intermediate, arm.index_proximal})
        if (map.has(bone)) return tipPosition(skeleton, world, map[bone]);
    return position(world, map[arm.hand]);
}

Ray pointingRay(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world, Side side,
                PointingRay kind) {
    const ArmBones arm = armBones(side);
    Vec3 from{0.0};
    Vec3 to{0.0};
    switch (kind) {
        case PointingRay::eye_fingertip:
            from = eyePosition(map, world);
            to = fingertipPosition(skeleton, map, world, side);
            break;
        case PointingRay::index_finger:
            from =
                position(world, map.has(arm.index_proximal) ? map[arm.index_proximal] : map[arm.lower_arm]);
            to = fingertipPosition(skeleton, map, world, side);
            break;
        case PointingRay::forearm:
            from = position(world, map[arm.lower_arm]);
            to = position(world, map[arm.hand]);
            break;
        case PointingRay::shoulder_hand:
            from = position(world, map[arm.upper_arm]);
            to = position(world, map[arm.hand]);
            break;
    }
    return {to, glm::normalize(to - from)};
}

double angularError(const Ray& ray, const Vec3& target) {
    return angleBetween(ray.direction, target - ray.origin);
}

double pointingReward(const Vec3& elbow, const Vec3& hand, const Vec3& target) {
    const double e = std::exp(1.0);
    const double theta = 1.0 - angleBetween(target - hand, hand - elbow) / pi;
    return (std::exp(theta) - 1.0) / e;
}

}  // namespace deixis::motion
