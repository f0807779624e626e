// Analytic inverse kinematics of an arm: two links, the upper arm and the forearm with the hand, hinged at
// the elbow.
//
// The arm is given in the frame of its T pose: the left arm lies along +x, the right along -x, palm down; the
// elbow bends about y and takes the forearm forward (+z).
#pragma once

#include "core/pose.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// Elbow flexion is kept in this range: a straight elbow has no plane, and none bends backwards.
constexpr double least_flexion_rad = 0.10;
constexpr double greatest_flexion_rad = 2.5;

struct TwoLinkArm {
    Side side = Side::right;
    Vec3 elbow{0.0};  ///< shoulder to elbow in the upper arm's frame, metres
    Vec3 tip{0.0};    ///< elbow to tip in the forearm's frame at no flexion, metres
};

struct ArmSolution {
    Quat upper_arm{1.0, 0.0, 0.0, 0.0};  ///< orientation in the frame in which the tip was asked for
    double flexion_rad = 0.0;            ///< of the elbow, 0 straight
};

/// Rotation of the elbow by a flexion, in the upper arm's frame.
[[nodiscard]] Quat elbowRotation(Side side, double flexion_rad);

/// Tip as seen from the shoulder, in the upper arm's frame.
[[nodiscard]] Vec3 tipInUpperArm(const TwoLinkArm& arm, double flexion_rad);

/// The flexion that brings the tip to a distance from the shoulder; clamped to the range above where it
/// cannot.
[[nodiscard]] double flexionForReach(const TwoLinkArm& arm, double reach_m);

/// Lays the tip at `tip` (relative to the shoulder; scaled to the nearest reachable distance) with the point
/// of the elbow towards `elbow_direction` (any direction not along the tip's).
[[nodiscard]] ArmSolution solveArm(const TwoLinkArm& arm, const Vec3& tip, const Vec3& elbow_direction);

}  // namespace deixis::motion
