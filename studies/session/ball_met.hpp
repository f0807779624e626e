// Which ball a ray meets. A ray reaches as far as it must; only how much of it is drawn is bounded.
#pragma once

#include <limits>
#include <vector>

#include "studies/station/station.hpp"

namespace deixis::studies {

constexpr double free_ray_m = 5.0;  ///< drawn of a ray that meets nothing

struct BallMet {
    int place = -1;  ///< none
    double distance_m = std::numeric_limits<double>::infinity();
};

/// The nearest one that is met before `blocked_m`.
[[nodiscard]] inline BallMet nearestBall(const std::vector<BallView>& balls, const Ray& ray,
                                         double blocked_m = std::numeric_limits<double>::infinity()) {
    BallMet met{-1, blocked_m};
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double distance_m = distanceToSphere(ray, balls[i].centre, balls[i].radius_m);
        if (distance_m >= 0.0 && distance_m < met.distance_m) met = {static_cast<int>(i), distance_m};
    }
    return met;
}

}  // namespace deixis::studies
