// Which coordinate axis is up for a figure.
#pragma once

#include <optional>
#include <vector>

#include "core/pose.hpp"

namespace deixis::motion {

/// The axis, of either sign, that lies nearest to the mean direction in which a figure rises from its hips or
/// feet, frame by frame, and at most 45 degrees from it; none if there is no such axis. Rises without
/// length do not count.
[[nodiscard]] std::optional<Vec3> riseAxis(const std::vector<Vec3>& rises);

}  // namespace deixis::motion
