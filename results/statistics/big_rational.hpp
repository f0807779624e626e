// The large numbers behind Rational.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "results/statistics/rational.hpp"

namespace deixis::results {

using BigInt = boost::multiprecision::cpp_int;
__extension__ using Int128 = __int128;

struct Rational::Big {
    BigInt numerator;
    BigInt denominator;  ///< positive
};

[[nodiscard]] BigInt numeratorOf(const Rational& value);
[[nodiscard]] BigInt denominatorOf(const Rational& value);
/// In lowest terms; the denominator is not 0.
[[nodiscard]] Rational ratioOf(const BigInt& numerator, const BigInt& denominator);

}  // namespace deixis::results
