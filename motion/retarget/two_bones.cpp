#include "two_bones.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

// Below this bend, radians, the plane of the bones is mostly noise.
constexpr double straight_rad = 0.15;

}  // namespace

void reach(const TwoBones& bones, const Vec3& goal, Quat& upper, Quat& lower) {
    const double a = glm::length(bones.upper);
    const double b = glm::length(bones.lower);
    const double distance = std::clamp(glm::length(goal), std::abs(a - b) + 1e-6, a + b);
    if (a < 1e-6 || b < 1e-6 || glm::length(goal) < 1e-6) return;
    const Vec3 u = upper * bones.upper;
    const Vec3 v = lower * bones.lower;
    Vec3 axis = glm::cross(u, v);
    double bend = std::atan2(glm::length(axis), glm::dot(u, v));
    if (bend > straight_rad) {
        axis = glm::normalize(axis);
    } else {
        const Vec3 along = u / a;
        axis = upper * bones.hinge;
        axis = glm::normalize(axis - glm::dot(axis, along) * along);
        bend = std::atan2(glm::dot(axis, glm::cross(u, v)), glm::dot(u, v));
    }
    double wanted = std::acos(std::clamp((distance * distance - a * a - b * b) / (2.0 * a * b), -1.0, 1.0));
    if (bend < 0.0 && wanted < straight_rad) wanted = -wanted;  // overstretched stays overstretched
    lower = glm::angleAxis(wanted - bend, axis) * lower;
    const Quat turn = rotationBetween(u + lower * bones.lower, goal);
    upper = glm::normalize(turn * upper);
    lower = glm::normalize(turn * lower);
}

}  // namespace deixis::motion
