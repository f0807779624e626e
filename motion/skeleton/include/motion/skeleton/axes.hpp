// The unit vectors along the axes.
#pragma once

#include "core/pose.hpp"

namespace deixis::motion {

inline const Vec3 x_axis{1.0, 0.0, 0.0};
inline const Vec3 y_axis{0.0, 1.0, 0.0};
inline const Vec3 z_axis{0.0, 0.0, 1.0};

}  // namespace deixis::motion
