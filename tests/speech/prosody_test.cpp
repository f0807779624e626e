#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "sounds.hpp"
#include "speech/prosody/accents.hpp"
#include "speech/prosody/pitch.hpp"
#include "speech/prosody/utterance.hpp"
#include "speech/sound/wav.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using deixis::tests::hum;
using deixis::tests::sine;
using deixis::tests::soundOf;
using doctest::Approx;
using speech::pitchOf;

namespace {

struct PitchErrors {
    int frames = 0;
    int none = 0;
    int octaves = 0;           ///< nearer to another octave
    double worst_cents = 0.0;  ///< of the others
};

template <typename Hz>
PitchErrors errorsAgainst(const std::vector<double>& pitch, const Hz& hz) {
    PitchErrors out;
    for (std::size_t i = 5; i + 5 < pitch.size(); ++i) {
        ++out.frames;
        if (pitch[i] == 0.0) {
            ++out.none;
            continue;
        }
        const double octaves = std::log2(pitch[i] / hz(static_cast<double>(i) / 100.0));
        if (std::abs(octaves) > 0.5)
            ++out.octaves;
        else
            out.worst_cents = std::max(out.worst_cents, 1200.0 * std::abs(octaves));
    }
    return out;
}

int voicedFrames(const speech::Sound& sound) {
    const auto pitch = pitchOf(sound);
    return static_cast<int>(std::count_if(pitch.begin(), pitch.end(), [](double hz) { return hz > 0.0; }));
}

}  // namespace

TEST_SUITE("speech/pitch") {
    TEST_CASE("sines and hums have their pitch, in the right octave") {
        for (const int rate : {8000, 16000, 44100})
            for (const double hz : {70.0, 100.0, 133.0, 200.0, 250.0, 320.0, 440.0}) {
                CAPTURE(rate);
                CAPTURE(hz);
                for (const auto& sound :
                     {sine(rate, 0.5, hz), hum(rate, 0.5, [&](double t) { return hz * t; })}) {
                    const auto errors = errorsAgainst(pitchOf(sound), [&](double) { return hz; });
                    CHECK(errors.frames == 40);
                    CHECK(errors.none == 0);
                    CHECK(errors.octaves == 0);
                    CHECK(errors.worst_cents < 10.0);
                }
            }
    }

    TEST_CASE("glides are followed over two octaves, up and down") {
        // 90 Hz to 360 Hz and back in 4 s, exponentially.
        const auto hz = [](double t) { return 90.0 * std::exp2(t < 2.0 ? t : 4.0 - t); };
        const auto cycles = [](double t) {
            const double up = 90.0 / std::log(2.0);
            return t < 2.0 ? up * (std::exp2(t) - 1.0) : up * (3.0 + 4.0 - std::exp2(4.0 - t));
        };
        const auto errors = errorsAgainst(pitchOf(hum(16000, 4.0, cycles)), hz);
        CHECK(errors.frames == 390);
        CHECK(errors.none == 0);
        CHECK(errors.octaves == 0);
        CHECK(errors.worst_cents < 25.0);
    }

    TEST_CASE("a pitch whose fundamental is weak or missing is found all the same") {
        const auto sound = soundOf(16000, 0.5, [](double t) {
            const double phase = 2.0 * std::numbers::pi * 120.0 * t;
            return 0.2 * (std::sin(2.0 * phase) + std::sin(3.0 * phase) + std::sin(5.0 * phase));
        });
        const auto errors = errorsAgainst(pitchOf(sound), [](double) { return 120.0; });
        CHECK(errors.none == 0);
        CHECK(errors.octaves == 0);
    }

    TEST_CASE("a few periods that alternate do not make it fall an octave") {
        const auto sound = soundOf(16000, 1.0, [](double t) {
            const double phase = 2.0 * std::numbers::pi * 200.0 * t;
            const double alternation = t > 0.45 && t < 0.5 ? 0.2 * std::cos(0.5 * phase) : 0.0;
            return 0.2 * (1.0 + alternation) * (std::sin(phase) + 0.7 * std::sin(2.0 * phase));
        });
        const auto errors = errorsAgainst(pitchOf(sound), [](double) { return 200.0; });
        CHECK(errors.none == 0);
        CHECK(errors.octaves == 0);
    }

    TEST_CASE("silence, noise and what is too high or too low have none") {
        Random random(5);
        CHECK(pitchOf({16000, {}}).empty());
        CHECK(voicedFrames(soundOf(16000, 1.0, [](double) { return 0.0; })) == 0);
        CHECK(voicedFrames(soundOf(16000, 1.0, [](double) { return 0.3; })) == 0);
        double brown = 0.0;
        CHECK(voicedFrames(soundOf(
                  16000, 3.0, [&](double) { return std::clamp(0.1 * random.normal(), -1.0, 1.0); })) == 0);
        CHECK(voicedFrames(soundOf(16000, 3.0, [&](double) {
                  brown = 0.5 * brown + random.normal();
                  return std::clamp(0.1 * brown, -1.0, 1.0);
              })) == 0);
        // So faint that nobody hears it.
        CHECK(voicedFrames(sine(16000, 1.0, 200.0, 0.0005)) == 0);
    }

    TEST_CASE("noise at 10 dB less than a hum changes no octave") {
        Random random(6);
        auto sound = hum(16000, 2.0, [](double t) { return 150.0 * t; });
        for (float& sample : sound.samples) sample += static_cast<float>(0.07 * random.normal());
        const auto errors = errorsAgainst(pitchOf(sound), [](double) { return 150.0; });
        CHECK(errors.octaves == 0);
        CHECK(errors.none < errors.frames / 20);
    }

    TEST_CASE("loudness is that of full and softer sines, and frames begin within the sound") {
        const auto loudness = speech::loudnessOf(sine(16000, 1.0, 1000.0, 1.0));
        REQUIRE(loudness.size() == 100);
        CHECK(loudness[50] == Approx(-3.01).epsilon(0.01));
        CHECK(speech::loudnessOf(sine(16000, 1.0, 1000.0, 0.1))[50] == Approx(-23.01).epsilon(0.01));
        CHECK(speech::loudnessOf(soundOf(16000, 0.1, [](double) { return 0.0; }))[5] == speech::silence_db);
        CHECK(speech::loudnessOf(sine(16000, 0.101, 1000.0)).size() == 11);
    }
}

