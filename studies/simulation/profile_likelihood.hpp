// What the fits of an observer share; private to studies.
#pragma once

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "studies/study_file/root.hpp"

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

/// The highest of evenly spaced points, then by Brent's search between its neighbours.
template <typename Function>
[[nodiscard]] Peak highest(double low, double high, int points, Function function) {
    Peak best;
    const double step = (high - low) / (points - 1);
    for (int i = 0; i < points; ++i) {
        const double x = low + step * i;
        if (const double y = function(x); y > best.value) best = {x, y};
    }
    constexpr int bits = std::numeric_limits<double>::digits / 2;  // more cannot be told of a peak
    const auto [at, below] = boost::math::tools::brent_find_minima([&](double x) { return -function(x); },
                                                                   std::max(low, best.at - step),
                                                                   std::min(high, best.at + step), bits);
    return -below > best.value ? Peak{at, -below} : best;
}

/// Where a profile falls to `wanted` between its peak and `end`, to half of `tolerance`; none where it does
/// not.
template <typename Profile>
[[nodiscard]] std::optional<double> crossing(double peak, double end, double wanted, double tolerance,
                                             Profile profile) {
    const auto above = [&](double at) { return profile(at) - wanted; };
    if (peak == end || above(end) > 0.0) return std::nullopt;
    return rootBetween(std::min(peak, end), std::max(peak, end), tolerance, above);
}

/// Half the quantile of chi-squared with one degree of freedom: how far a profile falls within its interval.
[[nodiscard]] inline double allowedFall(double level) {
    return 0.5 * boost::math::quantile(boost::math::chi_squared(1.0), level);
}

}  // namespace deixis::studies
