// Hand shapes of Deixis's own avatar.
#pragma once

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// Sets the finger joints of one hand, and no others: at 0 the relaxed hand of relaxedPose(), at 1 the index
/// finger stretched with the other fingers and the thumb closed; between, each joint turns by the shorter
/// arc. `amount` is clamped to [0, 1]. The pose must be one of referenceHumanoid(); wrist and arm stay.
void applyPointingHand(LocalPose& pose, Side side, double amount);

}  // namespace deixis::motion
