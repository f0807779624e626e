// Sounds whose content is known.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::tests {

/// `wave` of the time in seconds.
template <typename Wave>
speech::Sound soundOf(int rate_hz, double duration_s, const Wave& wave) {
    speech::Sound out{rate_hz, {}};
    const auto count = static_cast<int>(std::lround(duration_s * rate_hz));
    for (int i = 0; i < count; ++i)
        out.samples.push_back(static_cast<float>(wave(static_cast<double>(i) / rate_hz)));
    return out;
}

inline speech::Sound sine(int rate_hz, double duration_s, double hz, double level = 0.5) {
    return soundOf(rate_hz, duration_s,
                   [&](double t) { return level * std::sin(2.0 * std::numbers::pi * hz * t); });
}

/// A voice-like sound: `harmonics` of a pitch, each weaker than the one before, whose phase is `cycles` of
/// the time.
template <typename Cycles>
speech::Sound hum(int rate_hz, double duration_s, const Cycles& cycles, int harmonics = 10) {
    return soundOf(rate_hz, duration_s, [&](double t) {
        double sum = 0.0;
        for (int k = 1; k <= harmonics; ++k) sum += std::sin(2.0 * std::numbers::pi * k * cycles(t)) / k;
        return 0.25 * sum;
    });
}

}  // namespace deixis::tests
