// Lines of text, bars and lights of the operator's panel, drawn with Dear ImGui one under the other.
#pragma once

#include <string>
#include <string_view>

#include "app/window/window_gui.hpp"

namespace deixis::app {

/// Writes between WindowGui::beginFrame() and endFrame(), where ImGui's cursor stands. Lengths handed over
/// are in units of WindowGui::scale(); those that come back are pixels.
class PanelPen {
  public:
    static constexpr float line_gap = 5.0F;
    static constexpr float section_gap = 12.0F;

    /// `width`: of what is written, pixels.
    PanelPen(const WindowGui& gui, float width) : gui_(gui), width_(width) {}

    [[nodiscard]] const WindowGui& gui() const { return gui_; }
    [[nodiscard]] float width() const { return width_; }
    [[nodiscard]] float px(float length) const { return length * gui_.scale(); }
    [[nodiscard]] static float widthOf(ImFont* font, std::string_view text);
    /// The text, or as much of its beginning as fits this many pixels, with an ellipsis.
    [[nodiscard]] static std::string fitted(ImFont* font, std::string_view text, float across);

    /// On one line.
    static void line(ImFont* font, ImU32 colour, std::string_view text);
    /// On as many lines as it needs.
    void write(ImFont* font, ImU32 colour, std::string_view text) const;
    /// Against the right edge of the line last written, or on a line of its own where that is too full.
    void right(ImFont* font, ImU32 colour, std::string_view text, float left_width) const;
    /// A line with a name at its left and a value at its right.
    void row(std::string_view name, ImFont* font, ImU32 colour, std::string_view value) const;
    void gap(float height) const;
    /// A line across, and a title under it.
    void section(std::string_view title) const;
    void bar(double share, float height, ImU32 colour) const;
    /// A bar at this place of the screen, this many pixels long.
    void barAt(ImVec2 at, float across, double share, float height, ImU32 colour) const;
    /// A disc where it is lit, a ring where not: colour alone does not tell it. The line goes on behind it.
    void light(bool lit, ImU32 colour) const;
    /// Set off by a stroke at its left.
    void warning(std::string_view text) const;
    /// Within a field of this size at the cursor, in the middle of its height.
    void hint(std::string_view text, float across, float height) const;
    /// Over the item drawn last, `top` pixels down the window.
    static void centredOver(ImFont* font, std::string_view text, float top);

  private:
    const WindowGui& gui_;
    float width_;
};

}  // namespace deixis::app
