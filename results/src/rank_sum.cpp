#include "results/rank_sum.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "midranks.hpp"
#include "rank_distributions.hpp"

namespace deixis::results {

namespace {

struct Tails {
    double at_most = 1.0;
    double at_least = 1.0;
};

/// P(W <= w) and P(W >= w) of the sum of `chosen` of the ranks.
Tails exactTails(const std::vector<std::int64_t>& ranks, std::size_t chosen, std::int64_t w) {
    const auto total = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
    // The rank sum of those not chosen is the rest: the smaller sample is the one to count.
    if (2 * chosen > ranks.size()) {
        const Tails others = exactTails(ranks, ranks.size() - chosen, total - w);
        return {others.at_least, others.at_most};
    }
    const auto all = static_cast<std::int64_t>(ranks.size());
    const auto part = static_cast<std::int64_t>(chosen);
    if (w * all <= total * part) {
        const TailProbability tail = rankSumTail(ranks, chosen, w);
        return {tail.at_most, tail.atLeast()};
    }
    // The upper tail is the lower one of the ranks counted from above.
    const std::int64_t turn = 2 * (all + 1);
    std::vector<std::int64_t> turned = ranks;
    for (std::int64_t& rank : turned) rank = turn - rank;
    const TailProbability tail = rankSumTail(turned, chosen, part * turn - w);
    return {tail.atLeast(), tail.at_most};
}

}  // namespace

RankSumTest rankSumTest(std::span<const Rational> a, std::span<const Rational> b, double level) {
    RankSumTest test;
    test.n_a = static_cast<int>(a.size());
    test.n_b = static_cast<int>(b.size());
    test.hodges_lehmann = hodgesLehmannShift(a, b, level);
    test.method = "undefined";
    if (a.empty() || b.empty()) return test;

    std::vector<Rational> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    const Midranks ranks = midranks(all);
    test.ties = static_cast<int>(ranks.tie_sizes.size());
    const auto split = ranks.doubled.begin() + static_cast<std::ptrdiff_t>(a.size());
    const auto doubled_w = std::accumulate(ranks.doubled.begin(), split, std::int64_t{0});
    const double n_a = test.n_a;
    const double n_b = test.n_b;
    const double n = n_a + n_b;
    test.w = static_cast<double>(doubled_w) / 2.0;
    test.u = test.w - n_a * (n_a + 1.0) / 2.0;
    test.a12 = test.u / (n_a * n_b);
    test.cliffs_delta = (2.0 * test.u - n_a * n_b) / (n_a * n_b);

    const double from_mean = test.u - n_a * n_b / 2.0;
    const double variance = n_a * n_b / 12.0 * (n + 1.0 - ranks.tieTerm() / (n * (n - 1.0)));
    const double sd = std::sqrt(std::max(0.0, variance));
    const bool all_equal = ranks.tie_sizes.size() == 1 && ranks.tie_sizes[0] == test.n_a + test.n_b;
    test.normal_p_two_sided = 1.0;
    if (!all_equal) {
        const double correction = from_mean > 0.0 ? 0.5 : from_mean < 0.0 ? -0.5 : 0.0;
        test.z = (from_mean - correction) / sd;
        test.normal_p_two_sided = std::min(1.0, std::erfc(std::abs(*test.z) / std::sqrt(2.0)));
    }
    Tails tails;
    if (all.size() <= rank_sum_exact_limit) {
        test.method = test.ties > 0 ? "exact with ties" : "exact";
        tails = exactTails(ranks.doubled, a.size(), doubled_w);
    } else {
        test.method = "normal approximation";
        if (!all_equal) {
            const boost::math::normal normal;
            tails.at_most = boost::math::cdf(normal, (from_mean + 0.5) / sd);
            tails.at_least = boost::math::cdf(boost::math::complement(normal, (from_mean - 0.5) / sd));
        }
    }
    test.p_less = tails.at_most;
    test.p_greater = tails.at_least;
    test.p_two_sided = std::min(1.0, 2.0 * std::min(tails.at_most, tails.at_least));
    return test;
}

}  // namespace deixis::results
