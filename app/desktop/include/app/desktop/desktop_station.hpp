// The desktop station, mock-VR: a window with a first-person camera at standing eye height.
//
// Mouse: the ray goes from the eye through the cursor. Left button: select; held, it drags a slider. Right
// button held: the mouse turns the view, which goes back to the task with each page and trial. 1-9: rate.
// Enter or Space: continue. W A S D or arrows: lean up to 25 cm. Esc: pause. F11: full screen on and off.
// F10: to the experimenter's window, if there is one. While a text field receives input, letters, digits
// and the space are only text.
#pragma once

#include <memory>
#include <string>

#include "app/session/operator_feed.hpp"
#include "app/window/gl_window.hpp"
#include "assets/avatar/avatar.hpp"
#include "renderer/drawing/renderer.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

struct DesktopOptions {
    std::string title;
    WindowSize size{};
    bool fullscreen = false;
    double eye_height_m = 1.65;
    /// How to take part, one line in the participant's language: at the foot of the first pages and of the
    /// pause.
    std::string controls =
        "Mouse: point.  Left button: select.  Hold the right button: look around.  Enter: continue.  "
        "1-9: rate.  Esc: pause.";
    bool operator_window = false;                         ///< one for the experimenter too
    std::shared_ptr<const OperatorFeed> operator_feed{};  ///< what the session tells there
};

class DesktopStation : public studies::Station {
  public:
    [[nodiscard]] static Result<std::unique_ptr<DesktopStation>> open(const assets::Avatar& avatar,
                                                                      const DesktopOptions& options);
    ~DesktopStation() override;

    [[nodiscard]] studies::StationInfo info() const override;
    [[nodiscard]] studies::InputFrame beginFrame() override;
    studies::FrameReport present(const studies::PresentedFrame& frame) override;

  private:
    struct State;
    explicit DesktopStation(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace deixis::app
