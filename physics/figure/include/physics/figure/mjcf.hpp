// The body as a text that MuJoCo reads (MJCF).
#pragma once

#include <string>

#include "physics/figure/figure.hpp"

namespace deixis::physics {

/// The simulation's step, and how often it gets new targets.
constexpr double step_s = 1.0 / 120.0;
constexpr int steps_per_control = 4;
constexpr double control_s = steps_per_control * step_s;

/// Metres, y up. Bodies, joints and actuators have the names of segments and hinges, in their order. Damping
/// belongs to the joints, where MuJoCo's Euler steps treat it implicitly, so that it may be stiff. A pinned
/// pelvis is a mocap body. Segments do not collide with each other; standing ones do with the floor, y = 0.
[[nodiscard]] std::string mjcf(const Figure& figure);

}  // namespace deixis::physics
