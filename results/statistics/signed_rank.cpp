#include "results/statistics/signed_rank.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "midranks.hpp"
#include "rank_distributions.hpp"
#include "rank_sums.hpp"

namespace deixis::results {

namespace {

/// Ranks of all magnitudes, zeros too; then those of the zeros go.
std::vector<std::int64_t> prattRanks(const std::vector<std::int64_t>& without_zeros, int n_zero) {
    std::vector<std::int64_t> ranks = without_zeros;
    for (std::int64_t& rank : ranks) rank += 2 * std::int64_t{n_zero};
    return ranks;
}

}  // namespace

SignedRankTest signedRankTest(std::span<const Rational> differences, double level) {
    SignedRankTest test;
    test.n_pairs = static_cast<int>(differences.size());
    std::vector<Rational> magnitudes;
    std::vector<bool> positive;
    for (const Rational& difference : differences) {
        const int sign = difference.sign();
        (sign > 0 ? test.n_positive : sign < 0 ? test.n_negative : test.n_zero) += 1;
        if (sign == 0) continue;
        magnitudes.push_back(abs(difference));
        positive.push_back(sign > 0);
    }
    if (test.n_pairs > 0) test.paired_superiority = (test.n_positive + 0.5 * test.n_zero) / test.n_pairs;
    if (magnitudes.empty()) {
        test.hodges_lehmann = hodgesLehmann(differences, level, 1.0);
        test.method = "no differences";
        return test;
    }
    const Midranks ranks = midranks(magnitudes);
    test.ties = static_cast<int>(ranks.tie_sizes.size());
    const SignedRankSums sums(ranks.doubled, positive);
    test.w_plus = sums.plus();
    test.w_minus = sums.minus();
    const bool exact = magnitudes.size() <= signed_rank_exact_limit;
    test.method = !exact ? "normal approximation" : test.ties > 0 ? "exact with ties" : "exact";
    const RankTails tails = sums.tails();
    test.p_two_sided = tails.twoSided();
    test.hodges_lehmann = hodgesLehmann(differences, level, test.p_two_sided);
    test.p_greater = tails.upper_tail;
    test.p_less = tails.lower_tail;
    test.smallest_p = std::ldexp(1.0, 1 - static_cast<int>(magnitudes.size()));

    const SignedRankSums pratt(prattRanks(ranks.doubled, test.n_zero), positive);
    test.pratt_w_plus = pratt.plus();
    test.pratt_p_two_sided = test.n_zero > 0 ? pratt.tails().twoSided() : test.p_two_sided;

    test.z = sums.z();
    test.normal_p_two_sided = std::min(1.0, std::erfc(std::abs(*test.z) / std::sqrt(2.0)));
    test.rank_biserial = (test.w_plus - test.w_minus) / (test.w_plus + test.w_minus);
    return test;
}

}  // namespace deixis::results
