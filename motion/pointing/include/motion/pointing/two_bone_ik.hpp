// Analytic inverse kinematics of two bones with a hinge between them: upper arm and forearm, thigh and
// shin. The hinge's angle sets the distance of the tip; the remaining freedom, the turn about the line to
// the tip, is set by a direction for the elbow (solveArm), or by keeping its side (reach).
#pragma once

#include "core/pose.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// Turns of the lower bone about the hinge, radians.
struct HingeTurn {
    double straightest = 0.0;  ///< at which the tip is farthest
    double opening = 0.0;      ///< from there, either way, at which it lies at the distance; 0 to pi
};

/// `upper` and `lower` are the bones, one behind the other, and `hinge` is a unit axis, in one frame. Where
/// the tip cannot come to the distance it comes as near as it can.
[[nodiscard]] HingeTurn turnForReach(const Vec3& upper, const Vec3& lower, const Vec3& hinge,
                                     double distance_m);

/// `upper` and `lower` are given at rest, in their own frames, metres. `hinge`: the axis, in the upper bone's
/// frame, about which the lower one bends where they are straight.
struct TwoBones {
    Vec3 upper{0.0};
    Vec3 lower{0.0};
    Vec3 hinge{1.0, 0.0, 0.0};
};

/// World rotations that bring the end of the lower bone to `goal` (from the start of the upper one), or as
/// near as it can come: first the angle between the bones is changed in the plane that they lie in, then both
/// turn together by the shortest way, so that the elbow's or knee's side is kept.
void reach(const TwoBones& bones, const Vec3& goal, Quat& upper, Quat& lower);

/// Elbow flexion is kept in this range: a straight elbow has no plane, and none bends backwards.
constexpr double min_flexion_rad = 0.10;
constexpr double max_flexion_rad = 2.5;

/// An arm in the frame of its T pose: the left one lies along +x, the right along -x, palm down; the elbow
/// bends about y and takes the forearm, with the hand, forward (+z).
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
