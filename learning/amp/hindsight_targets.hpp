// Demonstrations as ones for what they do point at.
#pragma once

#include <vector>

#include "learning/amp/settings.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::learning {

/// The same demonstrations, each with the target that its line points at in the middle of its hold, as far
/// from the line's end as its own target. People point by eye and fingertip, so a forearm points elsewhere.
[[nodiscard]] std::vector<motion::Demonstration> withHindsightTargets(
    std::vector<motion::Demonstration> demonstrations, AmpTask task);

}  // namespace deixis::learning
