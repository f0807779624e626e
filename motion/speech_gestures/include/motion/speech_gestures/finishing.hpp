// What may be done to a motion when it is made: hands that come to rest at its end, and a body that stands
// still where it does not gesture.
#pragma once

#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

/// From frame `first` to the last one the motion passes to `pose`, each direction along its arc, along a
/// minimum-jerk course. Nothing where `first` is not before the last frame.
void fadeTo(UpperBodyMotion& motion, std::size_t first, const UpperBodyPose& pose);

/// Stretches of at least half a second in which both wrists are slower than 0.15 m/s become one pose, the one
/// in their middle; it is reached and left within 4 frames of a stretch's ends.
void holdStill(UpperBodyMotion& motion);

}  // namespace deixis::motion
