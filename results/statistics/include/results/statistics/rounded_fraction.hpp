// Decimals that are rounded fractions: a mean of three ratings that another program wrote as
// 7.333333333333334.
#pragma once

#include <optional>

#include "results/statistics/rational.hpp"

namespace deixis::results {

/// The fraction with a small denominator that a decimal with nine and more decimals was rounded from, as
/// 22/3; its digits agree with the fraction's but for the last one. None of other decimals, nor where the
/// decimal is such a fraction itself (0.5). Denominators go up to 1,000, fewer for fewer decimals, so that of
/// a million decimals drawn at random one is taken for a fraction. `decimals`: how many digits stand behind
/// the point.
[[nodiscard]] std::optional<Rational> roundedFraction(const Rational& decimal, int decimals);

/// Of the shortest decimal that reads back as `value`, which is finite.
[[nodiscard]] std::optional<Rational> roundedFraction(double value);

/// The fraction that a score was rounded from, or else its shortest decimal.
[[nodiscard]] Rational exactScore(double value);

}  // namespace deixis::results
