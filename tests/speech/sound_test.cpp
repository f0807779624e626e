#include "speech/sound/sound.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sounds.hpp"

using namespace deixis;
using deixis::tests::sine;
using doctest::Approx;
using speech::resampled;

namespace {

/// The largest difference from a sine, away from the ends, where the sound begins and ends at once.
double worstAgainstSine(const speech::Sound& sound, double hz, double level) {
    double worst = 0.0;
    const auto count = static_cast<int>(sound.samples.size());
    for (int i = count / 10; i < count * 9 / 10; ++i) {
        const double t = static_cast<double>(i) / sound.rate_hz;
        const double expected = level * std::sin(2.0 * std::numbers::pi * hz * t);
        worst = std::max(
            worst, std::abs(static_cast<double>(sound.samples[static_cast<std::size_t>(i)]) - expected));
    }
    return worst;
}

}  // namespace

TEST_SUITE("speech/sound") {
    TEST_CASE("a resampled sine is the sine, in phase") {
        const int rates[][2]{{44100, 16000}, {48000, 16000}, {16000, 44100}, {8000, 16000},
                             {22050, 16000}, {16000, 8000},  {11025, 16000}, {16000, 15999}};
        for (const auto& pair : rates) {
            const int from = pair[0], to = pair[1];
            CAPTURE(from);
            CAPTURE(to);
            const double half = 0.5 * std::min(from, to);
            for (const double hz : {100.0, 0.3 * half, 0.88 * half}) {
                CAPTURE(hz);
                const auto in = sine(from, 0.5, hz);
                const auto out = resampled(in, to);
                CHECK(out.rate_hz == to);
                const double count = static_cast<double>(in.samples.size()) * to / from;
                CHECK(out.samples.size() == static_cast<std::size_t>(std::lround(count)));
                CHECK(worstAgainstSine(out, hz, 0.5) < 0.5 * 0.0012);  // 0.01 dB
            }
        }
    }

    TEST_CASE("what the lower rate cannot have is 90 dB lower") {
        for (const double hz : {8000.0, 8200.0, 10000.0, 15900.0, 20000.0}) {
            CAPTURE(hz);
            const auto out = resampled(sine(44100, 0.5, hz), 16000);
            CHECK(worstAgainstSine(out, 0.0, 0.0) < 0.5 * 3.5e-5);
        }
    }

    TEST_CASE("a constant stays, and the same rate changes nothing") {
        const auto constant = deixis::tests::soundOf(44100, 0.5, [](double) { return 0.25; });
        const auto out = resampled(constant, 16000);
        for (std::size_t i = 1000; i < 7000; ++i) CHECK(out.samples[i] == Approx(0.25).epsilon(1e-6));
        CHECK(resampled(constant, 44100).samples == constant.samples);
        CHECK(resampled({16000, {}}, 8000).samples.empty());
    }

    TEST_CASE("the envelope has each column's lowest and highest sample") {
        const speech::Sound sound{8000, {0.1F, -0.2F, 0.3F, 0.4F, -0.5F, 0.0F, 0.9F}};
        const auto three = envelopeOf(sound, 3);  // 0-1, 2-3, 4-6
        REQUIRE(three.size() == 3);
        CHECK(three[0].low == -0.2F);
        CHECK(three[0].high == 0.1F);
        CHECK(three[1].low == 0.3F);
        CHECK(three[1].high == 0.4F);
        CHECK(three[2].low == -0.5F);
        CHECK(three[2].high == 0.9F);
        const auto many = envelopeOf(sound, 14);
        REQUIRE(many.size() == 14);
        CHECK(many[0].low == 0.1F);
        CHECK(many[13].high == 0.9F);
        CHECK(speech::envelopeOf({8000, {}}, 5).empty());
    }
}
