// How well found words fit a sound, and where the syllables within them end.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sphinx.hpp"

namespace deixis::speech {

/// The phones of CMU's dictionary, without stress.
[[nodiscard]] const std::vector<std::string>& cmuPhones();

/// What the word of a single phone is called in grammars.
[[nodiscard]] std::string phoneWord(const std::string& phone);

/// The grammar of any phones in any order.
[[nodiscard]] const std::string& anyPhones();

struct Stretch {
    std::size_t first = 0;
    std::size_t last = 0;  ///< of it too
};

/// The words that do not fit what is heard, where there are too many for the whole to be of use. `any_phones`
/// finds what fits best without a text; it is asked only where the words do not fit well.
[[nodiscard]] std::optional<Stretch> doubtfulStretch(
    const std::vector<FoundWord>& words, const std::function<std::vector<FoundWord>()>& any_phones);

/// A stretch of frames before, between or behind the words in which a second or more is nearly as loud as
/// they are.
[[nodiscard]] std::optional<std::pair<int, int>> soundBesides(const std::vector<FoundWord>& words,
                                                              const std::vector<std::int16_t>& samples);

/// The ends of a word's syllables, from its start on: by the phones, of which each syllable has `lengths`,
/// where they were found within the word, else in proportion to `lengths`. `phones` may be null.
[[nodiscard]] std::vector<double> syllableBounds(double start_s, double end_s,
                                                 const std::vector<std::size_t>& lengths,
                                                 const FoundWord* phones);

}  // namespace deixis::speech
