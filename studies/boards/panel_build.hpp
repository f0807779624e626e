// What the builders of boards share: a panel that is filled from its head downwards, and the parts they
// place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/boards/panel_layout.hpp"

namespace deixis::studies::panel {

constexpr double wide_m = 1.55;  ///< of a board with a scale
constexpr double highest_m = 1.1;
constexpr double margin_m = 0.07;
constexpr double gap_m = 0.04;
constexpr double title_size_m = 0.066;
constexpr double body_size_m = 0.046;
constexpr double question_size_m = 0.05;
constexpr double item_size_m = 0.042;   ///< a question of a questionnaire
constexpr double label_size_m = 0.036;  ///< anchors of a scale
constexpr double button_size_m = 0.05;  ///< a button's label
constexpr double button_height_m = 0.13;
constexpr double low_button_height_m = 0.11;
constexpr double caption_height_m = 0.17;  ///< of a button with a caption
constexpr double button_gap_m = 0.03;
constexpr double slider_height_m = 0.11;
constexpr double slider_label_drop_m = 0.095;  ///< from its top to its labels, where it has any
constexpr int max_in_row = 11;

struct TextStyle {
    double size_m = body_size_m;
    bool bold = false;
    bool centred = false;
    bool faint = false;
    double min_height_m = 0.0;  ///< of its box, in the middle of which it stands then
    bool fitted = false;        ///< its size is what fits several texts alike
};

[[nodiscard]] double textHeight(const std::string& text, double size_m, double width_m, bool bold = false);

/// Wide enough for its label on one line, and for the mark of a play button.
[[nodiscard]] double buttonWidth(const std::string& label, ButtonRole role = ButtonRole::other);

/// Whether all of them fit on one line as captions of buttons so wide.
[[nodiscard]] bool fitAsCaptions(const std::vector<std::string>& labels, double button_m);

/// Whether a text fits a button as its label, at no less than 0.7 of its size.
[[nodiscard]] bool fitsAsLabel(const std::string& text, double button_m);

/// Whether no word of the labels must be broken where the scale is so wide.
[[nodiscard]] bool labelsFit(const Scale& scale, double width_m);

/// A scale and its answer, to be placed.
struct ScalePart {
    const Scale& scale;
    int first_id = 0;   ///< of its lowest step
    int slider_id = 0;  ///< or of its slider
    std::optional<int> value{};
    bool enabled = true;
    bool labelled = true;
    bool named = false;  ///< steps that all have a label show it in place of their number, where it fits
    double button_height_m = panel::button_height_m;
};

/// Boxes are laid downwards from y = 0; finish() moves the origin to the lower left corner.
class Builder {
  public:
    explicit Builder(double width_m) { panel_.width_m = width_m; }

    [[nodiscard]] double inner() const { return panel_.width_m - 2.0 * margin_m; }
    [[nodiscard]] double top() const { return top_; }  ///< where the next part begins; falls from -margin_m

    /// Goes down by the height of what has been placed, and a gap.
    void advance(double height_m, double gap = gap_m) { top_ -= height_m + gap; }

    /// These place a part with its top at `top` and return its height, without a gap.
    double text(const std::string& words, double x, double top, double width_m, const TextStyle& style);
    double button(const ButtonSpec& spec, double x, double top, double width_m, double height_m);
    double scale(const ScalePart& part, double x, double top, double width_m);
    /// The last slider's value: level with its track beside it, or under its thumb.
    void sliderValue(int value, double width_m, bool beside);
    /// The labels of a scale alone, where they stand over or under its steps or track.
    double scaleLabels(const Scale& scale, double x, double top, double width_m);
    /// Buttons in rows, centred or from the left.
    double buttons(const std::vector<ButtonSpec>& specs, double x, double top, double width_m,
                   double height_m, bool centred);

    /// A text over the whole width, and down below it; nothing where it is empty.
    void paragraph(const std::string& words, const TextStyle& style);
    /// The question at the left (in the middle where it is alone), under it the hint, and the button at the
    /// right; and down below them.
    void question(const std::string& question, const std::string& hint,
                  const std::optional<ButtonSpec>& spec);

    [[nodiscard]] Panel& made() { return panel_; }
    [[nodiscard]] PanelButton& lastButton() { return panel_.buttons.back(); }
    [[nodiscard]] Panel finish(double progress = -1.0);

  private:
    double steps(const ScalePart& part, double x, double top, double width_m);
    double slider(const ScalePart& part, double x, double top, double width_m);
    double endLabels(const std::string& low, const std::string& high, double x, double top, double width_m);

    Panel panel_;
    double top_ = -margin_m;
};

}  // namespace deixis::studies::panel
