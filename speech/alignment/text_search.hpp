// The words of a text in a sound of any length. PocketSphinx's time grows with the square of a grammar's
// length, so that long sounds are searched piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sphinx.hpp"

namespace deixis::speech {

/// A piece of a sound and the words that lie in it, numbered through the text.
struct Piece {
    int first_frame = 0;
    int end_frame = 0;  ///< not of it
    std::size_t first_word = 0;
    std::size_t end_word = 0;  ///< not of it
};

struct TextFound {
    std::vector<FoundWord> words;  ///< all of the text's, by the sound's frames; empty: they are not in it
    std::vector<Piece> pieces;     ///< in order
};

/// `names`: the text's words as grammars call them.
[[nodiscard]] TextFound findText(Sphinx& sphinx, const std::vector<std::string>& names,
                                 const std::vector<std::int16_t>& samples);

/// The part of the samples that a piece is.
[[nodiscard]] std::vector<std::int16_t> samplesIn(const Piece& piece,
                                                  const std::vector<std::int16_t>& samples);

}  // namespace deixis::speech
