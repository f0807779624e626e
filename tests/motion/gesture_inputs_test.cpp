// What the gesture model hears and reads.
#include "motion/speech_gestures/gesture_inputs.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/pose.hpp"

using namespace deixis;
using namespace deixis::motion;

namespace {

std::vector<float> tone(double hz, double size, double seconds) {
    std::vector<float> out;
    for (int i = 0; i < static_cast<int>(seconds * speech_rate_hz); ++i)
        out.push_back(static_cast<float>(size * std::sin(2.0 * pi * hz * i / speech_rate_hz)));
    return out;
}

WordVectors threeWords() {
    Eigen::MatrixXf vectors(2, 3);
    vectors << 1.0F, 2.0F, 3.0F, -1.0F, -2.0F, -3.0F;
    return {{"shelf", "it", "dont"}, vectors};
}

}  // namespace

TEST_SUITE("motion/gesture_inputs") {
    TEST_CASE("a tone stays the tone at 16.2 kHz, and every speech is as loud as the next") {
        for (const double size : {0.01, 0.8}) {
            const auto heard = heardSound(tone(440.0, size, 1.0));
            REQUIRE(heard.size() == 16200);
            for (std::size_t i = 100; i < 16100; ++i) {
                const double expected =
                    std::sqrt(2.0) * std::sin(2.0 * pi * 440.0 * static_cast<double>(i) / 16200.0);
                REQUIRE(std::abs(heard[i] - expected) < 0.01);
            }
        }
        // Silence beside a tone does not make it louder, and a recording of next to nothing stays quiet.
        auto with_pause = tone(440.0, 0.5, 1.0);
        with_pause.resize(64000, 0.0F);
        CHECK(std::abs(heardSound(with_pause)[4000] - heardSound(tone(440.0, 0.5, 1.0))[4000]) < 0.01);
        const auto quiet = heardSound(tone(440.0, 1e-6, 1.0));
        CHECK(*std::max_element(quiet.begin(), quiet.end()) < 0.02F);
        CHECK(heardSound({}).empty());
        const std::vector<float> broken{0.5F, NAN, INFINITY, -0.5F};
        for (const float value : heardSound(broken)) CHECK(std::isfinite(value));
    }

    TEST_CASE("a frame's part of the sound is the same in every window, and zeros are around the sound") {
        const auto heard = heardSound(tone(200.0, 0.5, 3.0));
        const auto all = heardAround(heard, 0, 45);
        const auto later = heardAround(heard, 10, 5);
        REQUIRE(all.size() == 44 * 1080 + 3025);
        for (std::size_t i = 0; i < later.size(); ++i) REQUIRE(later[i] == all[10 * 1080 + i]);
        CHECK(all[0] == 0.0F);
        CHECK(all[1511] == 0.0F);
        CHECK(all[1512 + 20] == heard[20]);  // the middle of what frame 0 hears is the sound's begin
        for (const float value : heardAround(heard, 50, 3)) CHECK(value == 0.0F);
        for (const float value : heardAround({}, 0, 3)) CHECK(value == 0.0F);
    }

    TEST_CASE("words are found in any case, with punctuation around and in them; others are zeros") {
        const WordVectors words = threeWords();
        CHECK(words.vectorOf("Shelf,")[0] == 1.0F);
        CHECK(words.vectorOf("\xE2\x80\x9CSHELF\xE2\x80\x9D")[0] == 1.0F);
        CHECK(words.vectorOf("it's")[0] == 2.0F);
        CHECK(words.vectorOf("it\xE2\x80\x99s")[0] == 2.0F);
        CHECK(words.vectorOf("Don't")[0] == 3.0F);
        for (const char* unknown : {"table", "", "...", "'", "'it"}) {
            CAPTURE(unknown);
            CHECK(words.vectorOf(unknown).size() == 2);
        }
        CHECK_FALSE(words.knows("table"));
        CHECK_FALSE(words.knows("..."));
        CHECK(words.vectorOf("table").isZero());
    }

    TEST_CASE("a word stands at the frame in which it starts, and two that start in one follow each other") {
        Utterance utterance;
        utterance.words = {
            {"It", 0.05, 0.1}, {"shelf", 0.06, 0.3}, {"table", 0.5, 0.8}, {"it", 1.0, 1.2}, {"it", 9.0, 9.5}};
        const auto frames = wordFrames(utterance, threeWords(), 30);
        REQUIRE(frames.cols() == 30);
        CHECK(frames(0, 0) == 2.0F);
        CHECK(frames(0, 1) == 1.0F);
        CHECK(frames(1, 15) == -2.0F);
        CHECK(frames.row(0).sum() == 5.0F);
    }

    TEST_CASE("vectors go into weights and come back") {
        NetworkWeights weights;
        threeWords().append(weights);
        const auto back = WordVectors::read(weights);
        REQUIRE(back.has_value());
        CHECK(back->count() == 3);
        CHECK(back->vectorOf("dont")[1] == -3.0F);
        weights.arrays.front().shape = {2, 2};
        CHECK_FALSE(WordVectors::read(weights).has_value());
        NetworkWeights none;
        WordVectors({}, Eigen::MatrixXf(4, 0)).append(none);
        CHECK(WordVectors::read(none).value().size() == 4);
    }
}
