// A clip on the avatar in its own window: play, pause, scrub, speed, an orbiting camera. Or as a picture
// or a film.
#pragma once

#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::app {

struct ViewOptions {
    std::string size = "1280x720";
    std::string screenshot;       ///< PNG file; empty, and no film: a window
    std::string mp4_file;         ///< a film of the whole clip
    std::vector<double> times_s;  ///< pictured side by side; the window starts at the first
    std::string from = "three-quarter";
};

/// `clip` is on the avatar's skeleton.
[[nodiscard]] Result<void> viewClip(const motion::Clip& clip, const std::string& name,
                                    const std::string& description, const assets::Avatar& avatar,
                                    const ViewOptions& options);

}  // namespace deixis::app
