// One sentence in flite's own structures, made and read.
#pragma once

#include <flite/flite.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "speech/voice/written_words.hpp"

namespace deixis::speech {

struct DeleteUtterance {
    void operator()(cst_utterance* utterance) const { delete_utterance(utterance); }
};
using FliteUtterance = std::unique_ptr<cst_utterance, DeleteUtterance>;

struct FlitePhone {
    std::string name;  ///< of flite's set: "ax"
    double start_s = 0.0;
    double end_s = 0.0;
};

struct FliteSyllable {
    std::vector<FlitePhone> phones;  ///< at least one
    bool stressed = false;
};

struct FliteWord {
    std::string name;
    std::vector<FliteSyllable> syllables;
};

/// The index of the first word of each sentence, and the number of words: sentences end as punctuation and
/// capitals tell, and after a hundred words at the latest.
[[nodiscard]] std::vector<std::size_t> sentenceStarts(const std::vector<WrittenWord>& words);

/// The words as flite says them. With `sound`, its wave is made; else only the pronunciation. Null where
/// flite gives up. `stretch` is how much longer all lasts.
[[nodiscard]] FliteUtterance synthesise(std::span<const WrittenWord> words, cst_voice* voice, double stretch,
                                        bool sound);

/// The spoken words of each written word that synthesise() was given.
[[nodiscard]] std::vector<std::vector<FliteWord>> wordsIn(const cst_utterance* utterance);

}  // namespace deixis::speech
