// Probabilities of the normal distribution.
#pragma once

#include <cmath>

namespace deixis {

/// Of a standard normal number below z.
[[nodiscard]] inline double normalBelow(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

}  // namespace deixis
