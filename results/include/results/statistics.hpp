// Exact rank statistics. Conventions are documented in docs/statistics.md.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace deixis::results {

/// Wilcoxon signed-rank test, two-sided, of paired differences.
struct SignedRankTest {
    int n = 0;       ///< pairs
    int n_zero = 0;  ///< differences of zero, dropped before ranking (Wilcoxon's own rule)
    double w_plus = 0.0;
    double w_minus = 0.0;
    double p = 1.0;
    std::string method;  ///< "exact", "exact with ties", "normal approximation", "no differences"
};

/// Differences no larger than this count as zero: means of answers that are equal on paper differ by
/// rounding.
inline constexpr double zero_difference = 1e-12;

/// W+ and W- are the sums of the midranks of the positive and the negative differences. Exact for up to 100
/// differences other than zero, with ties too; beyond, the normal approximation with tie and continuity
/// corrections. p is 1 where all differences are zero.
[[nodiscard]] SignedRankTest signedRankTest(std::span<const double> differences);

/// Holm's step-down adjustment; the order of the input is kept. Each in [0, 1].
[[nodiscard]] std::vector<double> holm(std::span<const double> p);

[[nodiscard]] double mean(std::span<const double> x);
[[nodiscard]] double sampleSd(std::span<const double> x);        ///< n - 1; 0 for fewer than two
[[nodiscard]] double quantile(std::vector<double> x, double q);  ///< R's type 7

}  // namespace deixis::results
