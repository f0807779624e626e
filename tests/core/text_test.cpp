#include "core/text.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "core/csv.hpp"
#include "core/random.hpp"

using namespace deixis;

namespace {

/// A character as UTF-8, by the table of RFC 3629, section 3.
std::string encoded(unsigned c) {
    std::string out;
    const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
    if (c < 0x80) {
        add(c);
    } else if (c < 0x800) {
        add(0xC0 | c >> 6);
        add(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        add(0xE0 | c >> 12);
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    } else {
        add(0xF0 | c >> 18);
        add(0x80 | (c >> 12 & 0x3F));
        add(0x80 | (c >> 6 & 0x3F));
        add(0x80 | (c & 0x3F));
    }
    return out;
}

}  // namespace

TEST_SUITE("core/text") {
    TEST_CASE("A name and its value are parted at the first sign of equality, and neither is empty") {
        CHECK(nameAndValue("a=b") == std::pair<std::string, std::string>("a", "b"));
        CHECK(nameAndValue("two words=b=c") == std::pair<std::string, std::string>("two words", "b=c"));
        for (const char* none : {"", "=", "a", "a=", "=b"}) CHECK_FALSE(nameAndValue(none).has_value());
    }

    TEST_CASE("Every character but NUL and the surrogates can be kept, wherever it stands") {
        for (unsigned c = 1; c <= 0x10FFFF; ++c) {
            const bool surrogate = c >= 0xD800 && c < 0xE000;
            if (storableText(encoded(c)) == surrogate) FAIL_CHECK(c);
        }
        CHECK(storableText(""));
        CHECK(storableText("plain words of more than eight bytes, and \xEA\xB0\x80 among them"));
        CHECK(firstUnstorable(std::string("eight by\0tes", 12)) == 8);
        CHECK(firstUnstorable(std::string("a\0b", 3)) == 1);
    }

    TEST_CASE("What is no character is found where it stands, and can be replaced") {
        for (const std::string bad :
             {"\x80", "\xFF", "\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\xAF", "\xF4\x90\x80\x80",
              "\xED\xA0\x80", "\xC3", "\xE2\x82", "\xF5\x80\x80\x80"}) {
            CHECK(firstUnstorable("Zo" + bad) == 2);
            CHECK(firstUnstorable("a text of twenty one " + bad + "!") == 21);
            CHECK(storableText(storable("Zo" + bad)));
        }
        CHECK(storable("Z\xFC"
                       "rich") == "Z\xEF\xBF\xBDrich");
        CHECK(storable("Z\xC3\xBCrich") == "Z\xC3\xBCrich");
    }

    TEST_CASE("Characters are read one after another, and a byte that is no part of one stands for itself") {
        std::size_t at = 0;
        for (char32_t c = 1; c <= 0x10FFFF; ++c) {
            if (c >= 0xD800 && c < 0xE000) continue;
            const std::string text = encoded(c) + "a";
            at = 0;
            const char32_t found = nextCharacter(text, at);
            if (found != c || at + 1 != text.size()) FAIL_CHECK(static_cast<unsigned>(c));
        }
        const std::string broken = "\xE2\x82!\xC0\xAF\xC3";
        std::vector<unsigned> found;
        for (at = 0; at < broken.size();) found.push_back(nextCharacter(broken, at));
        CHECK(found == std::vector<unsigned>{0xE2, 0x82, '!', 0xC0, 0xAF, 0xC3});
    }

    TEST_CASE("Random bytes become a text that can be kept, and such a text stays as it is") {
        Random random(5, "bytes");
        for (int i = 0; i < 2000; ++i) {
            std::string bytes(random.below(40), '\0');
            for (char& byte : bytes) byte = static_cast<char>(random.below(256));
            const std::string kept = storable(bytes);
            CHECK(storableText(kept));
            CHECK(storable(kept) == kept);
            if (storableText(bytes)) CHECK(kept == bytes);
        }
    }
}

TEST_SUITE("core/words") {
    TEST_CASE("A first letter from a to z becomes a capital one") {
        CHECK(capitalised("human-likeness") == "Human-likeness");
        CHECK(capitalised("4 steps") == "4 steps");
        CHECK(capitalised("\xC3\xA4") == "\xC3\xA4");
        CHECK(capitalised("").empty());
    }

    TEST_CASE("Blanks and line ends around a text go, those within stay") {
        CHECK(trimmed(" \t a b\r\n") == "a b");
        CHECK(trimmed("a").size() == 1);
        CHECK(trimmed(" \n\t\r ").empty());
        CHECK(trimmed("").empty());
    }

    TEST_CASE("Only A to Z have small letters, whatever the locale") {
        CHECK(lowerCase("AZaz09_[@`{") == "azaz09_[@`{");
        CHECK(lowerCase("\xC3\x84\xC4\xB0I") == "\xC3\x84\xC4\xB0i");
        CHECK(sameLetters("HiPs", "hIpS"));
        CHECK_FALSE(sameLetters("hips", "hip"));
        CHECK_FALSE(sameLetters("[", "{"));
    }

    TEST_CASE("One byte order mark is taken away, and only at the start") {
        CHECK(withoutByteOrderMark("\xEF\xBB\xBF"
                                   "a") == "a");
        CHECK(withoutByteOrderMark("\xEF\xBB\xBF\xEF\xBB\xBF") == "\xEF\xBB\xBF");
        CHECK(withoutByteOrderMark("a\xEF\xBB\xBF") == "a\xEF\xBB\xBF");
        CHECK(withoutByteOrderMark("\xEF\xBB") == "\xEF\xBB");
    }
}

TEST_SUITE("core/csv") {
    TEST_CASE("A table that is not UTF-8 is rejected with the line") {
        const auto latin = parseCsv("id,name\nP01,Zo\xC3\xAB\nP02,Z\xFCrich\n", "people.csv");
        REQUIRE_FALSE(latin);
        CHECK(latin.error().where == "people.csv:3");
        CHECK(latin.error().message.find("0xfc") != std::string::npos);
        const auto wide = parseCsv(std::string("i\0d\0", 4), "wide.csv");
        REQUIRE_FALSE(wide);
        CHECK(wide.error().where == "wide.csv:1");
        CHECK(parseCsv("\xEF\xBB\xBFid,name\nP01,Zo\xC3\xAB\n", "people.csv").has_value());
    }

    TEST_CASE("A cell that a spreadsheet would take for a formula gets an apostrophe") {
        for (const char* formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\tx", "\rx"})
            CHECK(safeText(formula) == std::string("'") + formula);
        for (const char* plain : {"", "direct", "1-2", "a=b"}) CHECK(safeText(plain) == plain);
        std::string row;
        appendSafeCsvField(row, "=HYPERLINK(\"x\",\"y\")");
        CHECK(row == "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
    }
}
