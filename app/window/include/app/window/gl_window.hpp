// A GLFW window with an OpenGL 4.5 core context.
#pragma once

#include <memory>
#include <string>

#include "core/error.hpp"

struct GLFWwindow;

namespace deixis::app {

struct WindowSize {
    int width = 1280;
    int height = 720;
};

/// "1280x720" -> size; each side 64..8192 pixels.
[[nodiscard]] Result<WindowSize> parseWindowSize(const std::string& text);

/// Owns GLFW and one window, its context current on the calling thread. At most one at a time, and one more
/// beside it.
class GlWindow {
  public:
    /// Fails, in the words of the window system, without a display or without OpenGL 4.5.
    [[nodiscard]] static Result<std::unique_ptr<GlWindow>> open(const std::string& title, WindowSize size,
                                                                bool fullscreen);
    /// A second window, whose context shares the textures of the first and does not become current. It is not
    /// shown yet, never takes the keyboard by being shown, and must go before the first.
    [[nodiscard]] static Result<std::unique_ptr<GlWindow>> openSecond(const GlWindow& first,
                                                                      const std::string& title,
                                                                      WindowSize size);
    ~GlWindow();
    GlWindow(const GlWindow&) = delete;
    GlWindow& operator=(const GlWindow&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    [[nodiscard]] WindowSize framebufferSize() const;
    [[nodiscard]] double refreshRate_hz() const;  ///< of the monitor that shows it; 60 where unknown

  private:
    GlWindow(GLFWwindow* window, bool owns_glfw) : window_(window), owns_glfw_(owns_glfw) {}
    GLFWwindow* window_;
    bool owns_glfw_;
};

}  // namespace deixis::app
