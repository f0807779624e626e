// What is said, and when: the words of a speech and its accented syllables.
#pragma once

#include <string>
#include <vector>

namespace deixis {

/// Times in seconds from the start of the sound; 0 <= start_s < end_s <= the sound's duration.
struct SpokenWord {
    std::string text;  ///< as written, without the punctuation around it
    double start_s = 0.0;
    double end_s = 0.0;
};

/// A syllable that stands out by pitch or loudness.
struct Accent {
    double start_s = 0.0;
    double end_s = 0.0;
    double strength = 0.0;  ///< above 0 to 1: how far it stands out of its surroundings
    int word = 0;           ///< index of its word
};

struct Utterance {
    double duration_s = 0.0;        ///< of the sound
    std::vector<SpokenWord> words;  ///< in order; they do not overlap
    std::vector<Accent> accents;    ///< in order
};

}  // namespace deixis
