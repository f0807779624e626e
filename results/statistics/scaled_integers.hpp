// Exact fractions as whole numbers over one common denominator: their order, sums and ties are those of the
// fractions, and machine words do the work.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "big_rational.hpp"

namespace deixis::results {

struct ScaledIntegers {
    /// The narrowest that holds every sum of four of them.
    std::variant<std::vector<std::int64_t>, std::vector<Int128>, std::vector<BigInt>> numerators;
    BigInt denominator = 1;
    /// The common denominator would have been too large to work with (many different prime denominators):
    /// the numbers were first rounded to the nearest double, so their order and ties may have changed.
    bool rounded = false;
};

[[nodiscard]] ScaledIntegers overCommonDenominator(std::span<const Rational> values);

/// A numerator of whichever type, as a large one.
[[nodiscard]] inline BigInt widened(std::int64_t value) {
    return value;
}
[[nodiscard]] BigInt widened(Int128 value);
[[nodiscard]] inline BigInt widened(const BigInt& value) {
    return value;
}

}  // namespace deixis::results
