// A speech as phrases, and the places in them where a stroke may fall.
#pragma once

#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "motion/phrase_gestures/phrase_gestures.hpp"

namespace deixis::motion {

/// Where a stroke may fall: an accented syllable, or the stressed part of a word that bears meaning.
struct Anchor {
    double start_s = 0.0;
    double end_s = 0.0;
    double strength = 0.0;
    int accent = -1;
    int word = 0;

    [[nodiscard]] double middle_s() const { return 0.5 * (start_s + end_s); }
};

struct SpokenPhrase {
    std::size_t first_word = 0;
    std::size_t end_word = 0;  ///< behind the last
    double start_s = 0.0;
    double end_s = 0.0;
    std::vector<Anchor> anchors{};  ///< that have a stroke, in order
};

/// "um" and the like, at which hands hold still (Graziano & Gullberg 2018).
[[nodiscard]] bool isFiller(std::string_view small_word);

/// The phrases with their strokes: accents first; others as far as the rate asks for more. Where a speech has
/// too few accents for both the rate and the share on accents, each gives way by the same factor.
[[nodiscard]] std::vector<SpokenPhrase> plannedPhrases(const Utterance& utterance,
                                                       const PhraseSpeaker& speaker, Random& random);

}  // namespace deixis::motion
