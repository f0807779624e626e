// How wide the characters of the boards' fonts are.
#pragma once

#include <cstdint>
#include <span>

namespace deixis::studies {

struct TextAdvance {
    char32_t character = 0;
    std::uint16_t regular = 0;  ///< in advance_units
    std::uint16_t bold = 0;
};

extern const int advance_units;  ///< in a line's height
/// By character; from the space to '~' none is left out.
extern const std::span<const TextAdvance> text_advances;

}  // namespace deixis::studies