TEST_SUITE("speech/accents") {
    // Ten syllables of 200 ms, hummed at 120 Hz; one of them differs.
    TEST_CASE("the one that is higher, louder or longer than the others is accented") {
        struct Case {
            double semitones, gain, duration_s;
        };
        for (const Case& c :
             {Case{5.0, 1.0, 0.2}, Case{0.0, 2.5, 0.2}, Case{0.0, 1.0, 0.4}, Case{4.0, 1.6, 0.3}}) {
            CAPTURE(c.semitones);
            CAPTURE(c.gain);
            CAPTURE(c.duration_s);
            const int special = 6;
            speech::Sound sound{16000, {}};
            std::vector<speech::Syllable> syllables;
            for (int i = 0; i < 10; ++i) {
                const bool differs = i == special;
                const double hz = 120.0 * (differs ? std::exp2(c.semitones / 12.0) : 1.0);
                const auto part = hum(16000, differs ? c.duration_s : 0.2, [&](double t) { return hz * t; });
                const double start_s = durationOf(sound);
                for (const float sample : part.samples)
                    sound.samples.push_back(
                        static_cast<float>((differs ? c.gain : 1.0) * 0.4 * static_cast<double>(sample)));
                syllables.push_back({start_s, durationOf(sound), i, true});
            }
            const auto accents = accentsOf(syllables, pitchOf(sound), speech::loudnessOf(sound));
            REQUIRE(accents.size() == 1);
            CHECK(accents[0].word == special);
            CHECK(accents[0].start_s == syllables[special].start_s);
            CHECK(accents[0].strength > 0.0);
            CHECK(accents[0].strength <= 1.0);
            syllables[special].stressed = false;
            CHECK(accentsOf(syllables, pitchOf(sound), speech::loudnessOf(sound)).empty());
        }
        CHECK(speech::accentsOf({}, {}, {}).empty());
    }

    TEST_CASE("a word of a spoken sentence that is made louder becomes accented, and more than before") {
        const auto speech = speech::speakByFlite("We saw the house near the river and the bridge.", "slt");
        const auto strengthOf = [&](const speech::Sound& sound, int word) {
            double out = 0.0;
            for (const auto& accent : accentsOf(speech->syllables, pitchOf(sound), speech::loudnessOf(sound)))
                if (accent.word == word) out = std::max(out, accent.strength);
            return out;
        };
        for (const int word : {3, 6, 9}) {  // house, river, bridge
            CAPTURE(word);
            const auto& times = speech->utterance.words[static_cast<std::size_t>(word)];
            speech::Sound emphasised = speech->sound;
            for (float& sample : emphasised.samples) sample *= 0.3F;
            for (auto i = static_cast<std::size_t>(times.start_s * 16000);
                 i < static_cast<std::size_t>(times.end_s * 16000); ++i)
                emphasised.samples[i] *= 3.0F;
            CHECK(strengthOf(emphasised, word) > 0.3);
            CHECK(strengthOf(emphasised, word) > strengthOf(speech->sound, word));
        }
    }
}

