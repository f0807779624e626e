#include "studies/texts/language.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "core/files.hpp"
#include "paths.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::studies;
using deixis::tests::contains;

namespace {

const std::filesystem::path shipped = deixis::tests::sourceDir() / "assets/data/languages";

std::string bytesOf(const std::string& code) {
    auto bytes = readFile(shipped / (code + ".toml"));
    REQUIRE(bytes.has_value());
    return *std::move(bytes);
}

/// The German table with the line of `key` replaced by `line`, and `more` behind it.
Result<LanguageTable> loadWith(const std::string& key, const std::string& line,
                               const std::string& more = "") {
    std::string bytes = bytesOf("de");
    if (!key.empty()) {
        const std::size_t from = bytes.find("\n" + key + " = ") + 1;
        REQUIRE(from > 0);
        bytes.replace(from, bytes.find('\n', from) - from, line);
    }
    const auto file = std::filesystem::temp_directory_path() / "deixis_language_test.toml";
    REQUIRE(writeFile(file, bytes + more).has_value());
    auto table = LanguageTable::load(file);
    std::filesystem::remove(file);
    return table;
}

int lineOf(const std::string& key) {
    const std::string bytes = bytesOf("de");
    const auto at = static_cast<std::ptrdiff_t>(bytes.find("\n" + key + " = "));
    return 2 + static_cast<int>(std::count(bytes.begin(), bytes.begin() + at, '\n'));
}

bool hasHangul(const std::string& text) {
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        const auto lead = static_cast<unsigned char>(text[i]);
        if (lead >= 0xEA && lead <= 0xED) return true;
    }
    return false;
}

}  // namespace

