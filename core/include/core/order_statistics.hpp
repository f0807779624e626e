// Values by their rank: medians and the like.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace deixis {

/// The k-th smallest, from 0; `k` is below the number of values.
[[nodiscard]] inline double orderStatistic(std::vector<double> values, std::size_t k) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(k);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The middle one of at least one value; the mean of the middle two where their number is even.
[[nodiscard]] inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

/// One of the values: the higher of the middle two.
[[nodiscard]] inline double upperMedian(std::vector<double> values) {
    const std::size_t middle = values.size() / 2;
    return orderStatistic(std::move(values), middle);
}

}  // namespace deixis
