// The pose of an upper body in which one arm points at something.
#pragma once

#include "core/error.hpp"
#include "motion/skeleton/humanoid.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::server {

/// What is nearer to the shoulder cannot be pointed at.
inline constexpr double nearest_target_m = 0.3;

struct PointingPose {
    motion::UpperBodyPose pose;
    /// Angle between the line from the eyes over the fingertip and the target, of Deixis's avatar in this
    /// pose.
    double off_deg = 0.0;
};

/// `body` with another upper arm and forearm: the arm almost straight, the fingertip on the line from between
/// the eyes to the target, as people point (Herbort & Kunde 2015), the elbow down and out. An arm goes 50
/// degrees across the body and 30 behind it: beyond, it comes as near as that, and off_deg tells how near.
/// `target_m`: the avatar's axes; its feet at the origin, facing +z. Fails where it is nearer than
/// nearest_target_m to the shoulder.
[[nodiscard]] Result<PointingPose> pointingPose(const motion::UpperBodyPose& body, motion::Side side,
                                                const Vec3& target_m);

}  // namespace deixis::server
