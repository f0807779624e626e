#include "results/statistics/shapiro_wilk.hpp"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

namespace deixis::results {

namespace {

/// c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
    double sum = 0.0;
    for (std::size_t i = N; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

/// The weights of the upper half of the ordered values, the largest first; the lower half has their
/// negatives.
std::vector<double> weights(std::size_t n) {
    if (n == 3) return {std::sqrt(0.5)};
    const std::size_t half = n / 2;
    const auto size = static_cast<double>(n);
    std::vector<double> scores(half);  // expected normal order statistics by Blom's formula
    double squares = 0.0;
    for (std::size_t i = 0; i < half; ++i) {
        const double share = (static_cast<double>(i) + 0.625) / (size + 0.25);
        scores[i] = -boost::math::quantile(boost::math::normal(), share);
        squares += 2.0 * scores[i] * scores[i];
    }
    const double root = 1.0 / std::sqrt(size);
    // Royston's polynomials for the outermost weights.
    constexpr std::array first{0.0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056};
    constexpr std::array second{0.0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633};
    const double outermost = polynomial(first, root) + scores[0] / std::sqrt(squares);
    double left_squares = squares - 2.0 * scores[0] * scores[0];
    double left = 1.0 - 2.0 * outermost * outermost;
    std::vector<double> out{outermost};
    if (n > 5) {
        const double next = polynomial(second, root) + scores[1] / std::sqrt(squares);
        left_squares -= 2.0 * scores[1] * scores[1];
        left -= 2.0 * next * next;
        out.push_back(next);
    }
    const double factor = std::sqrt(left_squares / left);
    for (std::size_t i = out.size(); i < half; ++i) out.push_back(scores[i] / factor);
    return out;
}

double pValue(double one_minus_w, std::size_t n) {
    const auto size = static_cast<double>(n);
    if (n == 3) {
        const double w = 1.0 - one_minus_w;
        const double p = 6.0 / boost::math::constants::pi<double>() *
                         (std::asin(std::sqrt(w)) - std::asin(std::sqrt(0.75)));
        return std::clamp(p, 0.0, 1.0);
    }
    if (one_minus_w <= 0.0) return 1.0;
    double y = std::log(one_minus_w);
    double centre = 0.0;
    double sd = 0.0;
    if (n <= 11) {
        const double bound = polynomial(std::array{-2.273, 0.459}, size);
        if (y >= bound) return 0.0;
        y = -std::log(bound - y);
        centre = polynomial(std::array{0.544, -0.39978, 0.025054, -6.714e-4}, size);
        sd = std::exp(polynomial(std::array{1.3822, -0.77857, 0.062767, -0.0020322}, size));
    } else {
        const double x = std::log(size);
        centre = polynomial(std::array{-1.5861, -0.31082, -0.083751, 0.0038915}, x);
        sd = std::exp(polynomial(std::array{-0.4803, -0.082676, 0.0030302}, x));
    }
    return boost::math::cdf(boost::math::complement(boost::math::normal(centre, sd), y));
}

}  // namespace

ShapiroWilk shapiroWilk(std::span<const Rational> x) {
    ShapiroWilk out;
    out.n = static_cast<int>(x.size());
    constexpr std::size_t min = 3;
    constexpr std::size_t max = 5000;
    if (x.size() < min || x.size() > max) return out;
    std::vector<Rational> sorted(x.begin(), x.end());
    std::sort(sorted.begin(), sorted.end());
    const Rational range = sorted.back() - sorted.front();
    if (range.sign() == 0) return out;
    // W does not depend on place and scale: shares of the range, computed exactly.
    std::vector<double> values;
    for (const Rational& value : sorted) values.push_back(((value - sorted.front()) / range).toDouble());
    double mean = 0.0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    const std::vector<double> a = weights(values.size());
    double weight_squares = 0.0;
    for (const double weight : a) weight_squares += 2.0 * weight * weight;
    double product = 0.0;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    for (std::size_t i = 0; i < a.size(); ++i) product += a[i] * (values[values.size() - 1 - i] - values[i]);
    // 1 - W as a product, so that no digits are lost where W is near 1.
    const double norm = std::sqrt(weight_squares * squares);
    const double one_minus_w = (norm - product) * (norm + product) / (weight_squares * squares);
    out.w = 1.0 - one_minus_w;
    out.p = pValue(one_minus_w, x.size());
    return out;
}

}  // namespace deixis::results
