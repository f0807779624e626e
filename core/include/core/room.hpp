// The room in which the avatar and the participant stand.
#pragma once

#include "core/pose.hpp"

namespace deixis {

/// Its corners, metres: a floor of 8 x 9 m around the avatar and the people who look at it.
constexpr Vec3 room_low{-4.0, 0.0, -3.5};
constexpr Vec3 room_high{4.0, 3.0, 5.5};

}  // namespace deixis
