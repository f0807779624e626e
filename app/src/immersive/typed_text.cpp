#include "typed_text.hpp"

namespace deixis::app {

namespace {

void appendUtf8(std::string& text, char32_t character) {
    const auto c = static_cast<unsigned>(character);
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (c < 0x80U) {
        add(c);
        return;
    }
    if (c < 0x800U) {
        add(0xC0U | (c >> 6U));
    } else if (c < 0x10000U) {
        add(0xE0U | (c >> 12U));
        add(0x80U | ((c >> 6U) & 0x3FU));
    } else {
        add(0xF0U | (c >> 18U));
        add(0x80U | ((c >> 12U) & 0x3FU));
        add(0x80U | ((c >> 6U) & 0x3FU));
    }
    add(0x80U | (c & 0x3FU));
}

}  // namespace

void TypedText::type(char32_t character) {
    const bool control = character < 0x20 || (character >= 0x7F && character < 0xA0);
    const bool surrogate = character >= 0xD800 && character < 0xE000;
    if (!control && !surrogate && character <= 0x10FFFF) keys_.push_back(character);
}

TypedText::Part TypedText::take() {
    Part part;
    auto key = keys_.begin();
    for (; key != keys_.end() && (*key == 0 || part.erased == 0); ++key) {
        if (*key == 0)
            ++part.erased;
        else
            appendUtf8(part.typed, *key);
    }
    keys_.erase(keys_.begin(), key);
    return part;
}

}  // namespace deixis::app
