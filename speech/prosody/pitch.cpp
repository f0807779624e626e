#include "speech/prosody/pitch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace deixis::speech {

namespace {

constexpr double window_s = 0.025;
constexpr int analysis_rate_hz = 16000;  ///< at the most; formants above tell nothing of pitch
constexpr std::size_t most_candidates = 6;

// Costs, in units of the difference function: 0 for what repeats itself wholly, about 1 for noise.
constexpr double unvoiced_cost = 0.3;
constexpr double onset_cost = 0.14;  ///< from pitch to none, and back
constexpr double leap_cost = 0.35;   ///< for each octave
/// For each octave below the highest pitch: two periods repeat, too.
constexpr double low_octave_cost = 0.02;

/// What is softer is silence.
constexpr double softest_db = -60.0;
constexpr double softest_below_loudest_db = -45.0;

struct PitchCandidate {
    double hz = 0.0;  ///< 0: none
    double cost = 0.0;
};

/// YIN's steps 2 and 3 at one place: how little the signal is like itself after each lag.
class Difference {
  public:
    explicit Difference(const Sound& sound)
        : samples_(sound.samples.begin(), sound.samples.end()),
          rate_(sound.rate_hz),
          window_(static_cast<int>(std::lround(window_s * rate_))),
          shortest_(static_cast<int>(rate_ / highest_pitch_hz)),
          longest_(static_cast<int>(rate_ / lowest_pitch_hz) + 1),
          values_(static_cast<std::size_t>(longest_) + 2) {}

    /// The candidates at a time, the best first, without that of no pitch.
    [[nodiscard]] std::vector<PitchCandidate> candidatesAt(double time_s) {
        measure(static_cast<std::ptrdiff_t>(std::lround(time_s * rate_)) - (window_ + longest_) / 2);
        std::vector<PitchCandidate> out;
        for (int lag = std::max(2, shortest_); lag <= longest_; ++lag) {
            const double before = at(lag - 1), here = at(lag), after = at(lag + 1);
            if (here >= before || here > after || here > 1.0) continue;
            // Step 5: the minimum of the parabola through three values.
            const double bend = before - 2.0 * here + after;
            const double shift = bend > 0.0 ? 0.5 * (before - after) / bend : 0.0;
            const double hz = rate_ / (lag + shift);
            if (hz < lowest_pitch_hz || hz > highest_pitch_hz) continue;
            const double cost = here - 0.25 * (before - after) * shift;
            out.push_back({hz, std::max(0.0, cost) + low_octave_cost * std::log2(highest_pitch_hz / hz)});
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const auto& a, const auto& b) { return a.cost < b.cost; });
        if (out.size() > most_candidates) out.resize(most_candidates);
        return out;
    }

  private:
    [[nodiscard]] double at(int lag) const { return values_[static_cast<std::size_t>(lag)]; }

    void measure(std::ptrdiff_t start) {
        const auto length = static_cast<std::size_t>(window_ + longest_ + 1);
        cut_.assign(length, 0.0);
        for (std::size_t i = 0; i < length; ++i) {
            const std::ptrdiff_t from = start + static_cast<std::ptrdiff_t>(i);
            if (from >= 0 && from < std::ssize(samples_)) cut_[i] = samples_[static_cast<std::size_t>(from)];
        }
        values_[0] = 1.0;
        double sum = 0.0;
        for (std::size_t lag = 1; lag < values_.size(); ++lag) {
            double difference = 0.0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(window_); ++i) {
                const double d = cut_[i] - cut_[i + lag];
                difference += d * d;
            }
            sum += difference;
            values_[lag] = sum > 0.0 ? difference * static_cast<double>(lag) / sum : 1.0;
        }
    }

    std::vector<double> samples_;
    double rate_;
    int window_;
    int shortest_;
    int longest_;
    std::vector<double> values_;  ///< by lag
    std::vector<double> cut_{};
};

double stepCost(const PitchCandidate& from, const PitchCandidate& to) {
    if (from.hz == 0.0 && to.hz == 0.0) return 0.0;
    if (from.hz == 0.0 || to.hz == 0.0) return onset_cost;
    return leap_cost * std::abs(std::log2(to.hz / from.hz));
}

/// One candidate of each frame: those that cost least together (Viterbi's algorithm).
std::vector<double> cheapest(const std::vector<std::vector<PitchCandidate>>& frames) {
    std::vector<std::vector<std::size_t>> from(frames.size());
    std::vector<double> costs;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<double> next(frames[i].size());
        from[i].assign(frames[i].size(), 0);
        for (std::size_t c = 0; c < next.size(); ++c) {
            double best = i == 0 ? 0.0 : std::numeric_limits<double>::infinity();
            for (std::size_t b = 0; b < costs.size(); ++b) {
                const double cost = costs[b] + stepCost(frames[i - 1][b], frames[i][c]);
                if (cost >= best) continue;
                best = cost;
                from[i][c] = b;
            }
            next[c] = best + frames[i][c].cost;
        }
        costs = std::move(next);
    }
    std::vector<double> out(frames.size());
    auto at = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    for (std::size_t i = frames.size(); i-- > 0;) {
        out[i] = frames[i][at].hz;
        at = from[i][at];
    }
    return out;
}

}  // namespace

std::size_t prosodyFramesOf(const Sound& sound) {
    const std::size_t per_frame = prosody_frames_per_s;
    const auto rate = static_cast<std::size_t>(sound.rate_hz);
    return (sound.samples.size() * per_frame + rate - 1) / rate;
}

std::vector<double> pitchOf(const Sound& sound) {
    if (sound.samples.empty()) return {};
    const auto loudness = loudnessOf(sound);
    const double loudest = *std::max_element(loudness.begin(), loudness.end());
    const double softest = std::max(softest_db, loudest + softest_below_loudest_db);
    Difference difference(sound.rate_hz > analysis_rate_hz ? resampled(sound, analysis_rate_hz) : sound);
    std::vector<std::vector<PitchCandidate>> frames(loudness.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (loudness[i] > softest)
            frames[i] = difference.candidatesAt(static_cast<double>(i) / prosody_frames_per_s);
        frames[i].push_back({0.0, unvoiced_cost});
    }
    return cheapest(frames);
}

std::vector<double> loudnessOf(const Sound& sound) {
    const double rate = sound.rate_hz;
    const auto half = static_cast<std::ptrdiff_t>(window_s / 2.0 * rate);
    std::vector<double> window;
    double sum = 0.0;
    for (std::ptrdiff_t k = -half; k <= half; ++k) {
        window.push_back(0.5 + 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) /
                                              (static_cast<double>(half) + 1.0)));
        sum += window.back();
    }
    std::vector<double> out(prosodyFramesOf(sound));
    const std::ptrdiff_t count = std::ssize(sound.samples);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto middle =
            static_cast<std::ptrdiff_t>(std::lround(static_cast<double>(i) * rate / prosody_frames_per_s));
        double power = 0.0;
        for (std::ptrdiff_t k = std::max(-half, -middle); k <= half && middle + k < count; ++k) {
            const double sample = sound.samples[static_cast<std::size_t>(middle + k)];
            power += window[static_cast<std::size_t>(k + half)] * sample * sample;
        }
        out[i] = std::max(silence_db, 10.0 * std::log10(std::max(power / sum, 1e-12)));
    }
    return out;
}

}  // namespace deixis::speech
