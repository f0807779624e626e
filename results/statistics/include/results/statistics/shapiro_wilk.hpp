// Shapiro and Wilk's test of normality; for description only, no other test here depends on it.
#pragma once

#include <optional>
#include <span>

#include "results/statistics/rational.hpp"

namespace deixis::results {

struct ShapiroWilk {
    int n = 0;
    std::optional<double> w{};  ///< in (0, 1]; none where n is not in 3..5000 or all values are equal
    std::optional<double> p{};
};

/// Royston's approximation (1995, algorithm AS R94).
[[nodiscard]] ShapiroWilk shapiroWilk(std::span<const Rational> x);

}  // namespace deixis::results
