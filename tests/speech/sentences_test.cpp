#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>

#include "core/files.hpp"
#include "core/text.hpp"
#include "paths.hpp"
#include "speech/sentences/speech_texts.hpp"

using namespace deixis;
using speech::CorpusPart;

namespace {

constexpr std::size_t many = 3000;

const speech::SentenceGrammar& shippedGrammar() {
    static const speech::SentenceGrammar grammar = [] {
        const auto path = tests::sourceDir() / "assets/data/speech/sentences.txt";
        const auto text = readFile(path);
        REQUIRE_MESSAGE(text.has_value(), (text ? "" : text.error().text()));
        auto read = speech::parseSentenceGrammar(*text, "sentences.txt");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        return std::move(*read);
    }();
    return grammar;
}

const std::vector<speech::SpeechText>& manySpeeches() {
    static const std::vector<speech::SpeechText> speeches = [] {
        auto drawn = speech::drawSpeechTexts(shippedGrammar(), 1, many);
        REQUIRE_MESSAGE(drawn.has_value(), (drawn ? "" : drawn.error().text()));
        return std::move(*drawn);
    }();
    return speeches;
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : lowerCase(text) + " ")
        if (std::isalpha(static_cast<unsigned char>(c)) || c == '\'')
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    words.pop_back();
    return words;
}

std::string problemOf(std::string_view grammar) {
    const auto read = speech::parseSentenceGrammar(grammar, "g.txt");
    return read ? "none" : read.error().text();
}

}  // namespace

