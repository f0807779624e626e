// Poses of the avatar as joint angles of its body, and back.
//
// The body has one joint where an avatar has several: spine, chest and upper chest are its trunk, neck and
// head its neck, and the shoulder girdle stays as it is. An arm's direction is kept, its elbow a hinge; what
// the body does not have (shoulder girdle, the forearm's turn, wrist, fingers, eyes) a pose keeps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/skeleton/clip.hpp"
#include "physics/figure/figure.hpp"

namespace deixis::physics {

/// The place and orientation of the avatar's hips: the body's pelvis.
[[nodiscard]] Pose rootOf(const Figure& figure, const motion::LocalPose& pose);

/// How near the body comes to a pose.
struct PoseFit {
    std::vector<double> angles_rad;  ///< one for each hinge, within its limits
    double beyond_rad = 0.0;         ///< how far a hinge would have to go beyond its limits, at most
    std::size_t beyond_hinge = 0;    ///< which one
    double distance_m = 0.0;         ///< between the body's elbows and wrists and the avatar's, the largest
};

/// The body's nearest angles, joint by joint: trunk, neck, upper arms, thighs and feet are turned as the
/// avatar's, elbows and knees bent as far. Exact (1e-9 rad) where the pose is one of the body.
[[nodiscard]] PoseFit fitPose(const Figure& figure, const motion::LocalPose& pose);

/// Turns a pose so that its angles become those. What the body does not have stays; several joints that are
/// one of the body's share in the change.
void applyAngles(const Figure& figure, std::span<const double> angles_rad, motion::LocalPose& pose);
/// Moves and turns the hips.
void applyRoot(const Figure& figure, const Pose& root, motion::LocalPose& pose);

/// Forward kinematics: where each segment's joint is, and how it is turned.
[[nodiscard]] std::vector<Pose> segmentPoses(const Figure& figure, const Pose& root,
                                             std::span<const double> angles_rad);

}  // namespace deixis::physics
