// Friedman's test: one score per person under each of several conditions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "results/statistics/rational.hpp"

namespace deixis::results {

/// Iman & Davenport (1980): less conservative than the chi-squared.
struct ImanDavenport {
    std::optional<double> f{};  ///< none where infinite: all rank the conditions alike
    int df1 = 0;
    int df2 = 0;
    std::optional<double> p{};  ///< 0 where F is infinite
};

struct FriedmanTest {
    int n = 0;     ///< persons
    int k = 0;     ///< conditions
    int ties = 0;  ///< groups of equal scores within a person
    std::vector<double> mean_ranks{};
    int df = 0;
    /// All of the following: none where every person gives all conditions the same score, or n is 0.
    std::optional<double> chi2{};  ///< corrected for ties
    std::optional<double> p{};
    std::optional<double> kendalls_w{};  ///< chi2 / (n (k - 1)), in [0, 1]
    ImanDavenport iman_davenport{};      ///< none for fewer than two persons, too
};

/// Each row holds one person's scores under the same k >= 2 conditions.
[[nodiscard]] FriedmanTest friedmanTest(std::span<const std::vector<Rational>> rows);

}  // namespace deixis::results
