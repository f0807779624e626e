// Hodges and Lehmann's estimates (1963) with the confidence intervals that belong to the exact rank tests.
#pragma once

#include <optional>
#include <span>

#include "results/rational.hpp"

namespace deixis::results {

struct HodgesLehmann {
    std::optional<double> estimate{};  ///< none where there are no values
    std::optional<double> lower{};     ///< of the closed interval
    std::optional<double> upper{};
    std::optional<double> level{};  ///< that the interval achieves; lower than asked for where n is too small
};

/// Of paired differences: the median of all n(n+1)/2 Walsh averages (d_i + d_j) / 2, i <= j. Differences of
/// zero are among them: zero is a difference as good as any other where an effect is estimated. The interval
/// runs from the k-th smallest to the k-th largest Walsh average, k being the largest with P(W <= k - 1) <=
/// (1 - level) / 2 for the signed-rank statistic W of n untied differences; it is the widest there is where
/// no k is. Exact up to n = 2,000, then from the normal approximation. `level` lies between 0 and 1.
[[nodiscard]] HodgesLehmann hodgesLehmann(std::span<const Rational> differences, double level);

/// Of two independent samples: the median of all differences a_i - b_j; the interval likewise, from the
/// rank-sum statistic, exact up to 400 values in all.
[[nodiscard]] HodgesLehmann hodgesLehmannShift(std::span<const Rational> a, std::span<const Rational> b,
                                               double level);

}  // namespace deixis::results
