// Where a continuous function is zero.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace deixis::studies {

/// The root between two places at which the function has different signs, or is 0; to half of `tolerance`.
template <typename Function>
[[nodiscard]] double rootBetween(double low, double high, double tolerance, Function function) {
    std::uintmax_t most = 200;
    const auto [below, above] = boost::math::tools::toms748_solve(
        function, low, high, [=](double a, double b) { return b - a <= tolerance; }, most);
    return 0.5 * (below + above);
}

}  // namespace deixis::studies
