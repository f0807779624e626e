#include "board_painter.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::renderer {
namespace {

// sRGB. Off-white on dark slate: in a headset dark cards glare less and light strokes stay sharp.
constexpr ImU32 card_colour = IM_COL32(0x1D, 0x27, 0x30, 255);
constexpr ImU32 card_edge = IM_COL32(0x5A, 0x6B, 0x7A, 150);
constexpr ImU32 text_colour = IM_COL32(0xF4, 0xF1, 0xEA, 255);
constexpr ImU32 faint_colour = IM_COL32(0xA9, 0xB4, 0xBC, 255);
constexpr ImU32 button_colour = IM_COL32(0x38, 0x4A, 0x59, 255);
constexpr ImU32 button_edge = IM_COL32(0x70, 0x87, 0x99, 255);
constexpr ImU32 hovered_colour = IM_COL32(0xFF, 0xD5, 0x7A, 255);
constexpr ImU32 hovered_edge = IM_COL32(0xFF, 0xEC, 0xC4, 255);
constexpr ImU32 hovered_text = IM_COL32(0x1D, 0x27, 0x30, 255);
constexpr ImU32 hovered_caption = IM_COL32(0x4C, 0x46, 0x34, 255);
constexpr ImU32 disabled_colour = IM_COL32(0x28, 0x34, 0x3E, 255);
constexpr ImU32 disabled_text = IM_COL32(0x6C, 0x79, 0x84, 255);
constexpr ImU32 progress_back = IM_COL32(0x38, 0x45, 0x50, 255);
constexpr ImU32 progress_front = IM_COL32(0x7F, 0xB8, 0xA6, 255);

constexpr double card_corner_m = 0.028;
constexpr double button_corner_m = 0.016;
constexpr double least_shrink = 0.6;  // of a text that is too long for its box
constexpr int least_pixels = 9;
constexpr int most_pixels = 240;

/// A text in pixels, y down, ready to draw.
struct Placed {
    FontKey key;
    ImVec2 low, high;
    bool centred_across = false;
    bool wrapped = false;
    const std::string* text = nullptr;
};

class Layout {
  public:
    Layout(const Board& board, double pixels_per_metre, const BoardFonts& fonts)
        : board_(board), scale_(pixels_per_metre), fonts_(fonts) {}

    [[nodiscard]] ImVec2 low(const BoardRect& box) const {
        return {pixel(box.x), pixel(board_.height_m - box.y - box.height)};
    }
    [[nodiscard]] ImVec2 high(const BoardRect& box) const {
        return {pixel(box.x + box.width), pixel(board_.height_m - box.y)};
    }
    [[nodiscard]] float pixel(double metres) const {
        return static_cast<float>(std::round(metres * scale_)) + static_cast<float>(card_margin_px);
    }
    [[nodiscard]] int fontPixels(double size_m) const {
        return std::clamp(static_cast<int>(std::lround(size_m * scale_)), least_pixels, most_pixels);
    }
    [[nodiscard]] double scale() const { return scale_; }

    [[nodiscard]] Placed text(const BoardText& text) const {
        return {{text.bold, fontPixels(text.size_m)},
                low(text.box),
                high(text.box),
                text.centred,
                true,
                &text.text};
    }
    /// A button's label and caption: the label in the middle, moved up where there is a caption under it.
    [[nodiscard]] Placed label(const BoardButton& button) const {
        const double size_m = button.caption.empty() ? std::min(0.5 * button.box.height, 0.05)
                                                     : std::min(0.42 * button.box.height, 0.05);
        return inButton(button, size_m, true, button.caption.empty() ? 0.5 : 0.40, &button.label);
    }
    [[nodiscard]] Placed caption(const BoardButton& button) const {
        return inButton(button, std::min(0.21 * button.box.height, 0.035), false, 0.77, &button.caption);
    }

    /// The font at which the text fits its box, or the smallest allowed. Measured with its own font.
    [[nodiscard]] FontKey fitted(const Placed& placed) const {
        const ImFont& font = *fonts_.font(placed.key);
        const auto fits = [&](int pixels) {
            const auto size = static_cast<float>(pixels);
            const float width = placed.high.x - placed.low.x;
            const auto lines = wrapText(font, size, *placed.text, placed.wrapped ? width : 0.0F);
            const bool wide = std::any_of(lines.begin(), lines.end(),
                                          [&](const TextLine& line) { return line.width > width + 1.0F; });
            const float height = placed.high.y - placed.low.y;
            return !wide && (!placed.wrapped || static_cast<float>(lines.size()) * size <= height + 1.0F ||
                             lines.size() == 1);
        };
        const int least = std::max(least_pixels, static_cast<int>(least_shrink * placed.key.pixels));
        int pixels = placed.key.pixels;
        while (pixels > least && !fits(pixels)) pixels = std::max(least, pixels * 15 / 16);
        return {placed.key.bold, pixels};
    }

