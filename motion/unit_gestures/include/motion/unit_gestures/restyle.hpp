// Style of a motion that is there already, for systems that take none themselves: its arms' movement is made
// larger or smaller, and wider, as in the post-processing of Hartmann, Mancini & Pelachaud (2005), which Yoon
// et al. (2021, section 2.3) cite. The times stay, so that gestures stay with their words.
#pragma once

#include <optional>
#include <vector>

#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

/// As StyleControl of the trained model: from -3 to 3, what is not set is left as it is, and so is 0.
struct WantedStyle {
    /// Faster: the arms go farther from where they hang in the same time, 1.8 times at 3, 0.55 times at -3.
    std::optional<double> speed{};
    /// Wider: upper arms and forearms turn outwards, by 24 degrees at 3, inwards at -3.
    std::optional<double> space{};
    /// Equation 6's sign: above 0 the left hand moves more than the right one, below 0 the right one.
    std::optional<double> handedness{};
};

/// `styles` has one a frame. What changes from frame to frame comes in within half a second.
[[nodiscard]] UpperBodyMotion restyled(const UpperBodyMotion& motion, const std::vector<WantedStyle>& styles);

}  // namespace deixis::motion
