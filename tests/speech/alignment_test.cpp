#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <string>

#include "core/random.hpp"
#include "sentences.hpp"
#include "sounds.hpp"
#include "speech/alignment/aligner.hpp"
#include "speech/voice/flite_voice.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using deixis::tests::twenty_sentences;
using speech::Aligner;
using speech::speakByFlite;

namespace {

/// Loaded once for all test cases.
Aligner& aligner() {
    static Aligner loaded = [] {
        auto out = Aligner::load();
        REQUIRE(out.has_value());
        return std::move(*out);
    }();
    return loaded;
}

struct Deviation {
    double sum_s = 0.0, worst_s = 0.0;
    int count = 0;
    void add(double found_s, double known_s) {
        sum_s += std::abs(found_s - known_s);
        worst_s = std::max(worst_s, std::abs(found_s - known_s));
        ++count;
    }
    [[nodiscard]] double mean_ms() const { return 1000.0 * sum_s / count; }
};

std::string errorOf(const speech::Sound& sound, const std::string& text) {
    const auto alignment = aligner().align(sound, text);
    REQUIRE_FALSE(alignment.has_value());
    CHECK(contains(alignment.error().text(), "recording: "));
    return alignment.error().text();
}

}  // namespace

TEST_SUITE("speech/alignment") {
    TEST_CASE("words are where the voice that speaks them says") {
        Deviation words, syllables;
        std::chrono::duration<double> spent{};
        double spoken_s = 0.0;
        for (const char* voice : {"slt", "kal16"})
            for (const char* text : twenty_sentences) {
                CAPTURE(voice);
                CAPTURE(text);
                const auto speech = speakByFlite(text, voice);
                const auto start = std::chrono::steady_clock::now();
                const auto found = aligner().align(speech->sound, text);
                spent += std::chrono::steady_clock::now() - start;
                spoken_s += durationOf(speech->sound);
                REQUIRE(found.has_value());
                REQUIRE(found->words.size() == speech->utterance.words.size());
                for (std::size_t i = 0; i < found->words.size(); ++i) {
                    CHECK(found->words[i].text == speech->utterance.words[i].text);
                    words.add(found->words[i].start_s, speech->utterance.words[i].start_s);
                    words.add(found->words[i].end_s, speech->utterance.words[i].end_s);
                }
                REQUIRE(found->syllables.size() == speech->syllables.size());
                for (std::size_t i = 0; i < found->syllables.size(); ++i) {
                    CHECK(found->syllables[i].stressed == speech->syllables[i].stressed);
                    CHECK(found->syllables[i].word == speech->syllables[i].word);
                    syllables.add(found->syllables[i].start_s, speech->syllables[i].start_s);
                    syllables.add(found->syllables[i].end_s, speech->syllables[i].end_s);
                }
            }
        MESSAGE("words: mean ", words.mean_ms(), " ms, worst ", 1000.0 * words.worst_s,
                " ms; syllables: mean ", syllables.mean_ms(), " ms, worst ", 1000.0 * syllables.worst_s,
                " ms; ", spent.count() / spoken_s, " of the sound's duration");
        CHECK(words.mean_ms() < 20.0);
        CHECK(words.worst_s < 0.25);
        CHECK(syllables.mean_ms() < 25.0);
    }

    TEST_CASE("other rates and silence around are no trouble") {
        const std::string text = "Put the red ball over there.";
        const auto speech = speakByFlite(text, "slt");
        speech::Sound sound = resampled(speech->sound, 44100);
        sound.samples.insert(sound.samples.begin(), 88200, 0.0F);
        sound.samples.insert(sound.samples.end(), 88200, 0.0F);
        const auto found = aligner().align(sound, text);
        REQUIRE(found.has_value());
        for (std::size_t i = 0; i < found->words.size(); ++i)
            CHECK(std::abs(found->words[i].start_s - 2.0 - speech->utterance.words[i].start_s) < 0.08);
    }

    TEST_CASE("words that no dictionary has are pronounced by rule") {
        const std::string text = "The zorblax met a wugwug near Frobnitzville.";
        const auto speech = speakByFlite(text, "rms");
        const auto found = aligner().align(speech->sound, text);
        REQUIRE(found.has_value());
        for (std::size_t i = 0; i < found->words.size(); ++i)
            CHECK(std::abs(found->words[i].start_s - speech->utterance.words[i].start_s) < 0.1);
    }

    TEST_CASE("a sound of minutes is aligned piece by piece") {
        std::string text;
        for (int round = 0; round < 2; ++round)
            for (const char* sentence : twenty_sentences) text += std::string(sentence) + " ";
        const auto speech = speakByFlite(text, "kal16");
        CHECK(speech->utterance.duration_s > 100.0);
        const auto found = aligner().align(speech->sound, text);
        REQUIRE(found.has_value());
        REQUIRE(found->words.size() == speech->utterance.words.size());
        Deviation words;
        for (std::size_t i = 0; i < found->words.size(); ++i) {
            CHECK(found->words[i].text == speech->utterance.words[i].text);
            words.add(found->words[i].start_s, speech->utterance.words[i].start_s);
        }
        CHECK(words.mean_ms() < 25.0);
        CHECK(words.worst_s < 0.4);
    }

    TEST_CASE("a text that is not what is said is refused") {
        for (std::size_t i = 0; i < std::size(twenty_sentences); i += 2) {
            CAPTURE(twenty_sentences[i]);
            const auto speech = speakByFlite(twenty_sentences[i], "slt");
            errorOf(speech->sound, twenty_sentences[(i + 7) % std::size(twenty_sentences)]);
        }
        const std::string first = twenty_sentences[0], second = twenty_sentences[3];
        errorOf(speakByFlite(first, "slt")->sound, first + " " + second);
        CHECK(contains(errorOf(speakByFlite(first + " " + second, "slt")->sound, first),
                       "that is not in the text"));
    }

    TEST_CASE("silence, noise and tones have no words") {
        Random random(3);
        const std::string text = "Put the red ball over there.";
        errorOf(tests::soundOf(16000, 4.0, [](double) { return 0.0; }), text);
        errorOf(
            tests::soundOf(16000, 4.0, [&](double) { return std::clamp(0.1 * random.normal(), -1.0, 1.0); }),
            text);
        errorOf(tests::sine(16000, 4.0, 300.0), text);
    }

    TEST_CASE("errors say what is wrong") {
        const auto sound = tests::sine(16000, 0.5, 300.0);
        CHECK(contains(errorOf(sound, "This is a sentence that takes longer than that."),
                       "found 0.50 s of sound for 9 words"));
        const auto korean = aligner().align(sound, "\xEC\x95\x88");
        CHECK(contains(korean.error().text(), "Korean"));
        const auto nowhere = Aligner::load("/nowhere");
        REQUIRE_FALSE(nowhere.has_value());
        CHECK(contains(nowhere.error().text(), "/nowhere/en-us/mdef: is not there"));
        CHECK(contains(nowhere.error().text(), "pocketsphinx-en-us"));
    }
}
