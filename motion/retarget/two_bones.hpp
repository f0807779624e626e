// Two bones in a row (thigh and shin, upper arm and forearm) brought to reach a point; private to
// retargeting.
#pragma once

#include "core/pose.hpp"

namespace deixis::motion {

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

}  // namespace deixis::motion
