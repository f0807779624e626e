// Where the operator's window goes on the monitors: plain logic.
#pragma once

#include <optional>
#include <vector>

#include "app/window/gl_window.hpp"

namespace deixis::app {

/// On the virtual screen, x to the right and y down.
struct ScreenRect {
    int x = 0, y = 0, width = 0, height = 0;
};

/// In screen units, frames included.
struct PlacesOfWindows {
    ScreenRect participant;  ///< moved aside where that makes the room
    ScreenRect operators;
};

/// Never over the participant's window. On another monitor where there is one (not one that shows the same as
/// the participant's); else beside the participant's window, which is moved to the side of its monitor
/// where that is needed, unless it fills it by intent (`may_move` false). None where there is not even room
/// for `min`. `monitors`: the parts of them that windows may take.
[[nodiscard]] std::optional<PlacesOfWindows> placesOfWindows(const ScreenRect& participant,
                                                             const std::vector<ScreenRect>& monitors,
                                                             WindowSize wanted, WindowSize min,
                                                             bool may_move);

}  // namespace deixis::app
