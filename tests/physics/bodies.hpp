// What the tests of the body start from.
#pragma once

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "physics/figure/figure.hpp"
#include "physics/figure/figure_pose.hpp"

namespace deixis::tests {

template <typename T>
T valueOf(Result<T> result) {
    REQUIRE_MESSAGE(result.has_value(), (result ? "" : result.error().text()));
    return std::move(*result);
}

inline physics::Figure figureOf(physics::Stance stance) {
    return valueOf(physics::makeFigure(motion::referenceHumanoid(), stance));
}

/// Of the library, left-handed ones first; synthetic.
inline const std::vector<motion::Demonstration>& demonstrations() {
    static const auto all =
        valueOf(motion::makeDemonstrations(motion::referenceHumanoid(), motion::DemonstrationParameters{}));
    return all;
}

/// Angles within `share` of the limits.
inline std::vector<double> drawAngles(const physics::Figure& figure, Random& random, double share = 0.98) {
    std::vector<double> angles;
    for (const physics::Hinge& hinge : figure.hinges)
        angles.push_back(share * random.uniform(hinge.min_rad, hinge.max_rad));
    return angles;
}

}  // namespace deixis::tests
