#include "results/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace deixis::results {

namespace {

/// Up to this many pairs the null distribution is computed in full. Its smallest probability, 2^-100, lies
/// well within a double's range, and the relative error of each stays below 100 * 2^-53.
constexpr std::size_t exact_limit = 100;

/// Twice the midrank of each magnitude: whole numbers, also with ties.
struct Ranks {
    std::vector<int> doubled;
    std::vector<int> tie_sizes;  ///< of groups of two and more
};

Ranks rank(const std::vector<double>& magnitudes) {
    std::vector<std::size_t> order(magnitudes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return magnitudes[i] < magnitudes[j]; });
    // Means of ratings and proportions differ in their last bits where they are equal on paper.
    const auto tied = [&](std::size_t i, std::size_t j) {
        return magnitudes[order[j]] - magnitudes[order[i]] <= zero_difference;
    };
    Ranks ranks;
    ranks.doubled.resize(magnitudes.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && tied(last, last + 1)) ++last;
        for (std::size_t i = first; i <= last; ++i)
            ranks.doubled[order[i]] = static_cast<int>(first + last + 2);
        if (last > first) ranks.tie_sizes.push_back(static_cast<int>(last - first + 1));
        first = last + 1;
    }
    return ranks;
}

/// Two-sided p of a doubled rank sum under random signs: the probability of each sum is built up rank by
/// rank.
double exactP(const std::vector<int>& doubled, int doubled_w_plus) {
    std::vector<double> chances(1, 1.0);
    for (const int r : doubled) {
        std::vector<double> next(chances.size() + static_cast<std::size_t>(r), 0.0);
        for (std::size_t sum = 0; sum < chances.size(); ++sum) {
            next[sum] += 0.5 * chances[sum];
            next[sum + static_cast<std::size_t>(r)] += 0.5 * chances[sum];
        }
        chances = std::move(next);
    }
    // The null distribution is symmetric: the nearer tail is the smaller one.
    const auto w = static_cast<std::size_t>(doubled_w_plus);
    const std::size_t tail = std::min(w, chances.size() - 1 - w);
    double p = 0.0;
    for (std::size_t sum = 0; sum <= tail; ++sum) p += chances[sum];
    return std::min(1.0, 2.0 * p);
}

/// With the correction for ties in the variance and the continuity correction of one half.
double approximateP(std::size_t pairs, const std::vector<int>& tie_sizes, double w_plus) {
    const auto n = static_cast<double>(pairs);
    double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0;
    for (const int size : tie_sizes) {
        const double t = size;
        variance -= (t * t * t - t) / 48.0;
    }
    const double distance = std::abs(w_plus - n * (n + 1.0) / 4.0);
    const double z = std::max(0.0, distance - 0.5) / std::sqrt(variance);
    return std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(boost::math::normal(), z)));
}

}  // namespace

SignedRankTest signedRankTest(std::span<const double> differences) {
    SignedRankTest test;
    test.n = static_cast<int>(differences.size());
    std::vector<double> magnitudes;
    std::vector<bool> positive;
    for (const double d : differences) {
        // A difference of means that are equal on paper is a zero, too.
        if (std::abs(d) <= zero_difference) {
            ++test.n_zero;
            continue;
        }
        magnitudes.push_back(std::abs(d));
        positive.push_back(d > 0.0);
    }
    if (magnitudes.empty()) {
        test.method = "no differences";
        return test;
    }
    const Ranks ranks = rank(magnitudes);
    int doubled_w_plus = 0;
    int doubled_w_minus = 0;
    for (std::size_t i = 0; i < magnitudes.size(); ++i)
        (positive[i] ? doubled_w_plus : doubled_w_minus) += ranks.doubled[i];
    test.w_plus = doubled_w_plus / 2.0;
    test.w_minus = doubled_w_minus / 2.0;
    if (magnitudes.size() <= exact_limit) {
        test.p = exactP(ranks.doubled, doubled_w_plus);
        test.method = ranks.tie_sizes.empty() ? "exact" : "exact with ties";
    } else {
        test.p = approximateP(magnitudes.size(), ranks.tie_sizes, test.w_plus);
        test.method = "normal approximation";
    }
    return test;
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
    std::vector<double> adjusted(p.size());
    double largest = 0.0;
    for (std::size_t step = 0; step < order.size(); ++step) {
        const auto left = static_cast<double>(order.size() - step);
        largest = std::max(largest, std::min(1.0, left * p[order[step]]));
        adjusted[order[step]] = largest;
    }
    return adjusted;
}

double mean(std::span<const double> x) {
    if (x.empty()) return 0.0;
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double sampleSd(std::span<const double> x) {
    if (x.size() < 2) return 0.0;
    const double centre = mean(x);
    double squares = 0.0;
    for (const double value : x) squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(x.size() - 1));
}

double quantile(std::vector<double> x, double q) {
    if (x.empty()) return 0.0;
    std::sort(x.begin(), x.end());
    const double position = q * static_cast<double>(x.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, x.size() - 1);
    return x[below] + (position - static_cast<double>(below)) * (x[above] - x[below]);
}

}  // namespace deixis::results
