#include "motion/pointing/rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace deixis::motion {

namespace {

struct Named {
    PointingRay kind;
    std::string_view name;
};
constexpr std::array<Named, 7> names{{{PointingRay::eye_fingertip, "eye-fingertip"},
                                      {PointingRay::index_finger, "index-finger"},
                                      {PointingRay::forearm, "forearm"},
                                      {PointingRay::shoulder_hand, "shoulder-hand"},
                                      {PointingRay::shoulder_fingertip, "shoulder-fingertip"},
                                      {PointingRay::elbow_fingertip, "elbow-fingertip"},
                                      {PointingRay::head, "head"}}};

Vec3 position(const std::vector<Pose>& world, int joint) {
    return world[static_cast<std::size_t>(joint)].position;
}

Vec3 direction(const Vec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : Vec3(0.0);
}

}  // namespace

std::string_view pointingRayName(PointingRay ray) {
    return names[static_cast<std::size_t>(ray)].name;
}

Result<PointingRay> pointingRayFromName(std::string_view name) {
    for (const Named& named : names)
        if (named.name == name) return named.kind;
    return fail("", "unknown pointing ray '" + std::string(name) + "'",
                "Expected eye-fingertip, index-finger, forearm, shoulder-hand, shoulder-fingertip, "
                "elbow-fingertip or head");
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
        case PointingRay::shoulder_fingertip:
            from = position(world, map[arm.upper_arm]);
            to = fingertipPosition(skeleton, map, world, side);
            break;
        case PointingRay::elbow_fingertip:
            from = position(world, map[arm.lower_arm]);
            to = fingertipPosition(skeleton, map, world, side);
            break;
        case PointingRay::head:
            return {eyePosition(map, world), headDirection(skeleton, map, world)};
    }
    return {to, direction(to - from)};
}

Vec3 headDirection(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world) {
    const std::vector<Pose> rest = worldPose(skeleton, restPose(skeleton));
    const bool arms = map.has(Bone::leftUpperArm) && map.has(Bone::rightUpperArm);
    const Vec3 left = position(rest, map[arms ? Bone::leftUpperArm : Bone::leftUpperLeg]) -
                      position(rest, map[arms ? Bone::rightUpperArm : Bone::rightUpperLeg]);
    const Vec3 upward = position(rest, map[Bone::head]) - position(rest, map[Bone::hips]);
    const auto head = static_cast<std::size_t>(map[Bone::head]);
    const Quat world_from_rest = world[head].orientation * glm::conjugate(rest[head].orientation);
    return direction(world_from_rest * glm::cross(left, upward));
}

RayDistance distanceToRay(const Ray& ray, const Vec3& point) {
    const Vec3 to = point - ray.origin;
    const double along = glm::dot(to, ray.direction);
    if (along < 0.0) return {glm::length(to), true};
    return {glm::length(to - along * ray.direction), false};
}

std::optional<BallChoice> chosenBall(const Ray& ray, const std::vector<Vec3>& balls) {
    if (balls.empty()) return std::nullopt;
    BallChoice choice{0, angularError(ray, balls.front()), {}};
    double next = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < balls.size(); ++i) {
        const double error = angularError(ray, balls[i]);
        if (error < choice.error_rad) {
            next = choice.error_rad;
            choice.ball = i;
            choice.error_rad = error;
        } else {
            next = std::min(next, error);
        }
    }
    if (balls.size() > 1) choice.margin_rad = next - choice.error_rad;
    return choice;
}

double angularError(const Ray& ray, const Vec3& target) {
    return angleBetween(ray.direction, target - ray.origin);
}

double pointingReward(const Vec3& elbow, const Vec3& hand, const Vec3& target) {
    return pointingReward(Ray{hand, hand - elbow}, target);
}

double pointingReward(const Ray& line, const Vec3& target) {
    const double e = std::exp(1.0);
    const double theta = 1.0 - angleBetween(target - line.origin, line.direction) / pi;
    return (std::exp(theta) - 1.0) / e;
}

}  // namespace deixis::motion
