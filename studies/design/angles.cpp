#include "studies/design/angles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "studies/design/visibility.hpp"

namespace deixis::studies {

double angleSeen_deg(const Vec3& eye, const Vec3& a, const Vec3& b) {
    return std::round(degreesFromRadians(angleBetween(a - eye, b - eye)) * 100.0) / 100.0;
}

BallAngles ballAngles(const Study& study, const Layout& layout, const Vec3& target,
                      const std::vector<Vec3>& distractors) {
    const auto seenFromEyes = [&](const Vec3& eyes) {
        std::vector<double> out;
        std::transform(distractors.begin(), distractors.end(), std::back_inserter(out),
                       [&](const Vec3& one) { return angleSeen_deg(eyes, target, one); });
        return out;
    };
    return {seenFromEyes(StandingAvatar::reference().eyes()),
            seenFromEyes(eyesAt(study, layout, Standing::headset)),
            seenFromEyes(eyesAt(study, layout, Standing::desktop))};
}

}  // namespace deixis::studies
