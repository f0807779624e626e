// Holm's correction for several tests.
#pragma once

#include <span>
#include <vector>

namespace deixis::results {

/// Holm's step-down adjustment (1979); the order of the input is kept. Each is at most 1. A missing p (NaN)
/// stays missing and does not count in the family's size, as in R's p.adjust.
[[nodiscard]] std::vector<double> holm(std::span<const double> p);

}  // namespace deixis::results