    void draw(const Placed& placed, ImU32 colour, ImDrawList& list) const {
        const FontKey key = fitted(placed);
        const ImFont* font = fonts_.font(key);
        const auto size = static_cast<float>(key.pixels);
        const float width = placed.high.x - placed.low.x;
        const auto lines = wrapText(*font, size, *placed.text, placed.wrapped ? width : 0.0F);
        float y = placed.low.y;
        if (!placed.wrapped)
            y += 0.5F * (placed.high.y - placed.low.y - size * static_cast<float>(lines.size()));
        for (const TextLine& line : lines) {
            const float indent = placed.centred_across ? 0.5F * (width - line.width) : 0.0F;
            list.AddText(font, size, {std::round(placed.low.x + indent), std::round(y)}, colour, line.begin,
                         line.end);
            y += size;
        }
    }

  private:
    [[nodiscard]] Placed inButton(const BoardButton& button, double size_m, bool bold, double down,
                                  const std::string* text) const {
        const ImVec2 a = low(button.box);
        const ImVec2 b = high(button.box);
        const int pixels = fontPixels(size_m);
        const float middle = a.y + static_cast<float>(down) * (b.y - a.y);
        const float half = 0.5F * static_cast<float>(pixels);
        const float inset = std::min(0.06F * (b.x - a.x), static_cast<float>(0.012 * scale_));
        return {
            {bold, pixels}, {a.x + inset, middle - half}, {b.x - inset, middle + half}, true, false, text};
    }

    const Board& board_;
    double scale_;
    const BoardFonts& fonts_;
};

template <typename Visit>
void eachText(const Board& board, const Layout& layout, const Visit& visit) {
    for (const BoardText& text : board.texts) visit(layout.text(text));
    for (const BoardButton& button : board.buttons) {
        visit(layout.label(button));
        if (!button.caption.empty()) visit(layout.caption(button));
    }
}

void drawButton(const BoardButton& button, const Layout& layout, ImDrawList& list) {
    const bool lit = button.enabled && button.hovered;
    const ImVec2 a = layout.low(button.box);
    const ImVec2 b = layout.high(button.box);
    const auto corner = static_cast<float>(
        std::min(button_corner_m, 0.3 * std::min(button.box.width, button.box.height)) * layout.scale());
    const auto stroke = std::max(1.5F, static_cast<float>((lit ? 0.004 : 0.0016) * layout.scale()));
    list.AddRectFilled(a, b,
                       !button.enabled ? disabled_colour
                       : lit           ? hovered_colour
                                       : button_colour,
                       corner);
    if (button.enabled) list.AddRect(a, b, lit ? hovered_edge : button_edge, corner, 0, stroke);
    layout.draw(layout.label(button),
                !button.enabled ? disabled_text
                : lit           ? hovered_text
                                : text_colour,
                list);
    if (!button.caption.empty())
        layout.draw(layout.caption(button),
                    !button.enabled ? disabled_text
                    : lit           ? hovered_caption
                                    : faint_colour,
                    list);
}

}  // namespace

bool requireBoardFonts(const Board& board, double pixels_per_metre, BoardFonts& fonts) {
    const Layout layout(board, pixels_per_metre, fonts);
    std::set<FontKey> keys;
    std::string characters;
    eachText(board, layout, [&](const Placed& placed) {
        keys.insert(placed.key);
        characters += *placed.text;
    });
    bool built = fonts.require(keys, characters);
    std::set<FontKey> shrunk;
    eachText(board, layout, [&](const Placed& placed) { shrunk.insert(layout.fitted(placed)); });
    shrunk.insert(keys.begin(), keys.end());
    if (fonts.require(shrunk, characters)) built = true;
    return built;
}

void paintBoard(const Board& board, double pixels_per_metre, const BoardFonts& fonts, ImDrawList& list) {
    const Layout layout(board, pixels_per_metre, fonts);
    const ImVec2 low = layout.low({0.0, 0.0, board.width_m, board.height_m});
    const ImVec2 high = layout.high({0.0, 0.0, board.width_m, board.height_m});
    const auto corner = static_cast<float>(
        std::min(card_corner_m, 0.2 * std::min(board.width_m, board.height_m)) * pixels_per_metre);
    list.AddRectFilled(low, high, card_colour, corner);
    list.AddRect(low, high, card_edge, corner, 0,
                 std::max(1.5F, static_cast<float>(0.0015 * pixels_per_metre)));
    if (board.progress >= 0.0) {
        const double inset = std::min(0.04, 0.05 * board.width_m);
        BoardRect bar{inset, 0.014, board.width_m - 2.0 * inset, 0.007};
        const auto round = static_cast<float>(0.5 * bar.height * pixels_per_metre);
        list.AddRectFilled(layout.low(bar), layout.high(bar), progress_back, round);
        bar.width *= std::min(board.progress, 1.0);
        if (bar.width > bar.height)
            list.AddRectFilled(layout.low(bar), layout.high(bar), progress_front, round);
    }
    for (const BoardText& text : board.texts)
        layout.draw(layout.text(text), text.faint ? faint_colour : text_colour, list);
    for (const BoardButton& button : board.buttons) drawButton(button, layout, list);
}

}  // namespace deixis::renderer
