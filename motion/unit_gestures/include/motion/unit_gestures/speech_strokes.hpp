// Strokes of gestures beside the speech that they go with, and their statistics: of any rule set.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/utterance.hpp"
#include "motion/unit_gestures/published_gestures.hpp"

namespace deixis::motion {

enum class Hands : unsigned char { none, right, left, both };
/// Which hands a gesture moves.
[[nodiscard]] Hands handsOf(const UnitGesture& gesture);

struct SpeechStroke {
    std::string gesture;  ///< its id
    GestureClass gesture_class = GestureClass::beat;
    Hands hands = Hands::right;
    double begin_s = 0.0;  ///< the hand sets out
    double stroke_s = 0.0;
    double apex_s = 0.0;
    int word = 0;                 ///< index of the word that it goes with
    std::optional<int> accent{};  ///< index of the accent that it goes with
    bool by_word_rule = false;
};

/// A speech's motion, frameCountOf(its duration) frames, and what is in it.
struct GesturedSpeech {
    UpperBodyMotion motion;
    std::vector<SpeechStroke> strokes;  ///< in order of their apices
};

/// The numbers of PublishedGestures, measured. Those of nothing are 0.
struct StrokeStatistics {
    int strokes = 0;  ///< of hands; a head that nods is not counted
    double strokes_per_minute = 0.0;
    double with_accent = 0.0;
    double beats_on_syllable = 0.0;  ///< of the beats with an accent
    double apex_mean_s = 0.0;        ///< against the middle of the accent
    double apex_sd_s = 0.0;          ///< over n
    double right_hand = 0.0;         ///< of strokes of one hand
    std::array<double, gesture_class_count> classes{};
};
/// As many speeches as utterances.
[[nodiscard]] StrokeStatistics strokeStatistics(std::span<const Utterance> utterances,
                                                std::span<const std::vector<SpeechStroke>> strokes);

}  // namespace deixis::motion
