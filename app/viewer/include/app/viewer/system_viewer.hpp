// A system at work in its own window: it points at a ball that one drags with the mouse. Or as a picture
// or a film.
#pragma once

#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "motion/synthesis/generator.hpp"

namespace deixis::app {

struct SystemViewOptions {
    std::string size = "1280x720";
    std::string screenshot;       ///< PNG file; empty, and no film: a window
    std::string mp4_file;         ///< a film of the whole gesture
    std::vector<double> times_s;  ///< the picture's; where there is none the middle of the hold
    std::string from = "three-quarter";
    Vec3 target_m{0.5, 1.2, 1.6};
    std::uint64_t seed = 1;
};

/// The clip for the ball's place is made again whenever the ball has moved, and played over and over; while
/// the ball is dragged, the arm is shown in the middle of its hold. G shows the simulated body's segments
/// over the avatar, as near as they come to its pose.
[[nodiscard]] Result<void> viewSystem(const motion::Generator& system, const assets::Avatar& avatar,
                                      const SystemViewOptions& options);

}  // namespace deixis::app