TEST_SUITE("speech/utterance") {
    TEST_CASE("a text in a voice's words is complete, and the same as a recording of it nearly is") {
        const std::string text = "This enormous table is 3 times as long, and that one is quite short.";
        const auto spoken = speech::spokenText(speech::Voices(), nullptr, text, "slt");
        REQUIRE(spoken.has_value());
        CHECK(spoken->utterance.words.size() == 14);
        CHECK(spoken->utterance.accents.size() >= 2);
        CHECK(spoken->pitch.size() == speech::prosodyFramesOf(spoken->sound));
        double before = 0.0;
        for (const auto& accent : spoken->utterance.accents) {
            CHECK(accent.start_s >= before);
            CHECK(accent.end_s > accent.start_s);
            CHECK(accent.strength > 0.0);
            CHECK(accent.strength <= 1.0);
            before = accent.end_s;
            const auto& word = spoken->utterance.words.at(static_cast<std::size_t>(accent.word));
            CHECK(accent.start_s >= word.start_s);
            CHECK(accent.end_s <= word.end_s);
        }

        auto aligner = speech::Aligner::load();
        REQUIRE(aligner.has_value());
        const auto recorded = recordedText(*aligner, spoken->sound, text);
        REQUIRE(recorded.has_value());
        CHECK(recorded->utterance.duration_s == spoken->utterance.duration_s);
        int alike = 0;
        for (const auto& a : spoken->utterance.accents)
            for (const auto& b : recorded->utterance.accents) alike += a.word == b.word ? 1 : 0;
        CHECK(alike * 2 > static_cast<int>(spoken->utterance.accents.size()));
    }

    TEST_CASE("the words of a voice that is a program are found in its sound") {
        const std::string text = "Put the red ball over there.";
        const auto path = std::filesystem::temp_directory_path() / "deixis_utterance_test.wav";
        REQUIRE(speech::writeWav(path, speech::speakByFlite(text, "rms")->sound).has_value());
        const auto voices =
            speech::Voices::with({{"lab", {"cat", path.string()}, std::chrono::seconds(10), "en"},
                                  {"foreign", {"cat", path.string()}, std::chrono::seconds(10), "ko"}});
        auto aligner = speech::Aligner::load();
        REQUIRE(aligner.has_value());
        const auto spoken = spokenText(*voices, &*aligner, text, "lab");
        REQUIRE(spoken.has_value());
        CHECK(spoken->utterance.words.size() == 6);
        CHECK(contains(spokenText(*voices, nullptr, text, "lab").error().text(),
                       "without PocketSphinx's model"));
        CHECK_FALSE(spokenText(*voices, &*aligner, "Something else is what I say.", "lab").has_value());
        const auto foreign = spokenText(*voices, nullptr, "\xEC\x95\x88\xEB\x85\x95", "foreign");
        REQUIRE(foreign.has_value());
        CHECK(foreign->utterance.words.empty());
        CHECK(foreign->utterance.duration_s == spoken->utterance.duration_s);
        std::filesystem::remove(path);
    }
}
