// Where the texts and parts of a board lie, in pixels, y down.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "renderer/boards/board_text.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::renderer {

/// A text in pixels, ready to draw.
struct PlacedText {
    FontKey key;
    ImVec2 low, high;
    const std::string* text = nullptr;
    bool wrapped = false;           ///< what is typed; all else has its lines
    bool level = false;             ///< in the middle of its height; else from the top
    bool shrinks = true;            ///< to fit; else its beginning is left out
    std::optional<float> middle{};  ///< each line is centred here, but kept within the box; none: at its left
};

/// A text as it is drawn.
struct FittedText {
    FontKey key;
    std::vector<TextLine> lines;
    std::vector<float> left;  ///< of each line
    float top = 0.0F;

    [[nodiscard]] float height() const {
        return static_cast<float>(key.pixels) * static_cast<float>(lines.size());
    }
};

class BoardLayout {
  public:
    BoardLayout(const Board& board, double pixels_per_metre, const BoardFonts& fonts)
        : board_(board), scale_(pixels_per_metre), fonts_(fonts) {}

    [[nodiscard]] ImVec2 low(const BoardRect& box) const { return at(box.x, box.y + box.height); }
    [[nodiscard]] ImVec2 high(const BoardRect& box) const { return at(box.x + box.width, box.y); }
    /// Where a point of the board (metres from its lower left corner) lies, on whole pixels.
    [[nodiscard]] ImVec2 at(double x, double y) const;
    [[nodiscard]] float length(double metres) const { return static_cast<float>(metres * scale_); }
    /// What the caret takes before the hint of a field.
    [[nodiscard]] float caretRoom() const { return 3.0F * caretWidth(); }
    [[nodiscard]] float caretWidth() const { return stroke(0.003); }
    /// A line's width: thin ones stay visible where the board is drawn small.
    [[nodiscard]] float stroke(double metres) const;

    [[nodiscard]] PlacedText text(const BoardText& text) const;
    /// A button's label and caption: the label in the middle, moved up where there is a caption under it.
    [[nodiscard]] PlacedText label(const BoardButton& button) const;
    [[nodiscard]] PlacedText caption(const BoardButton& button) const;
    [[nodiscard]] PlacedText label(const BoardSlider& slider, std::size_t place) const;
    /// What is typed, or the hint.
    [[nodiscard]] PlacedText content(const BoardField& field) const;

    /// The font at which the text fits its box, or the smallest allowed. Measured with its own font.
    [[nodiscard]] FontKey fittedFont(const PlacedText& placed) const;
    /// With the font that fits, which must be there.
    [[nodiscard]] FittedText fitted(const PlacedText& placed) const {
        return fitted(placed, fittedFont(placed));
    }
    /// Options of one size, labels that stand in a row, and those of a slider are as large as fits them all.
    [[nodiscard]] FittedText fittedLabel(const BoardButton& button) const;
    [[nodiscard]] FittedText fittedLabel(const BoardSlider& slider, std::size_t place) const;
    [[nodiscard]] FittedText fittedText(const BoardText& text) const;
    void draw(const FittedText& text, ImU32 colour, ImDrawList& list) const;

    /// All texts of the board.
    template <typename Visit>
    void eachText(const Visit& visit) const {
        for (const BoardText& part : board_.texts) visit(text(part));
        for (const BoardButton& button : board_.buttons) {
            visit(label(button));
            if (!button.caption.empty()) visit(caption(button));
        }
        for (const BoardSlider& slider : board_.sliders)
            for (std::size_t i = 0; i < slider.labels.size(); ++i) visit(label(slider, i));
        for (const BoardField& field : board_.fields) visit(content(field));
    }

  private:
    [[nodiscard]] FittedText fitted(const PlacedText& placed, const FontKey& key) const;
    [[nodiscard]] int fontPixels(double size_m) const;
    [[nodiscard]] PlacedText inButton(const BoardButton& button, double size_m, bool bold, double down,
                                      const std::string* text) const;

    const Board& board_;
    double scale_;
    const BoardFonts& fonts_;
};

/// Room that a play button's triangle takes before the label, metres.
[[nodiscard]] double playMarkWidth(const BoardButton& button);

}  // namespace deixis::renderer
