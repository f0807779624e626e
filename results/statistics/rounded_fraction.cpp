#include "results/statistics/rounded_fraction.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace deixis::results {

namespace {

constexpr int min_decimals = 9;
constexpr double largest_denominator = 1000.0;

/// Digits behind the point of "12.5", "1.25e-7".
int decimalsOf(std::string_view text) {
    const auto exponent_at = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, exponent_at);
    const auto point = digits.find('.');
    int out = point == std::string_view::npos ? 0 : static_cast<int>(digits.size() - point - 1);
    if (exponent_at != std::string_view::npos) {
        int exponent = 0;
        std::string_view of = text.substr(exponent_at + 1);
        if (of.starts_with('+')) of.remove_prefix(1);
        std::from_chars(of.data(), of.data() + of.size(), exponent);
        out -= exponent;
    }
    return std::max(0, out);
}

/// Shortest decimal, as Rational::fromShortestDecimal() reads it.
std::string_view shortest(double value, std::array<char, 40>& text) {
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), static_cast<std::size_t>(end - text.data())};
}

}  // namespace

std::optional<Rational> roundedFraction(const Rational& decimal, int decimals) {
    if (decimals < min_decimals) return std::nullopt;
    // Long decimals come from floating-point arithmetic, whose last digit is off by more than a rounding.
    constexpr int of_arithmetic = 12;
    const double value = decimal.toDouble();
    const double last_digits = std::max(2.0 * std::pow(10.0, -decimals), 4e-16 * std::abs(value));
    const double off = decimals >= of_arithmetic ? last_digits : std::pow(10.0, -decimals);
    const double max = std::min(largest_denominator, std::floor(std::sqrt(1e-6 / (0.6 * off))));
    const double whole = std::floor(value);
    // Beyond that a double has not so many decimals.
    if (!(std::abs(whole) < 1e6)) return std::nullopt;
    // Convergents of the continued fraction of what stands behind the point.
    std::int64_t p = 0, q = 1, before_p = 1, before_q = 0;
    double rest = value - whole;
    for (int step = 0; step < 40; ++step) {
        const double term = std::floor(rest);
        const auto next_p = static_cast<std::int64_t>(term) * p + before_p;
        const auto next_q = static_cast<std::int64_t>(term) * q + before_q;
        if (step > 0 && static_cast<double>(next_q) > max) return std::nullopt;
        before_p = step == 0 ? 1 : p;
        before_q = step == 0 ? 0 : q;
        p = step == 0 ? static_cast<std::int64_t>(term) : next_p;
        q = step == 0 ? 1 : next_q;
        const Rational candidate = Rational(static_cast<std::int64_t>(whole)) + Rational(p, q);
        const Rational distance = abs(candidate - decimal);
        if (distance.sign() == 0) return std::nullopt;
        if (distance.toDouble() <= off * (1.0 + 1e-9)) return candidate;
        const double behind = rest - term;
        if (behind <= 0.0) return std::nullopt;
        rest = 1.0 / behind;
        if (rest > 1e9) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Rational> roundedFraction(double value) {
    if (value == std::floor(value)) return std::nullopt;
    std::array<char, 40> text{};
    const int decimals = decimalsOf(shortest(value, text));
    if (decimals < min_decimals) return std::nullopt;
    return roundedFraction(Rational::fromShortestDecimal(value), decimals);
}

Rational exactScore(double value) {
    const auto fraction = roundedFraction(value);
    return fraction ? *fraction : Rational::fromShortestDecimal(value);
}

}  // namespace deixis::results
