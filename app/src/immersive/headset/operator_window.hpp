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
    std::string state;                  ///< what the session is doing
    std::string headset;                ///< "Valve Index, SteamVR 2.5, 90 Hz"
    std::string headset_state;          ///< "focused", "taken off", ...
    std::vector<std::string> warnings;  ///< one line each, calm and clear: what is wrong and what helps
    double frames_per_s = 0.0;
    int dropped_frames = 0;  ///< in the session so far
    bool head_tracked = false;
    bool left_tracked = false, right_tracked = false;
    char ray_hand = 'R';
    double off_place_m = 0.0;
    bool paused = false;
    double elapsed_s = 0.0;  ///< of the session
};

/// What the experimenter asks for.
struct OperatorRequest {
    bool pause = false;
    bool recentre = false;
    bool end = false;  ///< asked for twice, or the window was closed
};

class OperatorWindow {
  public:
    /// In `window`, whose context is current; it must outlive this.
    explicit OperatorWindow(GlWindow& window);
    ~OperatorWindow();
    OperatorWindow(const OperatorWindow&) = delete;
    OperatorWindow& operator=(const OperatorWindow&) = delete;

    /// Handles the window's events and says what was asked since the last call. Keys: R recentres, P or Esc
    /// pauses.
    [[nodiscard]] OperatorRequest poll();
    /// Whether the window can show a picture now (neither minimised nor empty).
    [[nodiscard]] bool visible() const;
    /// The part of the window that is the mirror's, from its lower left corner, pixels.
    [[nodiscard]] WindowSize mirrorSize() const;
    /// Draws the panel beside the mirror, which has been drawn already, and shows the window. Never waits for
    /// the display.
    void show(const OperatorView& view);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace deixis::app
