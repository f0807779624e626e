// A system at work in its own window: it points at a ball that one drags with the mouse. Or as a picture
// or a film.
#pragma once

#include "app/viewer/view_options.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "motion/synthesis/generator.hpp"

namespace deixis::app {

/// The clip for the ball's place is made again whenever the ball has moved, and played over and over; while
/// the ball is dragged, the arm is shown in the middle of its hold. G shows the simulated body's segments
/// over the avatar, as near as they come to its pose.
[[nodiscard]] Result<void> viewSystem(const motion::Generator& system, const assets::Avatar& avatar,
                                      const Vec3& target_m, const ViewOptions& options);

}  // namespace deixis::app
