// What an observer sees in a clip of a pointing gesture, without a session.
#pragma once

#include <optional>

#include "motion/skeleton/clip.hpp"
#include "studies/observers/observer.hpp"

namespace deixis::studies {

struct ObservedGesture {
    ArmLines hold{};   ///< mean over the hold
    ArmLines first{};  ///< when it begins
    ArmLines last{};   ///< and when it ends
};

/// Watches the clip on its avatar as a simulated participant does, whose rule finds hand and hold. None where
/// an arm has no direction. Throws std::invalid_argument if the avatar lacks the joints of head, trunk or
/// an arm.
[[nodiscard]] std::optional<ObservedGesture> observeGesture(const motion::Clip& clip, const Reading& reading);

}  // namespace deixis::studies
