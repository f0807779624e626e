#include "desktop_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::app {

namespace {

using studies::PresentedFrame;
using studies::PresentedState;

constexpr double resting_pitch_rad =
    radiansFromDegrees(-6.0);  // a standing person's gaze rests a little down
constexpr double wide_picture = 16.0 / 9.0;

// Whether a board stands there to be read first, not one beside a task.
bool pageOpen(const PresentedFrame& frame) {
    return frame.panel && isFullPage(frame.state);
}

// Whether clips are to be played by buttons: the board and who is shown belong together.
bool playsByButtons(const PresentedFrame& frame) {
    return frame.panel &&
           (frame.state == PresentedState::watching || frame.state == PresentedState::comparing);
}

bool beginsTrial(const PresentedFrame& frame, const PresentedFrame& before) {
    if (frame.state == PresentedState::waiting && !frame.panel)
        return before.state != PresentedState::waiting;
    return playsByButtons(frame) && before.state == PresentedState::rated;
}

// Whether a game's board has come or gone.
bool showsOtherThings(const PresentedFrame& frame, const PresentedFrame& before) {
    return frame.first_look && frame.first_look != before.first_look;
}

Vec3 middleOf(const studies::Panel& panel) {
    return transformPoint(panel.stage_from_panel, {0.5 * panel.width_m, 0.5 * panel.height_m, 0.0});
}

}  // namespace

bool looksAgain(const PresentedFrame& frame, const PresentedFrame& before) {
    if (frame.state == PresentedState::rated) return false;  // a page of reasons, for a moment still
    const bool another_page = frame.state != before.state || frame.stage != before.stage;
    return frame.viewer_place != before.viewer_place || pageOpen(frame) != pageOpen(before) ||
           (pageOpen(frame) && another_page) || beginsTrial(frame, before) || showsOtherThings(frame, before);
}

Look lookAtTask(const PresentedFrame& frame, double eye_height_m) {
    Look look{0.0, resting_pitch_rad};
    if (frame.first_look && !pageOpen(frame)) return {frame.first_look->yaw_rad, frame.first_look->pitch_rad};
    if (!frame.panel) return look;
    const Vec3 board = transformPoint(inverse(frame.stage_from_viewer), middleOf(*frame.panel));
    const double pitch_rad = std::atan2(board.y - eye_height_m, std::hypot(board.x, board.z));
    look.yaw_rad = std::atan2(-board.x, -board.z);
    if (pageOpen(frame)) look.pitch_rad = pitch_rad;
    if (playsByButtons(frame)) look.pitch_rad = 0.5 * (resting_pitch_rad + pitch_rad);
    return look;
}

double verticalView_rad(const PresentedFrame& frame, double aspect) {
    const double wide_rad =
        frame.first_look ? frame.first_look->verticalView_rad(wide_picture) : studies::min_view_rad;
    return 2.0 * std::atan(std::tan(0.5 * wide_rad) * std::max(1.0, wide_picture / aspect));
}

}  // namespace deixis::app
