#include "results/statistics/holm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace deixis::results {

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (!std::isnan(p[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
    std::vector<double> adjusted(p.size(), std::numeric_limits<double>::quiet_NaN());
    double largest = 0.0;
    for (std::size_t step = 0; step < order.size(); ++step) {
        const auto left = static_cast<double>(order.size() - step);
        largest = std::max(largest, std::min(1.0, left * p[order[step]]));
        adjusted[order[step]] = largest;
    }
    return adjusted;
}

}  // namespace deixis::results
