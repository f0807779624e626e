// A request, checked, and as a row of controls for each frame.
#pragma once

#include <vector>

#include "motion/speech_gestures/speech_gestures.hpp"

namespace deixis::motion {

/// `frames`: of the motion that is asked for.
[[nodiscard]] Result<void> checkRequest(const SpeechGestureRequest& request, std::size_t frames,
                                        bool takes_controls);

/// The poses asked for, with those that are kept: each frame is there once, in order.
[[nodiscard]] std::vector<PoseControl> allPoses(const SpeechGestureRequest& request, std::size_t frames);

/// One a frame; unset elements are drawn where variety is asked for.
[[nodiscard]] std::vector<StyleControl> allStyles(const SpeechGestureRequest& request, std::size_t frames);

/// Whether a frame is to be made, frame by frame.
[[nodiscard]] std::vector<bool> changedFrames(const SpeechGestureRequest& request, std::size_t frames);

}  // namespace deixis::motion
