// The experimenter's window while a participant wears the headset: what the left eye sees, and a panel.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../gl_window.hpp"

namespace deixis::app {

/// What the panel tells.
struct OperatorView {
    std::string participant;
    std::string status;                 ///< "game 12/40"
    std::string state;                  ///< PresentedFrame::state
    std::string headset;                ///< "Valve Index, SteamVR 2.5, 90 Hz"
    std::string headset_state;          ///< an OpenXR session state, or other words: "taken off", ...
    std::vector<std::string> warnings;  ///< one line each, calm and clear: what is wrong and what helps
    double frames_per_s = 0.0;
    int dropped_frames = 0;  ///< in the session so far
    bool head_tracked = false;
    bool left_tracked = false, right_tracked = false;
    char ray_hand = 'R';
    double off_place_m = 0.0;
    double place_tolerance_m = 0.30;  ///< from here on the distance is marked
    bool paused = false;
    double elapsed_s = 0.0;  ///< of the session
};

/// What the experimenter asks for.
struct OperatorRequest {
    bool pause = false;
    bool recentre = false;
    bool end = false;  ///< asked for twice within 4 s, on the button or by closing the window
};

/// Runs inside the headset's frame loop: call poll() in every frame and, where due() says so, draw the mirror
/// and call show(). One pixel of the window system is one of the framebuffer (X11, Windows).
class OperatorWindow {
  public:
    /// In `window`, whose context is current; it must outlive this. From here on the window does not wait for
    /// the display.
    explicit OperatorWindow(GlWindow& window);
    ~OperatorWindow();
    OperatorWindow(const OperatorWindow&) = delete;
    OperatorWindow& operator=(const OperatorWindow&) = delete;

    /// Handles the window's events and says what was asked since the last call. Keys: R recentres, P or Esc
    /// pauses.
    [[nodiscard]] OperatorRequest poll();
    /// Whether the window can show a picture now (neither minimised nor empty).
    [[nodiscard]] bool visible() const;
    /// Whether it is time for a new picture: visible, and the last one is about 1/30 s old.
    [[nodiscard]] bool due() const;
    /// The part of the window that is the mirror's, from its lower left corner, pixels; at least 1x1.
    [[nodiscard]] WindowSize mirrorSize() const;
    /// Draws the panel beside the mirror, which has been drawn already into framebuffer 0, and shows the
    /// window. Never waits for the display. Leaves framebuffer 0 bound, with sRGB conversion off.
    void show(const OperatorView& view);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace deixis::app
