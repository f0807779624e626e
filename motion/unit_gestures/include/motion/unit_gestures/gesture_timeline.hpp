// Unit gestures one after another in time, each hand going on from where it is: what every rule set makes its
// motion with. Which gestures, when and how, is the rule set's own.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::motion {

/// A gesture in time.
struct PlacedGesture {
    UnitGesture gesture;  ///< as it is to be made: mirrored, moved and scaled already
    double apex_s = 0.0;  ///< when its first stroke ends
    double speed = 1.0;   ///< 1 as the library has it, up to 3
    double hold_s = 0.0;  ///< its last posture is kept so long after its own last key before the way back
};

struct TimelineOptions {
    /// Of a wrist seen from its shoulder, on the mean body; ways that would be faster are shortened. The
    /// trunk's turns and places that are passed without a stop add to it: 3 m/s in all.
    double max_hand_speed_m_s = 2.0;
    double min_preparation_s = 0.2;  ///< between a stroke and the next gesture's first posture
    double retraction_s = 0.65;      ///< least time from a posture to rest
    double min_rest_s = 0.4;         ///< rests that would be shorter are holds instead
};

/// A gesture as it came out.
struct MadeGesture {
    std::size_t index = 0;      ///< in the list that was given
    double begin_s = 0.0;       ///< its preparation begins
    double stroke_s = 0.0;      ///< its first stroke begins
    double apex_s = 0.0;        ///< its first stroke ends
    double stroke_end_s = 0.0;  ///< its last stroke ends
};

struct GestureTimeline {
    BodyTrack track;
    std::vector<MadeGesture> made;  ///< in order of their apices
};

/// Gestures in any order. Each channel goes on from where it is to the next gesture's posture; between it
/// holds, or rests where there is time for it. Relaxed at 0 and, a frame before `duration_s`, again. A
/// gesture that there is no time for, at the beginning, at the end or after the one before, is left out; a
/// head or a trunk that is busy leaves out its own part only.
[[nodiscard]] GestureTimeline timelineOf(const std::vector<PlacedGesture>& gestures, double duration_s,
                                         const TimelineOptions& options = {});

/// What a body does by itself: it sways and breathes, and never stands like a statue.
struct IdleOptions {
    double trunk_deg = 0.8;  ///< amplitudes
    double head_deg = 1.6;
    double hand = 0.012;  ///< arm lengths
    double ramp_s = 0.6;  ///< from the relaxed pose at the beginning, to it at the end
};

/// The motion of frameCountOf(duration_s) frames; the first and the last are relaxed. The same seed sways the
/// same way.
[[nodiscard]] UpperBodyMotion motionOf(const BodyTrack& track, double duration_s, std::uint64_t seed,
                                       const IdleOptions& idle = {});

}  // namespace deixis::motion
