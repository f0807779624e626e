// A sound: one channel of samples in memory, as speech is read, made and measured here.
#pragma once

#include <cstddef>
#include <vector>

namespace deixis::speech {

inline constexpr int min_rate_hz = 4000;
inline constexpr int max_rate_hz = 192000;
/// The longest sound that is read or made, so that memory and times of answering are bounded.
inline constexpr double max_sound_s = 30.0 * 60.0;

struct Sound {
    int rate_hz = 16000;         ///< min_rate_hz to max_rate_hz
    std::vector<float> samples;  ///< finite, -1 to 1
};

[[nodiscard]] inline double durationOf(const Sound& sound) {
    return static_cast<double>(sound.samples.size()) / sound.rate_hz;
}

/// The lowest and highest sample of a stretch of sound: one column of a drawn waveform.
struct Peaks {
    float low = 0.0F;
    float high = 0.0F;
};

/// The sound in `columns` stretches of the same length, to the sample; where there are more columns than
/// samples, neighbours show the same one. Empty for a sound without samples.
[[nodiscard]] std::vector<Peaks> envelopeOf(const Sound& sound, std::size_t columns);

/// The same sound at another rate (min_rate_hz to max_rate_hz), by a sinc under a Kaiser window: what lies
/// below 0.88 of the lower rate's half is kept within 0.01 dB, what lies above that half is lowered by 90 dB
/// (Oppenheim & Schafer, Discrete-Time Signal Processing, section 7.5.3). As many samples as fit in the
/// sound's duration, rounded; the times of what is heard do not shift.
[[nodiscard]] Sound resampled(const Sound& sound, int rate_hz);

}  // namespace deixis::speech
