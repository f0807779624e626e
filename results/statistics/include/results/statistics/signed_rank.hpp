// Wilcoxon's signed-rank test of paired differences. Conventions: docs/statistics.md.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "results/statistics/hodges_lehmann.hpp"
#include "results/statistics/rational.hpp"

namespace deixis::results {

struct SignedRankTest {
    int n_pairs = 0;  ///< complete pairs, zeros included
    int n_zero = 0;   ///< differences of zero, dropped before ranking (Wilcoxon's own rule)
    int n_positive = 0;
    int n_negative = 0;
    int ties = 0;          ///< groups of two and more equal magnitudes other than zero
    double w_plus = 0.0;   ///< sum of the midranks of the positive differences
    double w_minus = 0.0;  ///< and of the negative ones
    std::string method;    ///< "exact", "exact with ties", "normal approximation", "no differences"
    double p_two_sided =
        1.0;                  ///< min(1, twice the smaller of the next two); 1 where all differences are zero
    double p_greater = 1.0;   ///< P(W+ >= w_plus): against the differences being larger than 0
    double p_less = 1.0;      ///< P(W+ <= w_plus)
    double smallest_p = 1.0;  ///< the smallest two-sided p that this many differences can give

    /// Zeros take part in the ranking and drop out of the sums (Pratt 1959). Without zeros the same as above.
    double pratt_w_plus = 0.0;
    double pratt_p_two_sided = 1.0;

    /// (W+ - its mean) / SD, the SD corrected for ties, the numerator by 1/2 towards 0. None if all
    /// differences are zero.
    std::optional<double> z{};
    double normal_p_two_sided = 1.0;  ///< from z

    std::optional<double> rank_biserial{};       ///< (W+ - W-) / (W+ + W-); none if all are zero
    std::optional<double> paired_superiority{};  ///< (n_positive + n_zero / 2) / n_pairs; none without pairs
    HodgesLehmann hodges_lehmann{};
};

/// Conditional on the observed magnitudes, every pattern of signs being equally likely: exact with ties up
/// to 2,000 differences other than zero, then normal with tie and continuity correction. `level` (between 0
/// and 1) is asked of the interval.
[[nodiscard]] SignedRankTest signedRankTest(std::span<const Rational> differences, double level = 0.95);

}  // namespace deixis::results
