#include "motion/pointing/two_bone_ik.hpp"

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

// Below this bend, radians, the plane of the bones is mostly noise.
constexpr double straight_rad = 0.15;

}  // namespace

HingeTurn turnForReach(const Vec3& upper, const Vec3& lower, const Vec3& hinge, double distance_m) {
    // |upper + R(angle) lower|^2 = distance^2 is c cos(angle) + s sin(angle) = rest: only what lies across
    // the hinge turns.
    const double upper_along = glm::dot(upper, hinge);
    const double lower_along = glm::dot(lower, hinge);
    const Vec3 a = upper - upper_along * hinge;
    const Vec3 f = lower - lower_along * hinge;
    const double c = glm::dot(a, f);
    const double s = glm::dot(hinge, glm::cross(f, a));
    const double rest = (distance_m * distance_m - glm::dot(upper, upper) - glm::dot(lower, lower)) / 2.0 -
                        upper_along * lower_along;
    const double amplitude = std::sqrt(c * c + s * s);
    return {std::atan2(s, c), std::acos(std::clamp(rest / amplitude, -1.0, 1.0))};
}

void reach(const TwoBones& bones, const Vec3& goal, Quat& upper, Quat& lower) {
    const double a = glm::length(bones.upper);
    const double b = glm::length(bones.lower);
    if (a < 1e-6 || b < 1e-6 || glm::length(goal) < 1e-6) return;
    const Vec3 u = upper * bones.upper;
    const Vec3 v = lower * bones.lower;
    Vec3 hinge = glm::cross(u, v);
    if (std::atan2(glm::length(hinge), glm::dot(u, v)) <= straight_rad) {
        const Vec3 along = u / a;
        hinge = upper * bones.hinge;
        hinge -= glm::dot(hinge, along) * along;
    }
    hinge = glm::normalize(hinge);
    // Folded to nothing, the bones would have no direction.
    auto [straightest, opening] =
        turnForReach(u, v, hinge, std::max(glm::length(goal), std::abs(a - b) + 1e-6));
    if (straightest > 0.0 && opening < straight_rad) opening = -opening;  // overstretched stays overstretched
    lower = glm::angleAxis(straightest + opening, hinge) * lower;
    const Quat turn = rotationBetween(u + lower * bones.lower, goal);
    upper = glm::normalize(turn * upper);
    lower = glm::normalize(turn * lower);
}

Quat elbowRotation(Side side, double flexion_rad) {
    const double angle = side == Side::left ? -flexion_rad : flexion_rad;
    return {std::cos(angle / 2.0), 0.0, std::sin(angle / 2.0), 0.0};
}

Vec3 tipInUpperArm(const TwoLinkArm& arm, double flexion_rad) {
    return arm.elbow + elbowRotation(arm.side, flexion_rad) * arm.tip;
}

double flexionForReach(const TwoLinkArm& arm, double reach_m) {
    const HingeTurn turn = turnForReach(arm.elbow, arm.tip, up, reach_m);
    const double flexion =
        arm.side == Side::left ? -(turn.straightest - turn.opening) : turn.straightest + turn.opening;
    return std::clamp(flexion, min_flexion_rad, max_flexion_rad);
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
