#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "core/random.hpp"
#include "speech/voice/voices.hpp"
#include "speech/voice/written_words.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using speech::speakByFlite;
using speech::writtenWords;

namespace {

std::string joined(const std::string& text) {
    const auto words = writtenWords(text, "text");
    REQUIRE(words.has_value());
    std::string out;
    for (const auto& word : *words) out += (out.empty() ? "" : "|") + word.text;
    return out;
}

std::string joinedSpellings(const std::string& text) {
    const auto words = writtenWords(text, "text");
    REQUIRE(words.has_value());
    std::string out;
    for (const auto& word : *words)
        out += (out.empty() ? "" : "|") + word.opening + word.spelling + word.closing;
    return out;
}

std::string errorOf(const std::string& text) {
    const auto words = writtenWords(text, "text");
    REQUIRE_FALSE(words.has_value());
    return words.error().text();
}

std::string repeated(const std::string& part, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += part;
    return out;
}

/// Mean square of a stretch.
double power(const speech::Sound& sound, double start_s, double end_s) {
    double sum = 0.0;
    const auto first = static_cast<std::size_t>(start_s * sound.rate_hz);
    const auto end = std::min(sound.samples.size(), static_cast<std::size_t>(end_s * sound.rate_hz));
    for (std::size_t i = first; i < end; ++i)
        sum += static_cast<double>(sound.samples[i]) * static_cast<double>(sound.samples[i]);
    return end > first ? sum / static_cast<double>(end - first) : 0.0;
}

}  // namespace

