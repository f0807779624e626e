#include "typed_text.hpp"

#include "core/text.hpp"

namespace deixis::app {

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
