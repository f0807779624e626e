// What the fits of an observer share; private to studies.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "studies/study_file/normal_probability.hpp"

namespace deixis::studies {

inline constexpr double min_noise_deg = 0.05;
inline constexpr double max_noise_deg = 40.0;
inline constexpr std::size_t noises = 96;  // evenly spaced in their logarithm

[[nodiscard]] inline double noiseAt(double place) {
    const double share = place / static_cast<double>(noises - 1);
    return min_noise_deg * std::pow(max_noise_deg / min_noise_deg, share);
}

[[nodiscard]] inline double gridPlace(double noise_deg) {
    const double share = std::log(noise_deg / min_noise_deg) / std::log(max_noise_deg / min_noise_deg);
    return std::clamp(share, 0.0, 1.0) * static_cast<double>(noises - 1);
}

inline constexpr double last_place = static_cast<double>(noises - 1);

[[nodiscard]] inline double logOf(double probability) {
    return std::log(std::max(probability, 1e-300));
}

struct Peak {
    double at = 0.0;
    double value = -std::numeric_limits<double>::infinity();
};

/// The highest of evenly spaced points, then by golden section between its neighbours.
template <typename Function>
[[nodiscard]] Peak highest(double low, double high, int points, Function function) {
    Peak best;
    const double step = (high - low) / (points - 1);
    for (int i = 0; i < points; ++i) {
        const double x = low + step * i;
        if (const double y = function(x); y > best.value) best = {x, y};
    }
    double a = std::max(low, best.at - step);
    double b = std::min(high, best.at + step);
    constexpr double golden = 0.6180339887498949;
    constexpr int rounds = 28;
    for (int i = 0; i < rounds; ++i) {
        const double c = b - golden * (b - a);
        const double d = a + golden * (b - a);
        const double at_c = function(c);
        const double at_d = function(d);
        if (at_c > best.value) best = {c, at_c};
        if (at_d > best.value) best = {d, at_d};
        (at_c >= at_d ? b : a) = at_c >= at_d ? d : c;
    }
    return best;
}

/// Where a profile falls to `wanted` between its peak and `end`, found by so many halvings; none where it
/// does not.
template <typename Profile>
[[nodiscard]] std::optional<double> crossing(double peak, double end, double wanted, int halvings,
                                             Profile profile) {
    if (profile(end) > wanted) return std::nullopt;
    double above = peak;
    double below = end;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (above + below);
        (profile(middle) > wanted ? above : below) = middle;
    }
    return 0.5 * (above + below);
}

/// Half the quantile of chi-squared with one degree of freedom: how far a profile falls within its interval.
[[nodiscard]] inline double allowedFall(double level) {
    double low = 0.0;
    double high = 10.0;
    constexpr int halvings = 80;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (2.0 * normalBelow(middle) - 1.0 < level ? low : high) = middle;
    }
    return 0.5 * low * low;
}

}  // namespace deixis::studies
