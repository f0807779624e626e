// Spearman's rank correlation with its test.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "results/statistics/rational.hpp"

namespace deixis::results {

struct SpearmanTest {
    int n = 0;               ///< pairs
    double rho = 0.0;        ///< in [-1, 1]
    double p = 1.0;          ///< two-sided: min(1, twice the smaller of the next two)
    double p_greater = 1.0;  ///< against rho > 0
    double p_less = 1.0;     ///< against rho < 0
    std::string method;      ///< "exact", "t", or "undefined" (fewer than two pairs, or one side constant)
};

/// Pearson's correlation of the midranks (equal numbers share the mean of their ranks). p up to nine pairs is
/// exact, with ties too: among all n! pairings of the observed ranks. Beyond, Student's t with n - 2 degrees
/// of freedom, as SciPy's spearmanr and R's cor.test(exact = FALSE). Throws std::invalid_argument if the
/// sides differ in length.
[[nodiscard]] SpearmanTest spearman(std::span<const double> x, std::span<const double> y);
[[nodiscard]] SpearmanTest spearman(std::span<const Rational> x, std::span<const Rational> y);

}  // namespace deixis::results
