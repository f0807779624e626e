// The frame that a session presents: the viewer's place, the panel, the balls and what the ray meets on them.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "panel_layout.hpp"
#include "studies/station.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

/// What a ray meets first: the id of a button, a slider or a field (0: none), or the place of a ball (-1:
/// none).
struct Aim {
    int button = 0;
    int slider = 0;
    int field = 0;
    int ball = -1;
    bool operator==(const Aim&) const = default;
};

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
    void openPanel(Panel panel, double eye_height_m, PanelPlace stand);
    /// The same panel with other contents: it stays where it is, and what the ray meets or drags.
    void updatePanel(Panel panel);
    void closePanel();  ///< and the ray
    void showSign(const std::string& sentence, const std::string& large, const Vec3& avatar_head,
                  const Vec3& eyes);
    void closeSign();
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
    int grabbed_ = 0;   ///< the slider that is dragged; 0: none
    double eye_height_m_ = 0.0;
    PanelPlace stand_{};

    void lightUp(const Aim& met);
};

}  // namespace deixis::studies
