// Hodges and Lehmann's estimates (1963) with confidence intervals: the shifts that the reported tests do not
// reject.
#pragma once

#include <optional>
#include <span>

#include "results/statistics/rational.hpp"

namespace deixis::results {

struct HodgesLehmann {
    std::optional<double> estimate{};  ///< none if there are no values
    std::optional<double> lower{};     ///< none where every shift is rejected
    std::optional<double> upper{};
    bool lower_included = true;  ///< the end itself is not rejected
    bool upper_included = true;
    std::optional<double> level{};  ///< that the interval achieves; lower than asked for where n is too small
};

/// Of paired differences: the median of all n(n+1)/2 Walsh averages (d_i + d_j) / 2, i <= j. Differences of
/// zero are among them: zero is a difference as good as any other where an effect is estimated. The interval
/// inverts signedRankTest(): it holds the shifts whose p, of the differences less that shift, exceeds 1 -
/// level, from the smallest to the largest; it holds 0 exactly where the test's own p exceeds 1 - level.
/// Where n is too small for that level it is the widest there is, with its own. `level`: below 1; 0: no
/// interval. `p`: of the test itself. Of many values the ends are sought with an expansion of p
/// (docs/statistics.md).
[[nodiscard]] HodgesLehmann hodgesLehmann(std::span<const Rational> differences, double level, double p);

/// Of two independent samples: the median of all differences a_i - b_j; the interval likewise inverts
/// rankSumTest().
[[nodiscard]] HodgesLehmann hodgesLehmannShift(std::span<const Rational> a, std::span<const Rational> b,
                                               double level, double p);

}  // namespace deixis::results
