#include "board_layout.hpp"

#include <algorithm>
#include <cmath>

#include "board_painter.hpp"

namespace deixis::renderer {
namespace {

constexpr double min_shrink = 0.6;             // of a text that is too long for its box
constexpr double min_shrink_for_words = 0.75;  // of one that has a word too long for its line
constexpr int min_pixels = 9;
constexpr int max_pixels = 240;
constexpr double field_inset_m = 0.018;
constexpr double field_line_m = 0.046;
constexpr double slider_label_drop_m = 0.028;  // under the track: its ticks, and the thumb

float widthOf(const PlacedText& placed) {
    return placed.high.x - placed.low.x;
}

// How many lines a field shows.
std::size_t fieldLines(const PlacedText& placed) {
    const float lines = (placed.high.y - placed.low.y) / static_cast<float>(placed.key.pixels);
    return static_cast<std::size_t>(std::max(1.0F, std::floor(lines + 0.01F)));
}

// The line's end, as long as fits.
TextLine endOf(TextLine line, const ImFont& font, float pixels, float width) {
    while (line.width > width && line.begin < line.end) {
        line.begin = afterCharacter(line.begin, line.end);
        line.width = textWidth(font, pixels, line.begin, line.end);
    }
    return line;
}

}  // namespace

double playMarkWidth(const BoardButton& button) {
    return button.look == ButtonLook::play ? std::min(0.036, 0.3 * button.box.height) : 0.0;
}

ImVec2 BoardLayout::at(double x, double y) const {
    const auto pixel = [&](double metres) {
        return static_cast<float>(std::round(metres * scale_)) + static_cast<float>(card_margin_px);
    };
    return {pixel(x), pixel(board_.height_m - y)};
}

float BoardLayout::stroke(double metres) const {
    return std::max(1.5F, length(metres));
}

int BoardLayout::fontPixels(double size_m) const {
    // No larger than laid out: the lines are as wide as their boxes.
    constexpr double rounding = 1e-6;
    return std::clamp(static_cast<int>(std::floor(size_m * scale_ + rounding)), min_pixels, max_pixels);
}

PlacedText BoardLayout::text(const BoardText& text) const {
    PlacedText placed{{text.bold, fontPixels(text.size_m)}, low(text.box), high(text.box), &text.text};
    placed.level = text.level;
    if (text.centred) placed.middle = 0.5F * (placed.low.x + placed.high.x);
    return placed;
}

PlacedText BoardLayout::label(const BoardButton& button) const {
    const bool alone = button.caption.empty();
    const double size_m = std::min((alone ? 0.5 : 0.42) * button.box.height, 0.05);
    PlacedText placed = inButton(button, size_m, true, alone ? 0.5 : 0.40, &button.label);
    placed.low.x += length(playMarkWidth(button));
    placed.middle = 0.5F * (placed.low.x + placed.high.x);
    return placed;
}

PlacedText BoardLayout::caption(const BoardButton& button) const {
    return inButton(button, std::min(0.21 * button.box.height, 0.035), false, 0.77, &button.caption);
}

PlacedText BoardLayout::inButton(const BoardButton& button, double size_m, bool bold, double down,
                                 const std::string* text) const {
    const ImVec2 a = low(button.box);
    const ImVec2 b = high(button.box);
    const int pixels = fontPixels(size_m);
    const float middle = a.y + static_cast<float>(down) * (b.y - a.y);
    const float half = 0.5F * static_cast<float>(pixels);
    const float inset = std::min(0.06F * (b.x - a.x), length(0.012));
    PlacedText placed{{bold, pixels}, {a.x + inset, middle - half}, {b.x - inset, middle + half}, text};
    placed.level = true;
    placed.middle = 0.5F * (a.x + b.x);
    return placed;
}

PlacedText BoardLayout::label(const BoardSlider& slider, std::size_t place) const {
    const auto last = static_cast<double>(std::max<std::size_t>(1, slider.labels.size() - 1));
    const double tick = slider.track.x + slider.track.width * static_cast<double>(place) / last;
    const double pitch = slider.track.width / last;
    const double top = slider.track.y - slider_label_drop_m;
    const double foot = std::min(slider.box.y, top - 0.01);
    // As wide as leaves the neighbours theirs; at the ends, what the box has.
    const double left = std::max(slider.box.x, tick - 0.48 * pitch);
    const double right = std::min(slider.box.x + slider.box.width, tick + 0.48 * pitch);
    PlacedText placed;
    placed.key = {false, fontPixels(std::min(slider.label_size_m, top - foot))};
    placed.low = at(left, top);
    placed.high = at(right, foot);
    placed.text = &slider.labels[place];
    placed.middle = at(tick, top).x;
    return placed;
}

PlacedText BoardLayout::content(const BoardField& field) const {
    const double size_m = std::min(0.6 * field.box.height, field_line_m);
    const double inset_m = std::min(field_inset_m, 0.1 * field.box.width);
    const double free_m = field.box.height - 2.0 * std::min(inset_m, 0.2 * field.box.height);
    const double lines = std::max(1.0, std::floor(free_m / size_m));
    const double rest_m = std::min(0.5 * (field.box.height - lines * size_m), inset_m);
    const double down_m = lines > 1.5 ? rest_m : 0.5 * (field.box.height - size_m);
    PlacedText placed;
    placed.key = {false, fontPixels(size_m)};
    placed.low = at(field.box.x + inset_m, field.box.y + field.box.height - down_m);
    placed.high =
        at(field.box.x + field.box.width - inset_m, field.box.y + field.box.height - down_m - lines * size_m);
    placed.text = field.text.empty() ? &field.hint : &field.text;
    placed.wrapped = lines > 1.5;
    placed.level = !placed.wrapped;
    placed.shrinks = field.text.empty();
    if (field.active && field.text.empty()) placed.low.x += caretRoom();
    return placed;
}

FontKey BoardLayout::fittedFont(const PlacedText& placed) const {
    if (!placed.shrinks) return placed.key;
    const ImFont& font = *fonts_.font(placed.key);
    const float width = widthOf(placed);
    const auto fits = [&](int pixels, bool may_cut) {
        const auto size = static_cast<float>(pixels);
        const auto lines = wrapText(font, size, *placed.text, placed.wrapped ? width : 0.0F);
        const bool wrong = std::any_of(lines.begin(), lines.end(), [&](const TextLine& line) {
            return line.width > width + 1.0F || (line.cut && !may_cut);
        });
        const float height = placed.high.y - placed.low.y;
        return !wrong && (static_cast<float>(lines.size()) * size <= height + 1.0F || lines.size() == 1);
    };
    // The largest size that fits, rather somewhat smaller than with a word cut.
    for (const bool may_cut : {false, true}) {
        const double share = may_cut ? min_shrink : min_shrink_for_words;
        const int min = std::max(min_pixels, static_cast<int>(share * placed.key.pixels));
        int pixels = placed.key.pixels;
        while (pixels > min && !fits(pixels, may_cut)) pixels = std::max(min, pixels * 15 / 16);
        if (may_cut || fits(pixels, may_cut)) return {placed.key.bold, pixels};
    }
    return placed.key;
}

FittedText BoardLayout::fittedLabel(const BoardButton& button) const {
    const PlacedText placed = label(button);
    FontKey key = fittedFont(placed);
    const auto alike = [&](const BoardButton& other) {
        return other.look == ButtonLook::option && other.box.width == button.box.width &&
               other.box.height == button.box.height && other.caption.empty() == button.caption.empty();
    };
    if (alike(button))
        for (const BoardButton& other : board_.buttons)
            if (alike(other)) key.pixels = std::min(key.pixels, fittedFont(label(other)).pixels);
    return fitted(placed, key);
}

FittedText BoardLayout::fittedLabel(const BoardSlider& slider, std::size_t place) const {
    const PlacedText placed = label(slider, place);
    FontKey key = placed.key;
    for (std::size_t i = 0; i < slider.labels.size(); ++i)
        key.pixels = std::min(key.pixels, fittedFont(label(slider, i)).pixels);
    return fitted(placed, key);
}

FittedText BoardLayout::fittedText(const BoardText& text) const {
    const PlacedText placed = this->text(text);
    FontKey key = fittedFont(placed);
    const double top = text.box.y + text.box.height;
    for (const BoardText& other : board_.texts)
        if (std::abs(other.box.y + other.box.height - top) < 1e-9 && other.size_m == text.size_m &&
            other.bold == text.bold)
            key.pixels = std::min(key.pixels, fittedFont(this->text(other)).pixels);
    return fitted(placed, key);
}

FittedText BoardLayout::fitted(const PlacedText& placed, const FontKey& key) const {
    FittedText out;
    out.key = key;
    const ImFont& font = *fonts_.font(out.key);
    const auto size = static_cast<float>(out.key.pixels);
    const float width = widthOf(placed);
    out.lines = wrapText(font, size, *placed.text, placed.wrapped ? width : 0.0F);
    if (!placed.shrinks) {
        const std::size_t max = fieldLines(placed);
        if (out.lines.size() > max)
            out.lines.erase(out.lines.begin(), out.lines.end() - static_cast<std::ptrdiff_t>(max));
        for (TextLine& line : out.lines) line = endOf(line, font, size, width);
    }
    for (const TextLine& line : out.lines)
        out.left.push_back(
            std::round(placed.middle ? std::max(placed.low.x, std::min(*placed.middle - 0.5F * line.width,
                                                                       placed.high.x - line.width))
                                     : placed.low.x));
    out.top = placed.low.y;
    if (placed.level) out.top += 0.5F * (placed.high.y - placed.low.y - out.height());
    return out;
}

void BoardLayout::draw(const FittedText& text, ImU32 colour, ImDrawList& list) const {
    const ImFont* font = fonts_.font(text.key);
    const auto size = static_cast<float>(text.key.pixels);
    float y = text.top;
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
        list.AddText(font, size, {text.left[i], std::round(y)}, colour, text.lines[i].begin,
                     text.lines[i].end);
        y += size;
    }
}

}  // namespace deixis::renderer
