// Dear ImGui in a GLFW window: text and buttons that look like the boards.
#pragma once

#include <imgui/imgui.h>

#include <set>
#include <string_view>

struct GLFWwindow;

namespace deixis::app {

/// sRGB, as on the boards.
namespace look {
constexpr ImU32 background = IM_COL32(0x16, 0x1E, 0x25, 255);
constexpr ImU32 card = IM_COL32(0x1D, 0x27, 0x30, 255);
constexpr ImU32 edge = IM_COL32(0x38, 0x45, 0x50, 255);
constexpr ImU32 text = IM_COL32(0xF4, 0xF1, 0xEA, 255);
constexpr ImU32 faint = IM_COL32(0xA9, 0xB4, 0xBC, 255);
constexpr ImU32 button = IM_COL32(0x38, 0x4A, 0x59, 255);
constexpr ImU32 button_hovered = IM_COL32(0x48, 0x5D, 0x6F, 255);
constexpr ImU32 button_held = IM_COL32(0x2F, 0x3F, 0x4C, 255);
constexpr ImU32 good = IM_COL32(0x7F, 0xB8, 0xA6, 255);
constexpr ImU32 warning = IM_COL32(0xFF, 0xD5, 0x7A, 255);
constexpr ImU32 danger = IM_COL32(0xB4, 0x4A, 0x3C, 255);
constexpr ImU32 danger_hovered = IM_COL32(0xC6, 0x58, 0x48, 255);
constexpr ImU32 ray = IM_COL32(0xFF, 0x76, 0x5F, 255);
}  // namespace look

/// A text library's context of its own, with the window's events and OpenGL. Sizes and style follow the
/// content scale of the monitor that shows the window.
class WindowGui {
  public:
    /// The window's GL context must be current; GLFW callbacks set before are still called. `window` must
    /// outlive this.
    explicit WindowGui(GLFWwindow* window);
    ~WindowGui();
    WindowGui(const WindowGui&) = delete;
    WindowGui& operator=(const WindowGui&) = delete;

    /// To be called before the window's events are handled where other contexts are about.
    void makeCurrent() const;
    void beginFrame();
    /// Makes the letters of this text (UTF-8) be there from the next frame on. Latin ones are.
    void require(std::string_view text);
    /// Draws into the bound framebuffer; leaves GL state as it was.
    void endFrame();

    /// Pixels per unit of length: 1 on a plain monitor.
    [[nodiscard]] float scale() const { return scale_; }
    [[nodiscard]] ImFont* small() const { return small_; }
    [[nodiscard]] ImFont* regular() const { return regular_; }  ///< the one in use where none is pushed
    [[nodiscard]] ImFont* bold() const { return bold_; }
    [[nodiscard]] ImFont* large() const { return large_; }

  private:
    void setUp(float scale);

    GLFWwindow* window_;
    ImGuiContext* context_;
    float scale_ = 0.0F;
    std::set<ImWchar> letters_;  // beyond Latin
    bool has_letters_ = true;    // all of them
    ImFont* small_ = nullptr;
    ImFont* regular_ = nullptr;
    ImFont* bold_ = nullptr;
    ImFont* large_ = nullptr;
};

}  // namespace deixis::app
