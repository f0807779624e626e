#include "results/statistics/rank_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "midranks.hpp"
#include "rank_distributions.hpp"
#include "rank_sums.hpp"

namespace deixis::results {

RankSumTest rankSumTest(std::span<const Rational> a, std::span<const Rational> b, double level) {
    RankSumTest test;
    test.n_a = static_cast<int>(a.size());
    test.n_b = static_cast<int>(b.size());
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
    const bool exact = all.size() <= rank_sum_exact_limit;
    test.method = !exact ? "normal approximation" : test.ties > 0 ? "exact with ties" : "exact";
    const RankTails tails = rankSumTails(ranks.doubled, a.size());
    test.p_less = tails.lower_tail;
    test.p_greater = tails.upper_tail;
    test.p_two_sided = tails.twoSided();
    test.hodges_lehmann = hodgesLehmannShift(a, b, level, *test.p_two_sided);
    return test;
}

}  // namespace deixis::results
