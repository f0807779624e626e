// Gestures made a little differently.
#pragma once

#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::motion {

/// Each hand's places `size` times as far from their own middle, and moved by out, up and ahead (arm lengths,
/// for both hands alike); held within the arm's reach. Head and trunk turn `size` times as far.
[[nodiscard]] UnitGesture varied(const UnitGesture& gesture, double size, const Vec3& move);

/// A nod of the head alone, of half a second: down by so many degrees, and back.
[[nodiscard]] UnitGesture smallNod(double depth_deg);

}  // namespace deixis::motion
