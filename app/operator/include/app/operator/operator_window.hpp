// The experimenter's window: what the participant sees, and a panel beside it.
#pragma once

#include <memory>

#include "app/operator/mirror_picture.hpp"
#include "app/operator/operator_request.hpp"
#include "app/operator/operator_view.hpp"
#include "app/window/gl_window.hpp"

namespace deixis::app {

/// Runs inside the station's frame loop: call poll() in every frame and show() where due() says so. One pixel
/// of the window system is one of the framebuffer (X11, Windows). Where another context is current, show()
/// leaves it current.
class OperatorWindow {
  public:
    /// In `window`, whose context is current; it must outlive this. From here on the window does not wait for
    /// the display.
    explicit OperatorWindow(GlWindow& window);
    ~OperatorWindow();
    OperatorWindow(const OperatorWindow&) = delete;
    OperatorWindow& operator=(const OperatorWindow&) = delete;

    /// Handles the events of all windows, and says what was asked here since the last call. Keys, unless a
    /// text is typed: P pauses and goes on, Esc pauses, R recentres.
    [[nodiscard]] OperatorRequest poll();
    /// Whether the window can show a picture now (neither minimised nor empty).
    [[nodiscard]] bool visible() const;
    /// Whether it is time for a new picture: visible, and the last one is 1/15 s old; later where pictures
    /// take long, which may have a tenth of the time, and every 1/30 s while the panel is used.
    [[nodiscard]] bool due() const;
    /// The part of the window that is the mirror's, from its lower left corner, pixels; at least 1x1.
    [[nodiscard]] WindowSize mirrorSize() const;
    /// Draws the panel beside the mirror, which has been drawn already into framebuffer 0 of the window's
    /// context, and shows the window. Never waits for the display. Leaves that framebuffer bound, with sRGB
    /// conversion off.
    void show(const OperatorView& view);
    /// Draws both: the mirror, of a context that shares its textures, as large as it fits.
    void show(const OperatorView& view, const MirrorPicture& mirror);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Makes a window's context current, and the one before again when it goes.
class CurrentContext {
  public:
    explicit CurrentContext(GLFWwindow* window);
    ~CurrentContext();
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

  private:
    GLFWwindow* before_;
    bool changed_;
};

}  // namespace deixis::app
