// How wide texts are, and where their lines break.
#include "studies/texts/text_layout.hpp"

#include <doctest/doctest.h>

#include "panel_fixture.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("studies/text_layout") {
    TEST_CASE("characters are as wide as the fonts have them") {
        // Open Sans: 'a' 1139 and 'm' 1905 of 2789 units; Nanum Barun Gothic: 892 of 1149, at 0.86 of the
        // size.
        CHECK(textWidth("a", 1.0) == doctest::Approx(1139.0 / 2789.0));
        CHECK(textWidth("mm", 0.05) == doctest::Approx(2 * 0.05 * 1905.0 / 2789.0));
        CHECK(textWidth("한국어", 0.05) == doctest::Approx(3 * 0.05 * 0.86 * 892.0 / 1149.0));
        CHECK(textWidth("äöü", 0.05) == textWidth("aou", 0.05));
        CHECK(textWidth("a", 1.0, true) > textWidth("a", 1.0));
        CHECK(textWidth("", 1.0) == 0.0);
        CHECK_MESSAGE(textWidth("\xff\xc3", 1.0) > 0.0, "broken UTF-8 is measured too");
    }

    TEST_CASE("lines break at spaces, at line feeds, and within words that are too long") {
        using Lines = std::vector<std::string>;
        CHECK(wrapText("", 0.05, 1.0) == Lines{""});
        CHECK(wrapText("one\n\ntwo", 0.05, 1.0) == Lines{"one", "", "two"});
        const double word_m = textWidth("aaaa", 1.0);
        const double space_m = textWidth(" ", 1.0);
        CHECK(wrapText("aaaa aaaa", 1.0, 2.0 * word_m + space_m) == Lines{"aaaa aaaa"});
        CHECK(wrapText("aaaa aaaa", 1.0, 2.0 * word_m + space_m - 0.001) == Lines{"aaaa", "aaaa"});
        CHECK(wrapText("aaaaaaaaaa", 1.0, word_m) == Lines{"aaaa", "aaaa", "aa"});
        CHECK(wrapText("aa aaaaaaaa a", 1.0, word_m) == Lines{"aa", "aaaa", "aaaa", "a"});
        CHECK(wrapText("a.  b.", 1.0, 10.0) == Lines{"a.  b."});
        CHECK(wrapText("한국어한국어한국", 0.05, 0.2) == Lines{"한국어한국", "어한국"});
        CHECK(wrapText("가나 다라", 0.1, 0.32) == Lines{"가나 다라"});
        CHECK(wrapText("가나 다라", 0.1, 0.28) == Lines{"가나", "다라"});
        CHECK(wrapText("x", 1.0, 0.001) == Lines{"x"});
    }

    TEST_CASE("nothing is lost or added between the lines, and none is too wide, in all four languages") {
        for (const std::string& code : languageCodes()) {
            CAPTURE(code);
            RandomTexts texts(languageTable(code), 11);
            for (int round = 0; round < 300; ++round) {
                const std::string text = unwrapped(texts(1, 60));
                const bool bold = texts.flip();
                const double width_m = 0.3 + 0.01 * texts.between(0, 120);
                std::string joined;
                for (const std::string& line : wrapText(text, 0.046, width_m, bold)) {
                    CHECK(textWidth(line, 0.046, bold) <= width_m + 1e-9);
                    joined += line;
                }
                const auto withoutSpaces = [](std::string words) {
                    words.erase(std::remove(words.begin(), words.end(), ' '), words.end());
                    return words;
                };
                CHECK(withoutSpaces(joined) == withoutSpaces(text));
            }
        }
    }
}
