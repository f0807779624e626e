// Style controls of an upper body's motion: Yoon et al. (2021), equations 4 to 6.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/gestures/gesture_style.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

/// Style at every frame (stride 1) of all ten joints, with the mean bone lengths, before normalisation
/// (normalisedStyle()). As gestureStyle(): fails with fewer than 2 frames.
[[nodiscard]] Result<std::vector<Style>> styleOf(const UpperBodyMotion& motion, int window = style_window);

}  // namespace deixis::motion
