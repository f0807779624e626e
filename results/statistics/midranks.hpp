// Ranks that ties share, doubled so that they are whole numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "results/statistics/rational.hpp"

namespace deixis::results {

struct Midranks {
    std::vector<std::int64_t> doubled;  ///< twice the mean rank of each value, from 2 up; order of the input
    std::vector<std::int64_t> tie_sizes;  ///< of groups of two and more equal values, in ascending order

    /// sum of t^3 - t over the groups
    [[nodiscard]] double tieTerm() const;
};

[[nodiscard]] Midranks midranks(std::span<const Rational> values);
[[nodiscard]] Midranks midranks(std::span<const double> values);

}  // namespace deixis::results
