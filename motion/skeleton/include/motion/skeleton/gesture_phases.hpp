// The phases of a pointing gesture, in frames of a clip.
#pragma once

#include <fmt/core.h>

#include "core/error.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// Frames count from 0; 0 <= onset < peak <= hold < end < frame count.
struct GesturePhases {
    Side hand = Side::right;
    int onset_frame = 0;  ///< the hand leaves its rest
    int peak_frame = 0;   ///< the pointing posture is reached
    int hold_frame = 0;   ///< last frame of the pointing posture; the hand starts back
    int end_frame = 0;    ///< the hand is back at rest
};

/// Fails, with the frames found, where a gesture's frames are out of order or not in a clip of this many.
[[nodiscard]] inline Result<void> checkPhases(const GesturePhases& p, int frame_count) {
    if (0 <= p.onset_frame && p.onset_frame < p.peak_frame && p.peak_frame <= p.hold_frame &&
        p.hold_frame < p.end_frame && p.end_frame < frame_count)
        return {};
    return fail(
        "",
        fmt::format("found a gesture with onset {}, peak {}, hold {} and end {} in a clip of {} frames",
                    p.onset_frame, p.peak_frame, p.hold_frame, p.end_frame, frame_count),
        "Expected 0 <= onset < peak <= hold < end, all within the clip; frames count from 0");
}

}  // namespace deixis::motion
