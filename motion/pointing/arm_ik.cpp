#include "motion/pointing/arm_ik.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace deixis::motion {

namespace {

/// Right-handed frame: first axis along `along`, second the part of `towards` across it.
glm::dmat3 frameOf(const Vec3& along, const Vec3& towards) {
    const Vec3 first = glm::normalize(along);
    const Vec3 second = glm::normalize(towards - glm::dot(towards, first) * first);
    return {first, second, glm::cross(first, second)};
}

}  // namespace

Quat elbowRotation(Side side, double flexion_rad) {
    const double angle = side == Side::left ? -flexion_rad : flexion_rad;
    return {std::cos(angle / 2.0), 0.0, std::sin(angle / 2.0), 0.0};
}

Vec3 tipInUpperArm(const TwoLinkArm& arm, double flexion_rad) {
    return arm.elbow + elbowRotation(arm.side, flexion_rad) * arm.tip;
}

double flexionForReach(const TwoLinkArm& arm, double reach_m) {
    // |elbow + R(angle) tip|^2 = reach^2 is c cos(angle) + s sin(angle) = rest, the turn being about y.
    const Vec3& a = arm.elbow;
    const Vec3& f = arm.tip;
    const double c = a.x * f.x + a.z * f.z;
    const double s = a.x * f.z - a.z * f.x;
    const double rest = (reach_m * reach_m - glm::dot(a, a) - glm::dot(f, f)) / 2.0 - a.y * f.y;
    const double amplitude = std::sqrt(c * c + s * s);
    const double opening = std::acos(std::clamp(rest / amplitude, -1.0, 1.0));
    const double straightest = std::atan2(s, c);  // turn about y at which the tip is farthest
    const double flexion = arm.side == Side::left ? -(straightest - opening) : straightest + opening;
    return std::clamp(flexion, least_flexion_rad, greatest_flexion_rad);
}

ArmSolution solveArm(const TwoLinkArm& arm, const Vec3& tip, const Vec3& elbow_direction) {
    ArmSolution solution;
    solution.flexion_rad = flexionForReach(arm, glm::length(tip));
    // Across the tip's direction in the plane of the hinge: unlike the elbow's own place this stays a
    // direction when the arm is straight.
    const Vec3 in_arm_tip = tipInUpperArm(arm, solution.flexion_rad);
    const Vec3 hinge(0.0, arm.side == Side::left ? 1.0 : -1.0, 0.0);
    const glm::dmat3 in_arm = frameOf(in_arm_tip, glm::cross(hinge, in_arm_tip));
    const glm::dmat3 wanted = frameOf(tip, elbow_direction);
    solution.upper_arm = glm::normalize(glm::quat_cast(wanted * glm::transpose(in_arm)));
    return solution;
}

}  // namespace deixis::motion
