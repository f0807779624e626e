#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "speech/sound/sound.hpp"

namespace deixis::speech {

namespace {

constexpr double stop_band_db = 90.0;
constexpr int half_taps = 48;  ///< on each side, counted in samples of the lower rate

/// The modified Bessel function of order 0, by its power series.
double besselI0(double x) {
    double term = 1.0, sum = 1.0;
    for (int k = 1; term > 1e-12 * sum; ++k) {
        const double factor = x / (2.0 * k);
        term *= factor * factor;
        sum += term;
    }
    return sum;
}

/// The low-pass filter at a distance from its middle in samples of the lower rate.
class Kernel {
  public:
    Kernel() : at_middle_(besselI0(beta_)) {}

    [[nodiscard]] double operator()(double distance) const {
        const double along = distance / half_taps;
        if (std::abs(along) >= 1.0) return 0.0;
        const double window = besselI0(beta_ * std::sqrt(1.0 - along * along)) / at_middle_;
        const double phase = std::numbers::pi * cutoff_ * distance;
        return window * cutoff_ * (std::abs(phase) < 1e-9 ? 1.0 : std::sin(phase) / phase);
    }

  private:
    // Kaiser's formulas: the window for this stop band, and how wide the passage into it is.
    static constexpr double beta_ = 0.1102 * (stop_band_db - 8.7);
    static constexpr double passage_ = (stop_band_db - 8.0) / (2.285 * 2 * half_taps * std::numbers::pi);
    /// Of half the lower rate: the passage ends where what is above would be heard as something else.
    static constexpr double cutoff_ = 1.0 - passage_ / 2.0;
    double at_middle_;
};

}  // namespace

Sound resampled(const Sound& sound, int rate_hz) {
    if (std::min(rate_hz, sound.rate_hz) < min_rate_hz || std::max(rate_hz, sound.rate_hz) > max_rate_hz)
        throw std::invalid_argument("resampled: a rate that no sound has");
    if (rate_hz == sound.rate_hz) return sound;

    // Output sample i lies at i * down / up of the input, between whose samples there are `up` places only.
    const std::int64_t common = std::gcd(rate_hz, sound.rate_hz);
    const std::int64_t up = rate_hz / common, down = sound.rate_hz / common;
    const double lower = std::min(1.0, static_cast<double>(up) / static_cast<double>(down));
    const auto reach = static_cast<std::int64_t>(std::ceil(half_taps / lower));
    const std::int64_t taps = 2 * reach;
    const Kernel kernel;
    std::vector<float> weights(static_cast<std::size_t>(up * taps));
    for (std::int64_t place = 0; place < up; ++place) {
        const double between = static_cast<double>(place) / static_cast<double>(up);
        double sum = 0.0;
        for (std::int64_t k = 0; k < taps; ++k)
            sum += kernel((static_cast<double>(k - reach + 1) - between) * lower);
        // Divided by their sum: a constant stays what it is at every place.
        for (std::int64_t k = 0; k < taps; ++k)
            weights[static_cast<std::size_t>(place * taps + k)] =
                static_cast<float>(kernel((static_cast<double>(k - reach + 1) - between) * lower) / sum);
    }

    const auto count = static_cast<std::int64_t>(sound.samples.size());
    Sound out{rate_hz, std::vector<float>(static_cast<std::size_t>((count * up + down / 2) / down))};
    for (std::size_t i = 0; i < out.samples.size(); ++i) {
        const std::int64_t position = static_cast<std::int64_t>(i) * down;
        const std::int64_t first = position / up - reach + 1;
        const float* const weight = &weights[static_cast<std::size_t>(position % up * taps)];
        double sum = 0.0;
        const std::int64_t end = std::min(taps, count - first);
        for (std::int64_t k = std::max<std::int64_t>(0, -first); k < end; ++k)
            sum += static_cast<double>(weight[k]) *
                   static_cast<double>(sound.samples[static_cast<std::size_t>(first + k)]);
        out.samples[i] = static_cast<float>(std::clamp(sum, -1.0, 1.0));
    }
    return out;
}

}  // namespace deixis::speech
