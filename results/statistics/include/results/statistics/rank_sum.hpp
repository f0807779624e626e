// Wilcoxon's rank-sum test (Mann and Whitney's U) of two independent samples.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "results/statistics/hodges_lehmann.hpp"
#include "results/statistics/rational.hpp"

namespace deixis::results {

struct RankSumTest {
    int n_a = 0;
    int n_b = 0;
    int ties = 0;    ///< groups of two and more equal values
    double w = 0.0;  ///< sum of the midranks of a
    double u = 0.0;  ///< pairs in which a is larger, equal ones counting half: w - n_a (n_a + 1) / 2
    std::string
        method;  ///< "exact", "exact with ties", "normal approximation", "undefined" (an empty sample)
    /// min(1, twice the smaller of the next two). None if a sample is empty; so for all that follows.
    std::optional<double> p_two_sided{};
    std::optional<double> p_greater{};  ///< P(U >= u): against a being larger
    std::optional<double> p_less{};     ///< P(U <= u)
    /// (U - its mean) / SD, the SD corrected for ties, the numerator by 1/2 towards 0. None if all values
    /// are equal.
    std::optional<double> z{};
    std::optional<double> normal_p_two_sided{};  ///< from z; 1 where all values are equal
    std::optional<double> a12{};                 ///< U / (n_a n_b), Vargha & Delaney (2000)
    std::optional<double> cliffs_delta{};        ///< 2 a12 - 1, Cliff (1993)
    HodgesLehmann hodges_lehmann{};              ///< of the shift a - b
};

/// Conditional on the observed values, every way to share them out among the samples being equally likely:
/// exact with ties up to 400 values in all, then normal with tie and continuity correction.
[[nodiscard]] RankSumTest rankSumTest(std::span<const Rational> a, std::span<const Rational> b,
                                      double level = 0.95);

}  // namespace deixis::results
