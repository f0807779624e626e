// What an English voice does with each character of Unicode.
#pragma once

#include <string>
#include <string_view>

namespace deixis::speech {

enum class CharacterKind : unsigned char {
    word,     ///< a part of a word
    mark,     ///< punctuation
    blank,    ///< parts words
    dash,     ///< parts words, with a pause
    nothing,  ///< passed over
    foreign   ///< a letter of a script that the voice cannot speak
};

struct CharacterUse {
    CharacterKind kind = CharacterKind::nothing;
    std::string ascii{};      ///< of words and punctuation
    const char* script = "";  ///< of foreign ones
};

[[nodiscard]] CharacterUse useOf(char32_t character);

}  // namespace deixis::speech
