#include "studies/angles.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "studies/standing.hpp"
#include "studies/visibility.hpp"

namespace deixis::studies {

double angleSeen_deg(const Vec3& eye, const Vec3& a, const Vec3& b) {
    const Vec3 to_a = a - eye;
    const Vec3 to_b = b - eye;
    // Small angles lose digits by the arc cosine.
    const double angle_rad = std::atan2(glm::length(glm::cross(to_a, to_b)), glm::dot(to_a, to_b));
    return std::round(degreesFromRadians(angle_rad) * 100.0) / 100.0;
}

BallAngles ballAngles(const Study& study, const Layout& layout, const Vec3& target,
                      const std::vector<Vec3>& distractors) {
    const auto seenFromEyes = [&](const Vec3& eyes) {
        std::vector<double> out;
        std::transform(distractors.begin(), distractors.end(), std::back_inserter(out),
                       [&](const Vec3& one) { return angleSeen_deg(eyes, target, one); });
        return out;
    };
    const auto fromPlace = [&](Standing standing) {
        const ViewerPlace place = viewerPlace(layout, standing);
        return seenFromEyes({place.x_m, study.eye_height_m, place.z_m});
    };
    return {seenFromEyes(StandingAvatar::reference().eyes()), fromPlace(Standing::headset),
            fromPlace(Standing::desktop)};
}

}  // namespace deixis::studies
