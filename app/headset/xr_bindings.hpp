// Which button of which controller does what.
#pragma once

#include <array>
#include <vector>

namespace deixis::app {

/// An interaction profile of the specification (OpenXR 1.0, 6.4), with its components for the program's
/// actions. All have `aim` and `grip` poses for both hands.
struct XrControllerBindings {
    const char* profile;
    const char* extension;            ///< that the profile needs; empty: none
    const char* select;               ///< below /user/hand/HAND/input/
    std::array<const char*, 2> menu;  ///< by studies::Hand; empty: no such button
    const char* recentre;             ///< empty: no button for it
    const char* farther;              ///< an axis, away from the hand above 0; empty: none
    bool haptic;
};

[[nodiscard]] const std::vector<XrControllerBindings>& controllerBindings();

}  // namespace deixis::app
