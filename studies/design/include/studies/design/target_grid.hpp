// A grid of test points for the objective evaluation (Deichler et al. 2023, section 3.2).
#pragma once

#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "studies/design/targets.hpp"

namespace deixis::studies {

/// The paper speaks of a uniform and of a spherical grid.
enum class GridShape : unsigned char {
    box,       ///< even along x, y and z
    spherical  ///< even in azimuth, elevation and distance from the avatar's axis, at the targets' mean
               ///< height
};

/// `count` = k^3 points, k >= 2: k evenly from the smallest to the largest x (or azimuth, from -z by +x to
/// -z) of `training`, and so for y (elevation) and z (distance), ends included; x runs fastest, then y, then
/// z. Ids "G0001", "G0002", ..., as wide as needed; positions rounded to 0.1 mm. Fails if count is no such
/// number (naming the nearest that are), or where there are no training targets.
[[nodiscard]] Result<std::vector<TargetItem>> targetGrid(const std::vector<Vec3>& training, int count,
                                                         GridShape shape = GridShape::box);

}  // namespace deixis::studies
