// Keys pressed in a window since the last query: a press shorter than a frame counts, too.
#pragma once

#include <utility>
#include <vector>

struct GLFWwindow;

namespace deixis::app {

class PressedKeys {
  public:
    PressedKeys() = default;
    PressedKeys(const PressedKeys&) = delete;
    PressedKeys& operator=(const PressedKeys&) = delete;

    /// Before the window's WindowGui is made, which passes on to what stands there. Must outlive the window,
    /// whose user pointer it takes.
    void connect(GLFWwindow* window);
    /// In their order, one for each press; of an arrow that is held, again and again.
    [[nodiscard]] std::vector<int> take() { return std::exchange(keys_, {}); }

  private:
    std::vector<int> keys_;
};

}  // namespace deixis::app
