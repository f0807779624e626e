// The normal distribution's probabilities; private to studies.
#pragma once

#include <cmath>

namespace deixis::studies {

/// Of a standard normal number below z.
[[nodiscard]] inline double normalBelow(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

}  // namespace deixis::studies
