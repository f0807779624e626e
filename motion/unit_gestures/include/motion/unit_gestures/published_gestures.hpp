// What is published of how people gesture while they speak: the numbers that rule sets draw from, and that
// their motion is compared with.
#pragma once

#include <array>

#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::motion {

struct PublishedGestures {
    double strokes_per_minute = 67.0;  ///< in lectures: Shattuck-Hufnagel & Ren 2018
    double with_accent = 0.86;         ///< of strokes: JASA 2004 (195 strokes, one speaker)
    double beats_on_syllable =
        0.74;                    ///< apices of beats on the accented syllable, else later: Interspeech 2023
    double apex_mean_s = 0.017;  ///< apex after the accent: Loehr 2004, 2012
    double apex_sd_s = 0.341;    ///< the same
    double right_hand = 0.60;    ///< of strokes of one hand: Nicoladis & Shirazi 2021
    /// Of 600 gestures of narratives, by GestureClass: McNeill 1992. He does not count emblems.
    std::array<double, gesture_class_count> classes{261.0 / 600.0, 43.0 / 600.0, 28.0 / 600.0, 268.0 / 600.0,
                                                    0.0};
};

}  // namespace deixis::motion
