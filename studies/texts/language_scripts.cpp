// Boards draw one character after another, from left to right, each with a shape of its own from the
// program's fonts. Scripts that need more are rejected: a participant would read them backwards, in pieces,
// or as question marks.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "studies/texts/language_words.hpp"
#include "text_advances.hpp"

namespace deixis::studies {

namespace {

struct Block {
    char32_t first;
    char32_t last;
    std::string_view script;
};

// From the names of Unicode's blocks (Unicode 15, Blocks.txt).
constexpr std::array blocks{Block{0x0590, 0x05FF, "Hebrew"},
                            Block{0x0600, 0x06FF, "Arabic"},
                            Block{0x0700, 0x074F, "Syriac"},
                            Block{0x0750, 0x077F, "Arabic"},
                            Block{0x0780, 0x07BF, "Thaana"},
                            Block{0x07C0, 0x07FF, "N'Ko"},
                            Block{0x0800, 0x085F, "Samaritan or Mandaic"},
                            Block{0x0860, 0x086F, "Syriac"},
                            Block{0x0870, 0x08FF, "Arabic"},
                            Block{0x0900, 0x097F, "Devanagari"},
                            Block{0x0980, 0x09FF, "Bengali"},
                            Block{0x0A00, 0x0A7F, "Gurmukhi"},
                            Block{0x0A80, 0x0AFF, "Gujarati"},
                            Block{0x0B00, 0x0B7F, "Odia"},
                            Block{0x0B80, 0x0BFF, "Tamil"},
                            Block{0x0C00, 0x0C7F, "Telugu"},
                            Block{0x0C80, 0x0CFF, "Kannada"},
                            Block{0x0D00, 0x0D7F, "Malayalam"},
                            Block{0x0D80, 0x0DFF, "Sinhala"},
                            Block{0x0E00, 0x0E7F, "Thai"},
                            Block{0x0E80, 0x0EFF, "Lao"},
                            Block{0x0F00, 0x0FFF, "Tibetan"},
                            Block{0x1000, 0x109F, "Myanmar"},
                            Block{0x1780, 0x17FF, "Khmer"},
                            Block{0x1800, 0x18AF, "Mongolian"},
                            Block{0xFB1D, 0xFB4F, "Hebrew"},
                            Block{0xFB50, 0xFDFF, "Arabic"},
                            Block{0xFE70, 0xFEFF, "Arabic"},
                            Block{0x10800, 0x10FFF, "a right-to-left"},
                            Block{0x1E800, 0x1EFFF, "a right-to-left"}};

bool within(const Block& block, char32_t code) {
    return code >= block.first && code <= block.last;
}

// What the Korean fonts add to the others.
constexpr std::array hangul_fonts{Block{0x3000, 0x3003, ""}, Block{0x3008, 0x3011, ""},
                                  Block{0x3131, 0x318E, ""}, Block{0xAC00, 0xD7A3, ""},
                                  Block{0xFF01, 0xFF5E, ""}};

bool hasShape(char32_t code) {
    return std::any_of(hangul_fonts.begin(), hangul_fonts.end(),
                       [code](const Block& block) { return within(block, code); }) ||
           std::any_of(text_advances.begin(), text_advances.end(),
                       [code](const TextAdvance& one) { return one.character == code; });
}

const char* const hint =
    "Expected a script whose letters follow each other from left to right, such as Latin, Greek, "
    "Cyrillic or Hangul, and no symbols beyond it";

}  // namespace

std::optional<NotDrawn> notDrawn(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const char32_t code = nextCharacter(text, at);
        constexpr char32_t byte_order_mark = 0xFEFF;
        if (code < 0x20 || code == byte_order_mark) continue;
        for (const Block& block : blocks)
            if (within(block, code))
                return NotDrawn{
                    fmt::format(
                        "found letters of the {} script, which boards cannot draw: its letters run from "
                        "right to left or change with their neighbours",
                        block.script),
                    hint};
        if (!hasShape(code))
            return NotDrawn{fmt::format("found '{}' (U+{:04X}), which is not in the program's fonts",
                                        text.substr(begin, at - begin), static_cast<unsigned>(code)),
                            hint};
    }
    return std::nullopt;
}

}  // namespace deixis::studies
