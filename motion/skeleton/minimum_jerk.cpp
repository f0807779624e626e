#include "motion/skeleton/minimum_jerk.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::motion {

double minimumJerk(double u) {
    const double t = std::clamp(u, 0.0, 1.0);
    return t * t * t * (10.0 + t * (-15.0 + t * 6.0));
}

double minimumJerkLeaving(double u) {
    return u + u * u * u * (-6.0 + u * (8.0 - 3.0 * u));
}

double minimumJerkArriving(double u) {
    return u * u * u * (-4.0 + u * (7.0 - 3.0 * u));
}

double warpedMinimumJerk(double u, double exponent) {
    return minimumJerk(std::pow(std::clamp(u, 0.0, 1.0), exponent));
}

}  // namespace deixis::motion
