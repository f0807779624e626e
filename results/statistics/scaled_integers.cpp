#include "scaled_integers.hpp"

#include <algorithm>
#include <optional>

namespace deixis::results {

namespace {

/// Of all numerators together; beyond it the work would take minutes.
constexpr std::size_t max_bits = std::size_t{1} << 27U;

/// Least common multiple; nothing where it grows beyond what `count` numbers may take.
std::optional<BigInt> commonDenominator(std::span<const Rational> values) {
    BigInt common = 1;
    std::int64_t last = 1;
    for (const Rational& value : values) {
        if (value.big() == nullptr && value.smallDenominator() == last) continue;
        const BigInt denominator = denominatorOf(value);
        if (common % denominator != 0) {
            common = boost::multiprecision::lcm(common, denominator);
            if (msb(common) * values.size() > max_bits) return std::nullopt;
        }
        last = value.big() == nullptr ? value.smallDenominator() : 1;
    }
    return common;
}

bool allBelow(const std::vector<BigInt>& values, unsigned bits) {
    const BigInt limit = BigInt(1) << bits;
    return std::all_of(values.begin(), values.end(),
                       [&](const BigInt& value) { return boost::multiprecision::abs(value) < limit; });
}

Int128 narrowed(const BigInt& value) {
    const BigInt size = boost::multiprecision::abs(value);
    const auto high = static_cast<std::uint64_t>(BigInt(size >> 64));
    const auto low = static_cast<std::uint64_t>(BigInt(size & ~std::uint64_t{0}));
    const Int128 out = (static_cast<Int128>(high) << 64) | static_cast<Int128>(low);
    return value < 0 ? -out : out;
}

/// All of them, where every denominator is small and no numerator grows beyond 61 bits.
std::optional<std::vector<std::int64_t>> smallNumerators(std::span<const Rational> values,
                                                         const BigInt& common) {
    constexpr Int128 limit = Int128{1} << 61;
    if (common >= (BigInt(1) << 61)) return std::nullopt;
    const auto denominator = static_cast<std::int64_t>(common);
    std::vector<std::int64_t> out;
    out.reserve(values.size());
    for (const Rational& value : values) {
        if (value.big() != nullptr) return std::nullopt;
        const Int128 numerator = Int128{value.smallNumerator()} * (denominator / value.smallDenominator());
        if (numerator >= limit || numerator <= -limit) return std::nullopt;
        out.push_back(static_cast<std::int64_t>(numerator));
    }
    return out;
}

}  // namespace

BigInt widened(Int128 value) {
    const Int128 size = value < 0 ? -value : value;
    BigInt out = static_cast<std::uint64_t>(size >> 64);
    out <<= 64;
    out += static_cast<std::uint64_t>(size);
    return value < 0 ? BigInt(-out) : out;
}

ScaledIntegers overCommonDenominator(std::span<const Rational> values) {
    ScaledIntegers out;
    const auto common = commonDenominator(values);
    if (!common) {
        std::vector<Rational> nearest;
        nearest.reserve(values.size());
        for (const Rational& value : values) nearest.push_back(Rational::fromBinary(value.toDouble()));
        out = overCommonDenominator(nearest);
        out.rounded = true;
        return out;
    }
    out.denominator = *common;
    if (auto small = smallNumerators(values, *common)) {
        out.numerators = std::move(*small);
        return out;
    }
    std::vector<BigInt> large;
    large.reserve(values.size());
    for (const Rational& value : values)
        large.push_back(numeratorOf(value) * (*common / denominatorOf(value)));
    if (allBelow(large, 125)) {
        std::vector<Int128> medium;
        medium.reserve(large.size());
        for (const BigInt& value : large) medium.push_back(narrowed(value));
        out.numerators = std::move(medium);
    } else {
        out.numerators = std::move(large);
    }
    return out;
}

}  // namespace deixis::results