TEST_SUITE("studies/language") {
    TEST_CASE("the shipped English table says what the program says itself, in the order of its keys") {
        const auto table = LanguageTable::load(shipped / "en.toml");
        REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
        CHECK(table->code() == "en");
        CHECK(LanguageTable::english().code() == "en");
        const std::string bytes = bytesOf("en");
        std::size_t before = 0;
        for (const auto& entry : languageKeys()) {
            const std::string key(entry.first);
            const std::string text(entry.second);
            CAPTURE(key);
            CHECK((*table)(key) == text);
            CHECK(LanguageTable::english()(key) == text);
            const std::size_t at = bytes.find("\n" + key + " = ");
            REQUIRE(at != std::string::npos);
            CHECK(at > before);
            before = at;
        }
    }

    TEST_CASE("German, Swedish and Korean are complete and translated") {
        for (const std::string code : {"de", "sv", "ko"}) {
            CAPTURE(code);
            const auto table = LanguageTable::load(shipped / (code + ".toml"));
            REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
            CHECK(table->code() == code);
            for (const auto& entry : languageKeys()) {
                const std::string key(entry.first);
                CAPTURE(key);
                const std::string& text = (*table)(key);
                if (key != "number_hint") CHECK(text != entry.second);
                if (code == "ko" && key != "number_hint") CHECK(hasHangul(text));
            }
        }
    }

    TEST_CASE(
        "each language says how far its words can be trusted, and nothing claims a review that was none") {
        CHECK(LanguageTable::english().status() == TextStatus::written);
        const auto english = LanguageTable::load(shipped / "en.toml");
        REQUIRE(english.has_value());
        CHECK(english->status() == TextStatus::written);
        for (const std::string code : {"de", "sv", "ko"}) {
            const auto table = LanguageTable::load(shipped / (code + ".toml"));
            REQUIRE(table.has_value());
            CHECK(table->status() == TextStatus::translated);
        }
        CHECK(textStatusText(TextStatus::translated) == "translated, not reviewed by a native speaker");
        const auto reviewed = loadWith("status", "status = \"reviewed\"");
        REQUIRE(reviewed.has_value());
        CHECK(reviewed->status() == TextStatus::reviewed);
        const auto unknown = loadWith("status", "status = \"perfect\"");
        REQUIRE_FALSE(unknown.has_value());
        CHECK(contains(unknown.error().where, ": status"));
        CHECK(contains(unknown.error().message, "\"translated\""));
    }

    TEST_CASE("words in scripts that boards cannot draw are rejected, with the script's name") {
        struct Case {
            std::string text;
            std::string script;
        };
        for (const auto& [text, script] :
             {Case{"استمر", "Arabic"}, Case{"המשך", "Hebrew"}, Case{"जारी रखें", "Devanagari"},
              Case{"ดำเนินการต่อ", "Thai"}, Case{"Weiter \xF0\x90\xA4\x80", "right-to-left"}}) {
            const auto table = loadWith("continue", "continue = \"" + text + "\"");
            REQUIRE_FALSE(table.has_value());
            CHECK(contains(table.error().where, ": continue"));
            CHECK(contains(table.error().message, script));
            CHECK(contains(table.error().hint, "left to right"));
        }
        const auto chinese = loadWith("continue", "continue = \"继续\"");
        REQUIRE_FALSE(chinese.has_value());
        CHECK(contains(chinese.error().message, "'继' (U+7EE7)"));
        CHECK(contains(chinese.error().hint, "Hangul"));
        for (const std::string text : {"Συνέχεια", "Продолжить", "계속", "Fortsätt – «später» …"})
            CHECK(loadWith("continue", "continue = \"" + text + "\"").has_value());
    }

    TEST_CASE("one second is told as one, more by their number") {
        const LanguageTable& words = LanguageTable::english();
        CHECK(words.seconds("notice_time_left", "notice_second_left", 2) == "2 seconds left.");
        CHECK(words.seconds("notice_time_left", "notice_second_left", 1) == "1 second left.");
    }

    TEST_CASE("options that stand beside each other differ in every language") {
        for (const std::string code : {"en", "de", "sv", "ko"}) {
            CAPTURE(code);
            const auto table = LanguageTable::load(shipped / (code + ".toml"));
            REQUIRE(table.has_value());
            std::set<std::string> texts;
            for (const char* key : {"prefer_left_clearly", "prefer_left_slightly", "prefer_neither",
                                    "prefer_right_slightly", "prefer_right_clearly"})
                texts.insert((*table)(key));
            CHECK(texts.size() == 5);
            CHECK((*table)("agree") != (*table)("decline"));
            CHECK((*table)("resume") != (*table)("end_session"));
            CHECK((*table)("go_back") != (*table)("end_yes"));
        }
    }

    TEST_CASE("no key stands twice and none is misspelled") {
        std::set<std::string_view> keys;
        for (const auto& [key, text] : languageKeys()) {
            CHECK(keys.insert(key).second);
            CHECK_FALSE(text.empty());
            for (const char c : key) CHECK(((c >= 'a' && c <= 'z') || c == '_'));
        }
    }

    TEST_CASE("placeholders are filled in, wherever they stand, and values are not read again") {
        const LanguageTable& english = LanguageTable::english();
        CHECK(english("page_of", {{"page", "2"}, {"pages", "5"}}) == "Page 2 of 5");
        CHECK(english("page_of", {{"pages", "{page}"}, {"page", "{pages}"}}) == "Page {pages} of {page}");
        CHECK(english("continue", {}) == "Continue");
        const auto korean = LanguageTable::load(shipped / "ko.toml");
        REQUIRE(korean.has_value());
        CHECK((*korean)("page_of", {{"page", "2"}, {"pages", "5"}}) == "5쪽 중 2쪽");
        CHECK_THROWS_AS((void)english("page_of", {{"page", "2"}}), std::invalid_argument);
        CHECK_THROWS_AS((void)english("no_such_key"), std::out_of_range);
    }

    TEST_CASE("a key that is missing, unknown or empty is told by file, line and key") {
        const auto missing = loadWith("confirm", "");
        REQUIRE_FALSE(missing.has_value());
        CHECK(contains(missing.error().where, "deixis_language_test.toml: confirm"));
        CHECK(contains(missing.error().message, "\"Confirm\""));

        const auto unknown = loadWith("confirm", "confrim = \"x\"");
        REQUIRE_FALSE(unknown.has_value());
        CHECK(contains(unknown.error().where, ":" + std::to_string(lineOf("confirm")) + ": confrim"));
        CHECK(contains(unknown.error().message, "unknown key"));
        CHECK(contains(unknown.error().message, "also confirm: this key is missing"));
        CHECK(contains(unknown.error().hint, "confirm"));

        const auto former = loadWith("session_over_text", "sitting_over_text = \"Tschüss\"");
        REQUIRE_MESSAGE(former.has_value(), "its name in older files");
        CHECK((*former)("session_over_text") == "Tschüss");

        const auto empty = loadWith("left", "left = \" \"");
        REQUIRE_FALSE(empty.has_value());
        CHECK(contains(empty.error().where, ":" + std::to_string(lineOf("left")) + ": left"));
        CHECK(contains(empty.error().message, "empty"));
    }

    TEST_CASE("placeholders must be those of the English text") {
        for (const std::string text :
             {"Seite {page}", "Seite {page} von {pages} ({number})", "Seite {Page} von {pages}",
              "Seite page von pages", "Seite {page} von {pages"}) {
            CAPTURE(text);
            const auto table = loadWith("page_of", "page_of = \"" + text + "\"");
            REQUIRE_FALSE(table.has_value());
            CHECK(contains(table.error().where, ":" + std::to_string(lineOf("page_of")) + ": page_of"));
            CHECK(contains(table.error().message, "must be {page}, {pages}"));
        }
        const auto superfluous = loadWith("left", "left = \"Links {number}\"");
        REQUIRE_FALSE(superfluous.has_value());
        CHECK(contains(superfluous.error().message, "are {number}, but must be none"));
        CHECK(loadWith("page_of", "page_of = \"{pages}/{page}\"").has_value());
    }

    TEST_CASE("what is no text and what is no TOML is told with its line") {
        for (const std::string value : {"3", "true", "[\"a\"]", "{ a = \"b\" }"}) {
            CAPTURE(value);
            const auto table = loadWith("play", "play = " + value);
            REQUIRE_FALSE(table.has_value());
            CHECK(contains(table.error().where, ":" + std::to_string(lineOf("play")) + ": play"));
            CHECK(contains(table.error().message, "text in quotation marks"));
        }
        const auto broken = loadWith("play", "play = \"Abspielen");
        REQUIRE_FALSE(broken.has_value());
        CHECK(contains(broken.error().where, "deixis_language_test.toml:" + std::to_string(lineOf("play"))));
        const auto twice = loadWith("", "", "play = \"Abspielen\"\n");
        REQUIRE_FALSE(twice.has_value());
        CHECK_FALSE(LanguageTable::load(shipped / "xx.toml").has_value());
    }

    TEST_CASE("of many problems the first few are told, in the order of the file, and the others counted") {
        const auto many =
            loadWith("continue", "continue = 1", "a = \"\"\nb = \"\"\nc = \"\"\nd = 1\ne = 2\n");
        REQUIRE_FALSE(many.has_value());
        const std::string& message = many.error().message;
        CHECK(contains(many.error().where, ": continue"));
        const std::size_t a = message.find(", a: unknown key");
        const std::size_t d = message.find(", d: unknown key");
        REQUIRE(a != std::string::npos);
        REQUIRE(d != std::string::npos);
        CHECK(a < d);
        CHECK_FALSE(contains(message, ", e: unknown key"));
        CHECK(contains(message, "and 1 more"));
    }

    TEST_CASE(
        "Words kept by an earlier program stay; new ones are today's, those that are gone are passed over") {
        std::string bytes = bytesOf("de");
        const auto cut = [&](const std::string& key) {
            const std::size_t from = bytes.find("\n" + key + " = ") + 1;
            REQUIRE(from > 0);
            bytes.erase(from, bytes.find('\n', from) + 1 - from);
        };
        const std::string first(languageKeys().front().first);
        const std::string last(languageKeys().back().first);
        cut(first);
        cut(last);
        bytes += "\n" + last + " = \"wie damals\"\ngone = \"vorbei\"\n";
        const auto file = std::filesystem::temp_directory_path() / "deixis_kept_words_test.toml";
        REQUIRE(writeFile(file, bytes).has_value());
        const auto today = LanguageTable::load(shipped / "de.toml");
        REQUIRE(today);
        CHECK_FALSE(LanguageTable::load(file));
        const auto kept = LanguageTable::loadKept(file, shipped / "de.toml");
        REQUIRE(kept);
        CHECK((*kept)(first) == (*today)(first));
        const bool plain = !contains(languageKeys().back().second, "{");
        CHECK((*kept)(last) == (plain ? "wie damals" : (*today)(last)));
        const auto alone = LanguageTable::loadKept(file, "none.toml");
        REQUIRE(alone);
        CHECK((*alone)(first) == LanguageTable::english()(first));
        std::filesystem::remove(file);
    }
}
