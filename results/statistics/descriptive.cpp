#include "results/statistics/descriptive.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scaled_integers.hpp"

namespace deixis::results {

namespace {

/// The numerators' sum and sum of squares.
struct Moments {
    BigInt sum = 0;
    BigInt squares = 0;
};

Moments moments(const ScaledIntegers& scaled) {
    Moments out;
    std::visit(
        [&](const auto& numerators) {
            for (const auto& numerator : numerators) {
                const BigInt wide = widened(numerator);
                out.sum += wide;
                out.squares += wide * wide;
            }
        },
        scaled.numerators);
    return out;
}

/// Of a fraction whose square root is a double, though it may itself be too large or too small for one.
double squareRoot(const BigInt& numerator, const BigInt& denominator) {
    if (numerator == 0) return 0.0;
    const int half = (static_cast<int>(msb(numerator)) - static_cast<int>(msb(denominator))) / 2;
    const Rational near_one = half >= 0 ? ratioOf(numerator, denominator << (2 * half))
                                        : ratioOf(numerator << (-2 * half), denominator);
    return std::ldexp(std::sqrt(near_one.toDouble()), half);
}

/// Type 7 at the share `numerator / denominator`: position (n - 1) q, interpolated.
Rational quantileOf(const std::vector<Rational>& sorted, std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t position = static_cast<std::int64_t>(sorted.size() - 1) * numerator;
    const auto below = static_cast<std::size_t>(position / denominator);
    const std::int64_t rest = position % denominator;
    if (rest == 0) return sorted[below];
    return sorted[below] + Rational(rest, denominator) * (sorted[below + 1] - sorted[below]);
}

std::vector<Rational> sortedCopy(std::span<const Rational> x) {
    std::vector<Rational> sorted(x.begin(), x.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace

double mean(std::span<const double> x) {
    if (x.empty()) return 0.0;
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double sampleSd(std::span<const double> x) {
    if (x.size() < 2) return 0.0;
    const double centre = mean(x);
    double squares = 0.0;
    for (const double value : x) squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(x.size() - 1));
}

double quantile(std::vector<double> x, double q) {
    std::sort(x.begin(), x.end());
    return quantileOfSorted(x, q);
}

double quantileOfSorted(std::span<const double> x, double q) {
    if (x.empty()) return 0.0;
    const double position = q * static_cast<double>(x.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, x.size() - 1);
    return x[below] + (position - static_cast<double>(below)) * (x[above] - x[below]);
}

std::optional<BoxSummary> boxSummary(const std::vector<double>& x) {
    if (x.empty()) return std::nullopt;
    BoxSummary box{.n = static_cast<int>(x.size()),
                   .mean = mean(x),
                   .median = quantile(x, 0.5),
                   .q25 = quantile(x, 0.25),
                   .q75 = quantile(x, 0.75),
                   .q05 = quantile(x, 0.05),
                   .q95 = quantile(x, 0.95)};
    const double notch = 1.57 * (box.q75 - box.q25) / std::sqrt(static_cast<double>(x.size()));
    box.notch_low = box.median - notch;
    box.notch_high = box.median + notch;
    return box;
}

Rational exactMean(std::span<const Rational> x) {
    const ScaledIntegers scaled = overCommonDenominator(x);
    return ratioOf(moments(scaled).sum, scaled.denominator * x.size());
}

Description describe(std::span<const Rational> x) {
    Description out;
    out.n = static_cast<int>(x.size());
    if (x.empty()) return out;
    const ScaledIntegers scaled = overCommonDenominator(x);
    const auto [sum, squares] = moments(scaled);
    const BigInt n = x.size();
    out.mean = ratioOf(sum, scaled.denominator * n).toDouble();
    if (out.n > 1) {
        const BigInt spread = n * squares - sum * sum;
        const BigInt unit = scaled.denominator * scaled.denominator * n * (n - 1);
        out.sd = squareRoot(spread, unit);
        out.se = squareRoot(spread, unit * n);
    }
    const std::vector<Rational> sorted = sortedCopy(x);
    const Rational median = quantileOf(sorted, 1, 2);
    out.min = sorted.front().toDouble();
    out.q05 = quantileOf(sorted, 1, 20).toDouble();
    out.q25 = quantileOf(sorted, 1, 4).toDouble();
    out.median = median.toDouble();
    out.q75 = quantileOf(sorted, 3, 4).toDouble();
    out.q95 = quantileOf(sorted, 19, 20).toDouble();
    out.max = sorted.back().toDouble();
    std::vector<Rational> distances;
    distances.reserve(sorted.size());
    for (const Rational& value : sorted) distances.push_back(abs(value - median));
    std::sort(distances.begin(), distances.end());
    out.mad = (Rational(14826, 10000) * quantileOf(distances, 1, 2)).toDouble();
    return out;
}

}  // namespace deixis::results
