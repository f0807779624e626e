// The frame that a session presents: the viewer's place, the panel, the balls and what the ray meets on them.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "aim.hpp"
#include "studies/boards/panel_layout.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// A slider is at this value now.
struct SliderSet {
    int id = 0;
    int value = 0;
};

/// Where a panel stands, from panel_layout.hpp.
using PanelPlace =
    std::function<Pose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m)>;

/// Each change that a participant must see makes the frame a key moment.
class SessionView {
  public:
    PresentedFrame frame;

    void beginFrame();
    void show(PresentedState state, bool in_game = false);
    /// Moves the viewer; false where the participant stands there already.
    bool place(const Layout& layout);
    /// What the ray rests on as it opens is not met until the ray has moved.
    void openPanel(Panel panel, double eye_height_m, PanelPlace stand);
    /// The same panel with other contents: it stays where it is, and what the ray meets or drags.
    void updatePanel(Panel panel);
    void closePanel();  ///< and the ray
    void showSign(const std::string& sentence, const std::string& large, const Vec3& avatar_head,
                  const Vec3& eyes);
    void closeSign();
    /// The balls can be chosen from now on; likewise.
    void openBalls() { onset_.open(); }
    /// Lets the ray meet at once what it rests on: a board from which there is no answer to be had.
    void admitRestingRay() { onset_.release(); }
    void lookAtBalls(BallLook all, int place = -1, BallLook one = BallLook::waiting);
    /// Shows the ray up to what it meets and lights that up, with a tick where it was not met in the frame
    /// before. Balls are met only `at_balls`; what the participant cannot see, because the head is turned
    /// away, is not met.
    Aim aim(const std::optional<Ray>& pointer, const Pose& stage_from_head, bool at_balls);
    /// A slider that was pressed on follows the ray while select is held; `pressed`: select counts in this
    /// frame. None where no slider is set.
    std::optional<SliderSet> drag(const InputFrame& input, const Aim& met, bool pressed);
    /// Takes no more input, and keeps one button lit (0: none).
    void confirmButton(int id);
    void notice(std::string_view sentence);  ///< empty: none

  private:
    Aim met_{};         ///< in this frame
    Aim met_before_{};  ///< in the one before
    OnsetGuard onset_{};
    int grabbed_ = 0;  ///< the slider that is dragged; 0: none
    double eye_height_m_ = 0.0;
    PanelPlace stand_{};

    void lightUp(const Aim& met);
};

}  // namespace deixis::studies