TEST_SUITE("speech/sentences") {
    TEST_CASE("Thousands of different speeches of 1,500 words and more, the same for the same seed") {
        std::set<std::string> texts, words;
        std::map<std::string, int> themes;
        for (const auto& one : manySpeeches()) {
            texts.insert(one.text);
            ++themes[one.theme];
            for (const auto& word : wordsOf(one.text)) words.insert(word);
        }
        CHECK(texts.size() == many);
        MESSAGE(words.size() << " word forms in " << many << " speeches");
        CHECK(words.size() >= 1500);
        CHECK(themes.size() == 22);
        for (const auto& one : themes) CHECK_MESSAGE(one.second > 60, one.first << " " << one.second);

        const auto again = speech::drawSpeechTexts(shippedGrammar(), 1, 50);
        const auto other = speech::drawSpeechTexts(shippedGrammar(), 2, 50);
        REQUIRE(again.has_value());
        REQUIRE(other.has_value());
        for (std::size_t i = 0; i < 50; ++i) {
            CHECK((*again)[i].text == manySpeeches()[i].text);
            CHECK_FALSE((*other)[i].text == manySpeeches()[i].text);
        }
    }

    TEST_CASE("No sentence is in two parts; eight of ten speeches are for training") {
        std::map<std::string, CorpusPart> parts;
        std::array<int, 3> counts{};
        for (const auto& one : manySpeeches()) {
            ++counts[static_cast<std::size_t>(one.part)];
            std::string joined;
            for (const auto& sentence : speech::sentencesOf(one.text)) {
                const auto [at, is_new] = parts.emplace(sentence, one.part);
                CHECK_MESSAGE(at->second == one.part, sentence);
                joined += (joined.empty() ? "" : " ") + sentence;
            }
            CHECK(joined == one.text);
        }
        CHECK(counts == std::array<int, 3>{2400, 300, 300});
    }

    TEST_CASE("Texts are tidy: no placeholder, capital letters, marks at words, an before vowels") {
        double total_s = 0.0;
        for (const auto& one : manySpeeches()) {
            CAPTURE(one.text);
            const double seconds = speech::spokenSeconds(one.text);
            CHECK(seconds >= 6.0);
            CHECK(seconds <= 22.0);
            total_s += seconds;
            CHECK(one.text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ ,.?!'") ==
                  std::string::npos);
            for (const std::string_view wrong :
                 {"  ", " ,", " .", ",,", "..", ",.", ".,", "?.", " a a", " a e", " a i", " a o ", " an b",
                  " an s", " the the ", " a the ", " a a "})
                CHECK_MESSAGE(one.text.find(wrong) == std::string::npos, wrong);
            for (const auto& sentence : speech::sentencesOf(one.text)) {
                CHECK(std::isupper(static_cast<unsigned char>(sentence.front())));
                CHECK(std::string_view(".?!").find(sentence.back()) != std::string_view::npos);
            }
        }
        CHECK(total_s / many > 9.0);
    }

    TEST_CASE("Words that people gesture with are everywhere") {
        std::map<std::string, int> counts;
        for (const auto& one : manySpeeches())
            for (const auto& word : wordsOf(one.text)) ++counts[word];
        for (const std::string word :
             {"here",    "there",   "this",   "that",    "these",   "those",      "left",     "right",
              "up",      "down",    "above",  "below",   "under",   "over",       "around",   "across",
              "through", "between", "behind", "inside",  "outside", "front",      "middle",   "straight",
              "far",     "away",    "back",   "forward", "big",     "huge",       "enormous", "wide",
              "tall",    "long",    "small",  "tiny",    "narrow",  "short",      "round",    "square",
              "flat",    "circle",  "ball",   "spiral",  "all",     "everything", "every",    "everybody",
              "many",    "few",     "more",   "less",    "none",    "nothing",    "whole",    "half",
              "both",    "one",     "two",    "three",   "first",   "second",     "third",    "no",
              "not",     "never",   "nobody", "don't",   "stop",    "i",          "me",       "my",
              "you",     "your",    "we",     "us",      "why",     "what",       "how",      "where",
              "who",     "maybe",   "hello",  "welcome", "goodbye", "please",     "thank",    "heart",
              "love",    "think",   "idea",   "give",    "take",    "open",       "closed",   "together",
              "apart",   "begin",   "end",    "grows",   "grew",    "rises",      "fell",     "increased",
              "push",    "pull",    "turn",   "before",  "after",   "tomorrow",   "past",     "future",
              "hand",    "other",   "um"})
            CHECK_MESSAGE(counts[word] >= 8, word << " " << counts[word]);
    }

    TEST_CASE("A length counts syllables, not letters") {
        // four syllables and an end; eight and an end
        const double four = speech::spokenSeconds("This is a test.");
        const double eight = speech::spokenSeconds("Elephants are enormous here.");
        CHECK(four == doctest::Approx(0.45 + 4 * 0.19));
        CHECK(eight == doctest::Approx(0.45 + 8 * 0.19));
    }

    TEST_CASE("A small grammar says all that it can, with labels kept and forms as asked") {
        const auto grammar = speech::parseSentenceGrammar(
            "theme t = s+\ns:\n  A {x#1} [sees|meets] {few} {x.2}, {um} the {x#1} is not alone.\n"
            "x:\n  owl / owls | fox / foxes\nfew:\n  two\num:\n  and [so|]\n",
            "g.txt");
        REQUIRE_MESSAGE(grammar.has_value(), (grammar ? "" : grammar.error().text()));
        std::set<std::string> sentences;
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const auto drawn = speech::drawSpeechTexts(*grammar, seed, 1, {2.0, 40.0});
            REQUIRE(drawn.has_value());
            sentences.insert(speech::sentencesOf(drawn->front().text).front());
        }
        std::set<std::string> possible;
        for (const char* verb : {"sees", "meets"})
            for (const char* so : {"and so", "and"})
                for (const auto& [first, second, article] :
                     {std::tuple{"owl", "foxes", "An"}, std::tuple{"fox", "owls", "A"}})
                    possible.insert(std::string(article) + " " + first + " " + verb + " two " + second +
                                    ", " + so + " the " + first + " is not alone.");
        // Sentences of other parts than that of the first speech are never said.
        std::erase_if(possible,
                      [](const auto& s) { return speech::partOfSentence(s) != CorpusPart::training; });
        CHECK(sentences == possible);

        const auto too_many = speech::drawSpeechTexts(*grammar, 1, 500, {2.0, 4.0});
        REQUIRE_FALSE(too_many.has_value());
        CHECK(too_many.error().text().find("different speeches of 2 to 4 s, expected 500") !=
              std::string::npos);
    }

    TEST_CASE("What was said is not said again: with no other text left it fails") {
        std::string lines;
        int count = 0;
        for (char c = 'a'; c <= 'z' && count < 3; ++c) {
            const std::string sentence = std::string("The letter is ") + c + " this time.";
            if (speech::partOfSentence(sentence) != CorpusPart::training) continue;
            lines += "  " + sentence + "\n";
            ++count;
        }
        const auto grammar = speech::parseSentenceGrammar("theme t = s\ns:\n" + lines, "g.txt");
        REQUIRE(grammar.has_value());
        CHECK(speech::drawSpeechTexts(*grammar, 1, 3, {0.5, 9.0}).has_value());
        const auto four = speech::drawSpeechTexts(*grammar, 1, 4, {0.5, 9.0});
        REQUIRE_FALSE(four.has_value());
        CHECK(four.error().message.find("found 3 different speeches") == 0);
    }

    TEST_CASE("A wrong grammar is told with its line") {
        const std::string good = "theme t = a\na:\n  yes\n";
        CHECK(problemOf(good) == "none");
        CHECK(problemOf("") == "g.txt:1: found no theme");
        CHECK(problemOf("theme t = b\n") == "g.txt:1: found no rule \"b\"");
        CHECK(problemOf("theme t = a+ a+\na:\n  x\n").find("g.txt:1: found a second rule with +") == 0);
        CHECK(problemOf("what\n").find("g.txt:1: found \"what\", expected") == 0);
        CHECK(problemOf("  x\n" + good) == "g.txt:1: found alternatives before the first rule");
        CHECK(problemOf(good + "a:\n  x\n") == "g.txt:4: found rule \"a\" a second time");
        CHECK(problemOf(good + "b:\n  x\n") == "g.txt:4: found rule \"b\", which nothing uses");
        CHECK(problemOf("theme t = a\na:\n") == "g.txt:2: found no alternative of \"a\"");
        CHECK(problemOf("theme t = a\na:\n  {b}\n") == "g.txt:3: found no rule \"b\"");
        CHECK(problemOf("theme t = a\na:\n  {b.x}\nb:\n  c\n").find("g.txt:3: found \"{b.x}\", expected") ==
              0);
        CHECK(problemOf("theme t = a\na:\n  {b\nb:\n  c\n") == "g.txt:3: found { without }");
        CHECK(problemOf("theme t = a\na:\n  b}\n") == "g.txt:3: found } without {");
        CHECK(problemOf("theme t = a\na:\n  [b\n") == "g.txt:3: found [ without ]");
        CHECK(problemOf("theme t = a\na:\n  b]\n") == "g.txt:3: found ] without [");
        CHECK(problemOf("theme t = a\na:\n  x | | y\n") == "g.txt:3: found an empty alternative");
        CHECK(problemOf("theme t = a\na:\n  {b.2}\nb:\n  c / d | e\n") ==
              "g.txt:4: found an alternative of \"b\" without form 2, which \"a\" uses");
        CHECK(problemOf("theme t = a\na:\n  {b#1}\nb:\n  c [d|e]\n") ==
              "g.txt:4: found \"b\" with a label, expected words alone");
        CHECK(problemOf("theme t = a\na:\n  {b}\nb:\n  {a}\n") ==
              "g.txt:2: found rule \"a\", which is made of itself");
    }
}
