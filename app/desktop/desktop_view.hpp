// What the desktop's window shows of the world: where its camera looks, how wide, and where the mouse points.
// Plain geometry, without a window.
#pragma once

#include "app/window/picture_point.hpp"
#include "core/pose.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

/// A direction from the viewer's place.
struct Look {
    double yaw_rad = 0.0;  ///< from straight ahead to the left
    double pitch_rad = 0.0;
};

/// Whether the view goes back to lookAtTask() with this frame: a page or a trial begins, a pause is over, the
/// viewer is moved, or a game's board has come or gone.
[[nodiscard]] bool looksAgain(const studies::PresentedFrame& frame, const studies::PresentedFrame& before);

/// Where a person who has just been placed here would turn: to a page's middle, to between those who are
/// shown and the board of their buttons, in a game to where all balls are seen with the arm or the board.
[[nodiscard]] Look lookAtTask(const studies::PresentedFrame& frame, double eye_height_m);

/// The vertical field of view for a picture of this width by height. One that is narrower than 16:9 is wide
/// enough upwards and downwards to hold all that one of 16:9 shows.
[[nodiscard]] double verticalView_rad(const studies::PresentedFrame& frame, double aspect);

}  // namespace deixis::app
