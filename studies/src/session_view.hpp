// The frame that a session presents: the viewer's place, the panel, the balls and what the ray meets on them.
#pragma once

#include <optional>
#include <string_view>

#include "panel_layout.hpp"
#include "studies/station.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

/// What a ray meets first: the id of a button (0: none) or the place of a ball (-1: none).
struct Aim {
    int button = 0;
    int ball = -1;
    bool operator==(const Aim&) const = default;
};

/// Where a panel stands, from panel_layout.hpp.
using PanelPlace = Pose (*)(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Each change that a participant must see makes the frame a key moment.
class SessionView {
  public:
    PresentedFrame frame;

    void beginFrame();
    /// Moves the viewer; false where the participant stands there already.
    bool place(const Layout& layout);
    void openPanel(Panel panel, double eye_height_m, PanelPlace stand);
    void closePanel();  ///< and the ray
    void lookAtBalls(BallLook all, int place = -1, BallLook one = BallLook::waiting);
    /// Shows the ray up to what it meets and lights that up, with a tick where it was not met in the frame
    /// before. Balls are met only `at_balls`; what the participant cannot see, because the head is turned
    /// away, is not met.
    Aim aim(const std::optional<Ray>& pointer, const Pose& stage_from_head, bool at_balls);
    /// Takes no more input, and keeps one button lit (0: none).
    void confirmButton(int id);
    void notice(std::string_view sentence);  ///< empty: none

  private:
    Aim met_{};         ///< in this frame
    Aim met_before_{};  ///< in the one before
};

}  // namespace deixis::studies
