// A clip on the avatar in its own window: play, pause, scrub, speed, an orbiting camera. Or as a picture
// or a film.
#pragma once

#include <string>

#include "app/viewer/view_options.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::app {

/// `clip` is on the avatar's skeleton.
[[nodiscard]] Result<void> viewClip(const motion::Clip& clip, const std::string& name,
                                    const std::string& description, const assets::Avatar& avatar,
                                    const ViewOptions& options);

}  // namespace deixis::app
