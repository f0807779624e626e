// The experimenter's window beside the participant's on a desktop. Both share mouse and keyboard: while
// the experimenter uses this window the session is paused.
#pragma once

#include <memory>
#include <string>

#include "app/operator/mirror_picture.hpp"
#include "app/operator/operator_window.hpp"
#include "app/window/gl_window.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

class DesktopOperator {
  public:
    /// On another monitor, else beside the participant's window, which may be moved aside for it. Error:
    /// there is no room for it, since it must never cover what the participant sees. `participants`: its
    /// context is current, and stays so; it must outlive this. `feed`: what the session tells.
    [[nodiscard]] static Result<std::unique_ptr<DesktopOperator>> open(
        GlWindow& participants, const std::string& title, std::shared_ptr<const OperatorFeed> feed);
    ~DesktopOperator();
    DesktopOperator(const DesktopOperator&) = delete;
    DesktopOperator& operator=(const DesktopOperator&) = delete;

    /// Handles the events of both windows, and says what was asked here. To go on, the participant's window
    /// is brought to the front.
    [[nodiscard]] OperatorRequest poll();
    /// Brings the experimenter's window to the front, with the mouse and the keyboard.
    void focus();
    [[nodiscard]] bool focused() const;

    /// To be called when the participant's picture of this size has been drawn, before it is swapped.
    void drawn(WindowSize size);
    /// To be called after, in every frame; shows a picture where it is time. `in_front`: the participant's
    /// window has the mouse and the keyboard.
    void presented(const studies::PresentedFrame& frame, const studies::FrameReport& report, bool in_front);

  private:
    DesktopOperator(GlWindow& participants, std::unique_ptr<GlWindow> window,
                    std::shared_ptr<const OperatorFeed> feed);
    void measure(const studies::FrameReport& report);
    [[nodiscard]] OperatorView view(const studies::PresentedFrame& frame, bool in_front) const;

    GlWindow& participants_;
    std::shared_ptr<const OperatorFeed> feed_;
    std::unique_ptr<GlWindow> window_;
    std::unique_ptr<OperatorWindow> operator_window_;
    MirrorPicture mirror_;
    WindowSize shown_{};  // the participant's picture
    double last_shown_s_ = -1.0;
    double frames_per_s_ = 0.0;
    int dropped_ = 0;
};

}  // namespace deixis::app
