#include "midranks.hpp"

#include <algorithm>
#include <numeric>

#include "scaled_integers.hpp"

namespace deixis::results {

namespace {

template <typename T>
Midranks rankAll(std::span<const T> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
    Midranks ranks;
    ranks.doubled.resize(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
        for (std::size_t i = first; i <= last; ++i)
            ranks.doubled[order[i]] = static_cast<std::int64_t>(first + last + 2);
        if (last > first) ranks.tie_sizes.push_back(static_cast<std::int64_t>(last - first + 1));
        first = last + 1;
    }
    return ranks;
}

}  // namespace

double Midranks::tieTerm() const {
    double sum = 0.0;
    for (const std::int64_t size : tie_sizes) {
        const auto t = static_cast<double>(size);
        sum += t * t * t - t;
    }
    return sum;
}

Midranks midranks(std::span<const Rational> values) {
    const ScaledIntegers scaled = overCommonDenominator(values);
    if (scaled.rounded) return rankAll(values);
    return std::visit(
        [](const auto& numerators) { return rankAll(std::span(numerators.data(), numerators.size())); },
        scaled.numerators);
}

Midranks midranks(std::span<const double> values) {
    return rankAll(values);
}

}  // namespace deixis::results
