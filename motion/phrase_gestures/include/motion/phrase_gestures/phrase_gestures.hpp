// A second speaker by rules, for the synthetic corpus: it plans by phrases, not by words. A phrase of speech
// has one gesture, whose posture is held while beats go on in it. Written apart from any other rule set, so
// that a model trained on one can be judged on a speaker that it has never seen; only the library of unit
// gestures and the timeline are shared.
//
// Its rates and times are drawn from what was published about people (named at each number); where nothing
// was found, the number is a choice and says so. It is synthetic all the same.
#pragma once

#include <cstdint>
#include <string_view>

#include "motion/unit_gestures/speech_strokes.hpp"

namespace deixis::motion {

struct PhraseSpeaker {
    // How much.
    double strokes_per_min = 67.0;    ///< Shattuck-Hufnagel & Ren 2018, lectures
    double share_with_accent = 0.86;  ///< of strokes (JASA 2004, 195 strokes of one speaker)
    /// Apices are at least so far apart: a choice, so that a beat has 0.2 s to rise and 0.2 s to fall.
    double min_apex_gap_s = 0.46;

    // When.
    double beat_on_syllable = 0.74;   ///< share of beats whose apex is on the accented syllable, others come
                                      ///< later (Interspeech 2023, 107-111)
    double beat_delay_s = 0.14;       ///< mean of how much later, from the syllable's end: a choice
    double apex_offset_s = -0.25;     ///< of other strokes, from the accent's middle: so that with the late
                                      ///< beats the mean of all is Loehr's (2004, from memory) 0.017 s
    double apex_offset_sd_s = 0.6;    ///< so that with the beats the SD of all comes near his 0.341 s
    double most_apex_offset_s = 0.8;  ///< a choice; beyond +-0.5 s people begin to notice (Kirchhof 2014)
    double pointing_offset_sd_s =
        0.06;               ///< of pointing's apex from the accented syllable's end (Esteve-Gibert
                            ///< & Prieto 2013); in a phrase's last word it comes earlier
    double pause_s = 0.15;  ///< that parts phrases; longer runs are parted, too: gesture phrases align
    double longest_phrase_s = 2.6;  ///< with intermediate phrases (Loehr 2004, 2012). Both are choices.
    double hold_s = 0.35;  ///< mean that a posture outlasts its phrase: no published figure was found

    // Which hand. Right is 60 % of strokes by one hand (Nicoladis & Shirazi 2021): 0.9 of people are
    // right-handed, and 0.625 of phrases have the hand that the person writes with.
    double right_handed = 0.9;
    double phrases_by_own_hand = 0.625;
    double pointing_by_own_hand = 0.85;  ///< Cochet & Vauclair 2012
    double both_hands = 0.5;             ///< of phrases of beats: a choice

    // What: this speaker argues more than it depicts, so metaphorics are more than iconics, against McNeill's
    // (1992) narratives. All of it choices.
    double metaphoric = 0.22;  ///< of phrases in which no word asks for a gesture
    double heeds_words = 0.8;  ///< chance that a word which could be gestured is

    // How: all choices.
    double size = 0.88;  ///< of gestures, of the library's; its spread over speeches:
    double size_sd = 0.09;
    double metaphoric_lower = 0.06;     ///< arm lengths: McNeill 1992 has metaphorics lower than iconics
    double deictic_wider = 1.12;        ///< and pointing at the edge of the space
    double max_hand_speed_m_s = 1.7;    ///< of planned ways
    double most_wrist_speed_m_s = 2.4;  ///< of any wrist from frame to frame, on the mean body; a gesture
                                        ///< that would be faster is left out
};

/// Id of the strokes that are beats in a posture which is held.
inline constexpr std::string_view held_beat = "held_beat";

/// The same utterance, library and seed give the same motion. Gestures that the library lacks are replaced by
/// beats. Each stroke of a gesture that has several is listed.
[[nodiscard]] GesturedSpeech gestureByPhrases(const Utterance& utterance, const GestureLibrary& library,
                                              std::uint64_t seed, const PhraseSpeaker& speaker = {});

}  // namespace deixis::motion
