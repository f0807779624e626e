// Where participant and avatars stand in a layout.
#pragma once

#include <array>

#include "core/pose.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

/// The participant's place on the floor; -z is forward.
[[nodiscard]] Pose viewerPose(const Layout& layout);

/// Places of a pair of avatars, left and right as the participant sees them.
[[nodiscard]] std::array<Vec3, 2> pairPlaces(const Pose& stage_from_viewer);

}  // namespace deixis::studies
