#include "typed_text.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using deixis::app::TypedText;

namespace {

/// What a session makes of the parts: characters are added, then as many taken away.
void applyTo(const TypedText::Part& part, std::string& text) {
    text += part.typed;
    for (int i = 0; i < part.erased && !text.empty(); ++i) {
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
        text.pop_back();
    }
}

}  // namespace

TEST_SUITE("immersive/typed_text") {
    TEST_CASE("Characters of one to four bytes become the UTF-8 that a compiler makes of them") {
        TypedText text;
        for (const char32_t c : U"aß가é😀") text.type(c);
        const TypedText::Part part = text.take();
        CHECK(part.typed == "aß가é😀");
        CHECK(part.erased == 0);
        CHECK(text.take().typed.empty());
    }

    TEST_CASE("What is no character is not typed") {
        TypedText text;
        for (const char32_t c :
             {U'\0', U'\n', U'\x7F', U'\x9B', static_cast<char32_t>(0xD800), static_cast<char32_t>(0x110000)})
            text.type(c);
        const TypedText::Part part = text.take();
        CHECK(part.typed.empty());
        CHECK(part.erased == 0);
    }

    TEST_CASE("What is typed after an erased character waits for the next part") {
        TypedText text;
        text.type(U'a');
        text.erase();
        text.type(U'b');
        const TypedText::Part first = text.take();
        CHECK(first.typed == "a");
        CHECK(first.erased == 1);
        const TypedText::Part second = text.take();
        CHECK(second.typed == "b");
        CHECK(second.erased == 0);
    }

    TEST_CASE("However keys and frames fall, the text is the one that the keys make one by one") {
        std::mt19937 random(7);
        const std::vector<char32_t> letters{U'a', U'ö', U'한', U'😀'};
        for (int round = 0; round < 200; ++round) {
            TypedText text;
            std::string seen;
            std::u32string wanted;
            for (int i = 0; i < 40; ++i) {
                const auto key = random() % 6;
                if (key < letters.size()) {
                    text.type(letters[key]);
                    wanted += letters[key];
                } else {
                    text.erase();
                    if (!wanted.empty()) wanted.pop_back();
                }
                if (random() % 3 == 0) applyTo(text.take(), seen);
            }
            for (int i = 0; i < 40; ++i) applyTo(text.take(), seen);
            TypedText again;
            for (const char32_t c : wanted) again.type(c);
            CHECK(seen == again.take().typed);
        }
    }
}
