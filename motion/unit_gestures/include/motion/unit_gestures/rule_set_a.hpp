// Rule set A: gestures to a speech by its words and accents. It is one of two that were written apart, so
// that a model that learned from one can be tried on the other.
//
// From accent to accent it keeps count of the strokes that are due, takes strong accents first, and gives a
// word that has a rule its gesture, centred on the word. Other strokes get a class, so that McNeill's
// proportions come out, and of that class mostly the gesture that the word has as its habit; plain words only
// get beats. Hands stay the same within a phrase.
#pragma once

#include <cstdint>

#include "motion/unit_gestures/gesture_timeline.hpp"
#include "motion/unit_gestures/speech_strokes.hpp"
#include "motion/unit_gestures/word_rules.hpp"

namespace deixis::motion {

struct RuleSetA {
    PublishedGestures published{};

    // Assumptions of ours, [low, high] drawn from evenly, (mean, SD) normally, unless said otherwise.
    double phrase_pause_s =
        0.35;                  ///< a pause between words so long begins a new phrase, with a hand of its own
    double rule_used = 0.75;   ///< of the accented words that have a rule, where a stroke is due
    double habit_used = 0.7;   ///< the word's own gesture of a class; else any
    double other_hand = 0.08;  ///< strokes of one hand that are made by the other than the phrase's
    double drawn_on_syllable = 0.64;  ///< of the apices of beats, such that the published share is made
    double late_mean_s = 0.12;        ///< the others are so much later
    /// Of other apices against the middle of their accent, such that beats and others together are as
    /// published.
    double apex_mean_s = -0.20, apex_sd_s = 0.51;
    double lag_kept = 0.8;  ///< correlation of that from stroke to stroke
    /// Strokes that are asked for, to one that there is time for.
    double asked_with_accent = 1.6, asked_without = 1.15;
    double slowest = 1.15, fastest = 1.6;                  ///< speed of a gesture
    double hurried = 2.6;                                  ///< where there is less time
    double shortest_hold_s = 0.05, longest_hold_s = 0.45;  ///< no figure for holds was found
    double size_sd = 0.08;                                 ///< of a gesture, about 1
    double place_sd = 0.04;                                ///< arm lengths, each way
    /// Iconics in the centre, metaphorics lower, deictics at the periphery (McNeill 1992): arm lengths and
    /// size.
    double metaphoric_lower = 0.06, deictic_size = 1.06;
    double nod = 0.30;  ///< of the accents without a gesture of the head
    double shallowest_nod_deg = 3.0, deepest_nod_deg = 8.0;
    TimelineOptions timeline{};
    IdleOptions idle{};
};

/// The same utterance, library, rules and seed give the same bits. The library has the gestures that the
/// rules name (checkWordRules()) and at least one beat.
[[nodiscard]] GesturedSpeech gesturesByRuleSetA(const Utterance& utterance, const GestureLibrary& library,
                                                std::uint64_t seed, const WordRules& rules = usualWordRules(),
                                                const RuleSetA& numbers = {});

}  // namespace deixis::motion
