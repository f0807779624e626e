// What a voice says: the sound, and when which word and syllable of it is heard.
#pragma once

#include <string_view>
#include <vector>

#include "core/utterance.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::speech {

/// Times in seconds from the start of the sound.
struct Syllable {
    double start_s = 0.0;
    double end_s = 0.0;
    int word = 0;           ///< index of its word
    bool stressed = false;  ///< by the dictionary: the place in its word where an accent can be
    bool weak = false;      ///< of a weak word
};

/// A word of grammar that is seldom accented: articles, pronouns of persons, auxiliary verbs, conjunctions,
/// the commonest prepositions. Not what points: "this", "that", "here", "there". Small and capital letters
/// are alike.
[[nodiscard]] bool isWeakWord(std::string_view word);

struct Speech {
    Sound sound;
    /// Words as they were written, without those that are not heard; none where the voice does not tell
    /// them. Accents are not known here.
    Utterance utterance;
    std::vector<Syllable> syllables;  ///< in order
};

}  // namespace deixis::speech
