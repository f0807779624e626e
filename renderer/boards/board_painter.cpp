#include "board_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "board_layout.hpp"

namespace deixis::renderer {
namespace {

// sRGB. Off-white on dark slate: in a headset dark cards glare less and light strokes stay sharp.
constexpr ImU32 card_colour = IM_COL32(0x1D, 0x27, 0x30, 255);
constexpr ImU32 card_edge = IM_COL32(0x5A, 0x6B, 0x7A, 150);
constexpr ImU32 text_colour = IM_COL32(0xF4, 0xF1, 0xEA, 255);
constexpr ImU32 faint_colour = IM_COL32(0xA9, 0xB4, 0xBC, 255);
constexpr ImU32 dark_text = IM_COL32(0x14, 0x1C, 0x23, 255);
constexpr ImU32 dark_caption = IM_COL32(0x4C, 0x46, 0x34, 255);
constexpr ImU32 button_colour = IM_COL32(0x38, 0x4A, 0x59, 255);
constexpr ImU32 button_edge = IM_COL32(0x70, 0x87, 0x99, 255);
constexpr ImU32 go_on_colour = IM_COL32(0x7F, 0xB8, 0xA6, 255);
constexpr ImU32 go_on_edge = IM_COL32(0xA9, 0xD6, 0xC8, 255);
constexpr ImU32 chosen_colour = IM_COL32(0x2B, 0x66, 0x59, 255);
constexpr ImU32 chosen_edge = IM_COL32(0xA9, 0xE0, 0xCE, 255);
constexpr ImU32 hovered_colour = IM_COL32(0xFF, 0xD5, 0x7A, 255);
constexpr ImU32 hovered_edge = IM_COL32(0xFF, 0xEC, 0xC4, 255);
constexpr ImU32 disabled_colour = IM_COL32(0x28, 0x34, 0x3E, 255);
constexpr ImU32 disabled_text = IM_COL32(0x6C, 0x79, 0x84, 255);
constexpr ImU32 track_colour = IM_COL32(0x78, 0x90, 0xA2, 255);
constexpr ImU32 disabled_track = IM_COL32(0x45, 0x52, 0x5D, 255);
constexpr ImU32 field_colour = IM_COL32(0x11, 0x18, 0x1E, 255);
constexpr ImU32 progress_back = IM_COL32(0x38, 0x45, 0x50, 255);
constexpr ImU32 progress_front = IM_COL32(0x7F, 0xB8, 0xA6, 255);

constexpr double card_corner_m = 0.028;
constexpr double button_corner_m = 0.016;
constexpr double thumb_radius_m = 0.022;

/// The colours of a button in its present state.
struct ButtonColours {
    ImU32 fill, edge, label, caption, mark;
    double edge_m;
};

ButtonColours coloursOf(const BoardButton& button) {
    const bool filled = button.look != ButtonLook::leave;
    if (button.enabled && button.hovered)
        return {hovered_colour, hovered_edge, dark_text, dark_caption, dark_text, 0.004};
    if (button.chosen) return {chosen_colour, chosen_edge, text_colour, text_colour, chosen_edge, 0.004};
    if (!button.enabled)
        return {filled ? disabled_colour : card_colour,
                filled ? disabled_colour : disabled_text,
                disabled_text,
                disabled_text,
                disabled_text,
                0.0016};
    if (button.look == ButtonLook::go_on)
        return {go_on_colour, go_on_edge, dark_text, dark_caption, dark_text, 0.0016};
    return {filled ? button_colour : card_colour,
            button_edge,
            text_colour,
            faint_colour,
            go_on_colour,
            filled ? 0.0016 : 0.003};
}

// In the upper right corner, so that a choice is seen without its colour too.
void drawTick(const BoardButton& button, const ButtonColours& colours, const BoardLayout& layout,
              ImDrawList& list) {
    const double radius_m = std::min(0.017, 0.16 * std::min(button.box.width, button.box.height));
    const double inset_m = 1.35 * radius_m;
    const ImVec2 c =
        layout.at(button.box.x + button.box.width - inset_m, button.box.y + button.box.height - inset_m);
    const float r = layout.length(radius_m);
    list.AddCircleFilled(c, r, colours.mark, 32);
    const std::array<ImVec2, 3> tick{ImVec2(c.x - 0.45F * r, c.y + 0.05F * r),
                                     ImVec2(c.x - 0.1F * r, c.y + 0.4F * r),
                                     ImVec2(c.x + 0.5F * r, c.y - 0.35F * r)};
    list.AddPolyline(tick.data(), static_cast<int>(tick.size()), colours.fill, 0, std::max(1.5F, 0.24F * r));
}

// The triangle of a play button, beside its label.
void drawPlayMark(const BoardButton& button, const FittedText& label, ImU32 colour, const BoardLayout& layout,
                  ImDrawList& list) {
    const float room = layout.length(playMarkWidth(button));
    const float height = 0.78F * room;
    const float width = 0.86F * height;
    float left = 0.5F * (layout.low(button.box).x + layout.high(button.box).x - width);
    float middle = 0.5F * (layout.low(button.box).y + layout.high(button.box).y);
    if (!label.lines.empty()) {
        left = label.left.front() - room;
        middle = label.top + 0.52F * label.height();
    }
    list.AddTriangleFilled({left, middle - 0.5F * height}, {left + width, middle},
                           {left, middle + 0.5F * height}, colour);
}

void drawButton(const BoardButton& button, const BoardLayout& layout, ImDrawList& list) {
    const ButtonColours colours = coloursOf(button);
    const ImVec2 a = layout.low(button.box);
    const ImVec2 b = layout.high(button.box);
    const float corner =
        layout.length(std::min(button_corner_m, 0.3 * std::min(button.box.width, button.box.height)));
    list.AddRectFilled(a, b, colours.fill, corner);
    if (colours.edge != colours.fill)
        list.AddRect(a, b, colours.edge, corner, 0, layout.stroke(colours.edge_m));
    const FittedText label = layout.fittedLabel(button);
    layout.draw(label, colours.label, list);
    if (!button.caption.empty()) layout.draw(layout.fitted(layout.caption(button)), colours.caption, list);
    if (button.look == ButtonLook::play) drawPlayMark(button, label, colours.mark, layout, list);
    if (button.chosen && button.look == ButtonLook::option) drawTick(button, colours, layout, list);
}

// The track is hollow until a value is set.
void drawSlider(const BoardSlider& slider, const BoardLayout& layout, ImDrawList& list) {
    const bool lit = slider.enabled && slider.hovered;
    const ImU32 line_colour = !slider.enabled ? disabled_track : lit ? hovered_colour : track_colour;
    const BoardRect& track = slider.track;
    const double middle_m = track.y + 0.5 * track.height;
    const std::size_t ticks = std::max<std::size_t>(2, slider.labels.size());
    for (std::size_t i = 0; i < ticks; ++i) {
        const double x = track.x + track.width * static_cast<double>(i) / static_cast<double>(ticks - 1);
        const ImVec2 top = layout.at(x, middle_m + 0.5 * track.height);
        const ImVec2 foot = layout.at(x, track.y - 0.018);
        list.AddLine(top, foot, line_colour, layout.stroke(0.003));
    }
    const ImVec2 a = layout.low(track);
    const ImVec2 b = layout.high(track);
    const float round = 0.5F * (b.y - a.y);
    list.AddRectFilled(a, b, slider.value ? line_colour : field_colour, round);
    list.AddRect(a, b, line_colour, round, 0, layout.stroke(0.0024));
    for (std::size_t i = 0; i < slider.labels.size(); ++i)
        layout.draw(layout.fittedLabel(slider, i), slider.enabled ? text_colour : disabled_text, list);
    if (!slider.value) return;
    const ImVec2 at = layout.at(track.x + track.width * std::clamp(*slider.value, 0.0, 1.0), middle_m);
    const float radius = layout.length(thumb_radius_m);
    list.AddCircleFilled(at, radius + layout.stroke(0.004), card_colour, 48);
    list.AddCircleFilled(at, radius,
                         !slider.enabled ? disabled_text
                         : lit           ? hovered_colour
                                         : text_colour,
                         48);
    list.AddCircleFilled(at, 0.36F * radius, slider.enabled ? chosen_colour : disabled_colour, 32);
}

void drawField(const BoardField& field, const BoardLayout& layout, ImDrawList& list) {
    const bool lit = field.enabled && (field.hovered || field.active);
    const ImVec2 a = layout.low(field.box);
    const ImVec2 b = layout.high(field.box);
    const float corner = layout.length(std::min(button_corner_m, 0.3 * field.box.height));
    list.AddRectFilled(a, b, field.enabled ? field_colour : disabled_colour, corner);
    list.AddRect(a, b,
                 lit             ? hovered_colour
                 : field.enabled ? button_edge
                                 : disabled_text,
                 corner, 0, layout.stroke(field.active ? 0.004 : 0.002));
    const FittedText text = layout.fitted(layout.content(field));
    // What stands in a field that cannot be pressed is still to be read.
    const ImU32 colour = !field.text.empty() ? text_colour : field.enabled ? faint_colour : disabled_text;
    layout.draw(text, colour, list);
    if (!field.active) return;
    // At the end of what is typed; steady, because a board is painted only where it changes.
    const PlacedText box = layout.content(field);
    const auto line = static_cast<float>(text.key.pixels);
    ImVec2 caret(box.low.x, box.low.y);
    if (field.text.empty()) {
        caret.x -= layout.caretRoom();
    } else if (!text.lines.empty()) {
        caret.x = text.left.back() + text.lines.back().width;
        caret.y = text.top + line * static_cast<float>(text.lines.size() - 1);
    }
    const float width = layout.caretWidth();
    list.AddRectFilled({caret.x + width, caret.y + 0.08F * line},
                       {caret.x + 2.0F * width, caret.y + 0.96F * line}, hovered_edge);
}

}  // namespace

bool requireBoardFonts(const Board& board, double pixels_per_metre, BoardFonts& fonts) {
    const BoardLayout layout(board, pixels_per_metre, fonts);
    std::set<FontKey> keys;
    std::string characters;
    layout.eachText([&](const PlacedText& placed) {
        keys.insert(placed.key);
        characters += *placed.text;
    });
    bool built = fonts.require(keys, characters);
    std::set<FontKey> shrunk;
    layout.eachText([&](const PlacedText& placed) { shrunk.insert(layout.fittedFont(placed)); });
    shrunk.insert(keys.begin(), keys.end());
    if (fonts.require(shrunk, characters)) built = true;
    return built;
}

void paintBoard(const Board& board, double pixels_per_metre, const BoardFonts& fonts, ImDrawList& list) {
    const BoardLayout layout(board, pixels_per_metre, fonts);
    const ImVec2 low = layout.low({0.0, 0.0, board.width_m, board.height_m});
    const ImVec2 high = layout.high({0.0, 0.0, board.width_m, board.height_m});
    const float corner =
        layout.length(std::min(card_corner_m, 0.2 * std::min(board.width_m, board.height_m)));
    list.AddRectFilled(low, high, card_colour, corner);
    list.AddRect(low, high, card_edge, corner, 0, layout.stroke(0.0015));
    if (board.progress >= 0.0) {
        const double inset = std::min(0.04, 0.05 * board.width_m);
        BoardRect bar{inset, 0.014, board.width_m - 2.0 * inset, 0.007};
        const float round = layout.length(0.5 * bar.height);
        list.AddRectFilled(layout.low(bar), layout.high(bar), progress_back, round);
        bar.width *= std::min(board.progress, 1.0);
        if (bar.width > bar.height)
            list.AddRectFilled(layout.low(bar), layout.high(bar), progress_front, round);
    }
    for (const BoardText& text : board.texts)
        layout.draw(layout.fittedText(text), text.faint ? faint_colour : text_colour, list);
    for (const BoardField& field : board.fields) drawField(field, layout, list);
    for (const BoardSlider& slider : board.sliders) drawSlider(slider, layout, list);
    for (const BoardButton& button : board.buttons) drawButton(button, layout, list);
}

}  // namespace deixis::renderer