TEST_SUITE("speech/written_words") {
    TEST_CASE("words come as they were written, without the punctuation around them") {
        CHECK(joined("Hello, \"world\"!") == "Hello|world");
        CHECK(joined("It's $3.50 (50%) -- isn't it?") == "It's|$3.50|50%|isn't|it");
        CHECK(joined("Dr. Smith's well-known U.S.A. dogs'") == "Dr|Smith's|well-known|U.S.A|dogs");
        CHECK(joined("caf\xC3\xA9 na\xC3\xAFve") == "caf\xC3\xA9|na\xC3\xAFve");
        CHECK(joined("\xE2\x80\x9CSo,\xE2\x80\x9D she said\xE2\x80\xA6 \xE2\x80\x98no\xE2\x80\x99") ==
              "So|she|said|no");
        CHECK(joined("\xEF\xBB\xBFone\xE2\x80\x94two\xC2\xA0three \xF0\x9F\x98\x80 four\xF0\x9F\x98\x80") ==
              "one|two|three|four");
        CHECK(joined("cafe\xCC\x81") == "cafe\xCC\x81");
    }

    TEST_CASE("a voice gets ASCII and the punctuation that it pauses at") {
        CHECK(joinedSpellings("caf\xC3\xA9 Stra\xC3\x9F"
                              "e \xE2\x82\xAC"
                              "5") == "cafe|Strasse|euro5");
        CHECK(joinedSpellings("one\xE2\x80\x94two - three, \xE2\x80\x9C"
                              "four.\xE2\x80\x9D") == "one,|two,|three,|\"four.\"");
        CHECK(joinedSpellings("5\xE2\x80\x93"
                              "10 don\xE2\x80\x99t") == "5-10|don't");
        CHECK(writtenWords("one\n\ntwo", "text")->front().ends_block);
        CHECK_FALSE(writtenWords("one\ntwo", "text")->front().ends_block);
    }

    TEST_CASE("what cannot be spoken is said by its name") {
        CHECK(contains(errorOf(""), "text: found an empty text"));
        CHECK(contains(errorOf(" \n\t"), "empty text"));
        CHECK(contains(errorOf("... --- !!!"), "nothing that can be spoken"));
        CHECK(contains(errorOf("\xF0\x9F\x98\x80"), "nothing that can be spoken"));
        CHECK(contains(errorOf("\xEC\x95\x88\xEB\x85\x95"), "\"\xEC\x95\x88\" of Korean"));
        CHECK(contains(errorOf("hello \xD9\x85\xD8\xB1\xD8\xAD\xD8\xA8\xD8\xA7"), "of Arabic"));
        CHECK(contains(errorOf("\xD0\x9F\xD1\x80\xD0\xB8\xD0\xB2\xD0\xB5\xD1\x82"), "of Cyrillic"));
        CHECK(contains(errorOf("\xE4\xBD\xA0\xE5\xA5\xBD"), "of Chinese"));
        CHECK(contains(errorOf("\xE3\x81\x93"), "of Japanese"));
        CHECK(contains(errorOf("\xCE\xB1"), "of Greek"));
        CHECK(contains(errorOf("ab\x07"
                               "c"),
                       "control character U+0007 at byte 3"));
        CHECK(contains(errorOf("ab\xFF"
                               "c"),
                       "byte at place 3 that is no part of UTF-8"));
        CHECK(contains(errorOf(repeated("word ", 10000)), "10000 words, expected 4000 at the most"));
        CHECK(contains(errorOf(std::string(300'000, 'a')), "300000 bytes, expected 200000"));
        CHECK(contains(errorOf("a " + std::string(81, 'b')), "81 characters, \"bbbbbbbbbbbbbbbbbbbb...\""));
    }
}

TEST_SUITE("speech/flite_voice") {
    TEST_CASE("each voice speaks at 16 kHz, with the words in order and within the sound") {
        const std::string text = "Dr. Smith paid $250 on the 5th. It was a well-known house!";
        for (const std::string& voice : speech::fliteVoices()) {
            CAPTURE(voice);
            const auto speech = speakByFlite(text, voice);
            REQUIRE(speech.has_value());
            CHECK(speech->sound.rate_hz == 16000);
            const auto& words = speech->utterance.words;
            REQUIRE(words.size() == 12);
            CHECK(words[0].text == "Dr");
            CHECK(words[3].text == "$250");
            CHECK(words[11].text == "house");
            double before = 0.0;
            for (const auto& word : words) {
                CHECK(word.start_s >= before);
                CHECK(word.end_s > word.start_s);
                before = word.end_s;
            }
            CHECK(before <= speech->utterance.duration_s);
            CHECK(speech->utterance.duration_s == durationOf(speech->sound));
            // "two hundred fifty dollars" lasts longer than "paid".
            CHECK(words[3].end_s - words[3].start_s > 2.5 * (words[2].end_s - words[2].start_s));
            for (const auto& syllable : speech->syllables) {
                const auto& word = words[static_cast<std::size_t>(syllable.word)];
                CHECK(syllable.start_s >= word.start_s);
                CHECK(syllable.end_s <= word.end_s);
            }
        }
    }

    TEST_CASE("sound is where the words are, silence before and behind them") {
        const auto speech = speakByFlite("Marvellous!", "slt");
        REQUIRE(speech.has_value());
        const auto& word = speech->utterance.words.front();
        const double inside = power(speech->sound, word.start_s, word.end_s);
        CHECK(power(speech->sound, 0.0, word.start_s - 0.02) < 0.01 * inside);
        CHECK(power(speech->sound, word.end_s + 0.05, speech->utterance.duration_s) < 0.01 * inside);
    }

    TEST_CASE("stress is where the dictionary has it") {
        const auto speech = speakByFlite("banana photography", "kal16");
        REQUIRE(speech.has_value());
        std::string stresses;
        for (const auto& syllable : speech->syllables) stresses += syllable.stressed ? '1' : '0';
        CHECK(stresses == "0100100");
    }

    TEST_CASE("the same text is the same sound, whatever else was spoken or drawn, in any thread") {
        for (const std::string& voice : speech::fliteVoices()) {
            CAPTURE(voice);
            const auto first = speakByFlite("Put it over there.", voice);
            (void)std::rand();
            (void)speakByFlite("Something else.", voice);
            std::vector<std::vector<float>> again(2);
            {
                std::vector<std::jthread> threads;
                for (auto& samples : again)
                    threads.emplace_back(
                        [&] { samples = speakByFlite("Put it over there.", voice)->sound.samples; });
            }
            for (const auto& samples : again) CHECK(samples == first->sound.samples);
        }
    }

    TEST_CASE("the numbers of rand() go on as they were") {
        std::srand(7);
        const int first = std::rand(), second = std::rand();
        std::srand(7);
        CHECK(std::rand() == first);
        (void)speakByFlite("A noisy voice.", "slt");
        CHECK(std::rand() == second);
    }

    TEST_CASE("the rate makes it quicker and slower") {
        const std::string text = "This sentence is spoken at several rates.";
        for (const std::string& voice : speech::fliteVoices()) {
            CAPTURE(voice);
            const double usual = speakByFlite(text, voice)->utterance.duration_s;
            CHECK(speakByFlite(text, voice, {0.5})->utterance.duration_s ==
                  doctest::Approx(2.0 * usual).epsilon(0.06));
            CHECK(speakByFlite(text, voice, {2.0})->utterance.duration_s ==
                  doctest::Approx(0.5 * usual).epsilon(0.06));
        }
        for (const double rate : {0.4, 2.1, std::nan("")})
            CHECK(contains(speakByFlite(text, "slt", {rate}).error().text(), "rate: found"));
    }

    TEST_CASE("signs, numbers, letters and abbreviations are each one written word") {
        const std::string texts[]{"rock & roll",
                                  "1,234,567.89 euros",
                                  "at 10:30am",
                                  "C++ and C#",
                                  "O'Brien's U.S.A. NASA",
                                  "www.a_b.com/x?y=1 now",
                                  "3-5 and/or 7",
                                  "x*y = z",
                                  "I"};
        for (const std::string& text : texts) {
            CAPTURE(text);
            const auto speech = speakByFlite(text, "kal16");
            REQUIRE(speech.has_value());
            const auto written = writtenWords(text, "text");
            REQUIRE(speech->utterance.words.size() == written->size());
            for (std::size_t i = 0; i < written->size(); ++i)
                CHECK(speech->utterance.words[i].text == (*written)[i].text);
        }
        CHECK(speakByFlite("a . b", "kal16")->utterance.words.size() == 2);
        CHECK(contains(speakByFlite("a", "nobody").error().text(),
                       "voice: found \"nobody\", expected one of slt, rms"));
    }

    TEST_CASE("any text of ASCII is spoken or refused") {
        Random random(11);
        int spoken = 0;
        for (int i = 0; i < 200; ++i) {
            std::string text;
            for (std::uint64_t n = random.below(60) + 1; n > 0; --n) {
                // Half of them letters and blanks.
                const std::string_view usual = "etaoin shrdlu ";
                text += random.below(2) == 0 ? usual[random.below(usual.size())]
                                             : static_cast<char>(32 + random.below(95));
            }
            CAPTURE(text);
            const auto speech = speakByFlite(text, "kal16");
            if (!speech) continue;
            ++spoken;
            CHECK_FALSE(speech->utterance.words.empty());
            CHECK(speech->utterance.words.back().end_s <= speech->utterance.duration_s);
        }
        CHECK(spoken > 150);
    }

    TEST_CASE("pronunciations are in CMU's phones, several words to a number") {
        const auto words = speech::pronunciationOf(*writtenWords("250 zorblaxes hello", "text"));
        REQUIRE(words.size() == 3);
        REQUIRE(words[0].size() == 3);
        CHECK(words[0][1].text == "hundred");
        CHECK(words[1].size() == 1);  // by letter-to-sound rules
        const auto& hello = words[2][0].syllables;
        REQUIRE(hello.size() == 2);
        CHECK(hello[0].phones == std::vector<std::string>{"HH", "AH"});
        CHECK(hello[1].phones == std::vector<std::string>{"L", "OW"});
        CHECK(hello[1].stressed);
    }
}
