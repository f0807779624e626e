#include "results/statistics/proportion.hpp"

#include <algorithm>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

namespace deixis::results {

namespace {

using boost::math::complement;
using Counts = boost::counting_iterator<std::int64_t>;

double lowerTail(const boost::math::binomial& counts, std::int64_t k) {
    return k < 0 ? 0.0 : boost::math::cdf(counts, static_cast<double>(k));
}

double upperTail(const boost::math::binomial& counts, std::int64_t k) {
    return k <= 0 ? 1.0 : boost::math::cdf(complement(counts, static_cast<double>(k - 1)));
}

/// All counts no more likely than `found`. Probabilities rise up to the mode and fall from there, so that the
/// far tail's end is found by halving. Equal ones may differ in their last digits: R's allowance of 1e-7.
double noMoreLikely(const boost::math::binomial& counts, std::int64_t found, std::int64_t n) {
    const auto chanceOf = [&](std::int64_t k) { return boost::math::pdf(counts, static_cast<double>(k)); };
    const double max = chanceOf(found) * (1.0 + 1e-7);
    const double expected = static_cast<double>(n) * counts.success_fraction();
    if (static_cast<double>(found) == expected) return 1.0;
    if (static_cast<double>(found) < expected) {
        const auto first =
            *std::partition_point(Counts(static_cast<std::int64_t>(std::ceil(expected))), Counts(n + 1),
                                  [&](std::int64_t k) { return chanceOf(k) > max; });
        return std::min(1.0, lowerTail(counts, found) + (first > n ? 0.0 : upperTail(counts, first)));
    }
    const auto beyond =
        *std::partition_point(Counts(0), Counts(static_cast<std::int64_t>(std::floor(expected)) + 1),
                              [&](std::int64_t k) { return chanceOf(k) <= max; });
    return std::min(1.0, lowerTail(counts, beyond - 1) + upperTail(counts, found));
}

}  // namespace

Proportion proportion(std::int64_t successes, std::int64_t n, double level, std::optional<double> chance) {
    Proportion out;
    out.successes = successes;
    out.n = n;
    if (n == 0) return out;
    const auto hits = static_cast<double>(successes);
    const auto misses = static_cast<double>(n - successes);
    const double tail = 0.5 * (1.0 - level);
    out.estimate = hits / static_cast<double>(n);
    out.lower = successes == 0
                    ? 0.0
                    : boost::math::quantile(boost::math::beta_distribution<>(hits, misses + 1.0), tail);
    out.upper =
        successes == n
            ? 1.0
            : boost::math::quantile(complement(boost::math::beta_distribution<>(hits + 1.0, misses), tail));
    if (!chance) return out;
    const boost::math::binomial counts(static_cast<double>(n), *chance);
    out.p_chance = noMoreLikely(counts, successes, n);
    out.p_greater = upperTail(counts, successes);
    out.p_less = lowerTail(counts, successes);
    return out;
}

}  // namespace deixis::results
