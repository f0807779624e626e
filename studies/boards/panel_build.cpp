#include "panel_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "studies/texts/text_layout.hpp"

namespace deixis::studies::panel {

namespace {

constexpr double min_share = 0.75;  // of its size: a text with a word too long for its width
constexpr double progress_height_m = 0.03;
constexpr double button_inset_m = 0.03;  // on either side of a label
constexpr double min_button_m = 0.26;
constexpr double play_mark_m = 0.036;
constexpr double label_inset_m = 0.012;
constexpr double widest_step_m = 0.3;
constexpr double label_gap_m = 0.012;    // between a scale and its labels
constexpr double label_apart = 0.04;     // between labels, of their pitch
constexpr double label_reach_m = 0.018;  // beyond the ends of a track under them

/// Where the buttons of a scale's steps stand within a width.
struct StepGrid {
    int rows = 1;
    int in_row = 1;
    double left = 0.0;
    double step_m = 0.0;
    double pitch_m = 0.0;
    double width_m = 0.0;  ///< of a full row
};

StepGrid stepGrid(const Scale& scale, double x, double width_m) {
    StepGrid grid;
    grid.rows = (scale.steps() + max_in_row - 1) / max_in_row;
    grid.in_row = (scale.steps() + grid.rows - 1) / grid.rows;
    const double between_m = grid.in_row > 5 ? 0.016 : button_gap_m;
    grid.step_m = std::min(widest_step_m, (width_m - (grid.in_row - 1) * between_m) / grid.in_row);
    grid.pitch_m = grid.step_m + between_m;
    grid.width_m = grid.in_row * grid.pitch_m - between_m;
    grid.left = x + (width_m - grid.width_m) / 2.0;
    return grid;
}

struct Span {
    double low = 0.0;
    double high = 0.0;
};

/// What a label of a track may take: up to the middle to its neighbours, at the ends what the box has.
Span labelSpan(const PanelRect& track, std::size_t count, std::size_t place, const PanelRect& box) {
    const double pitch_m = track.width / static_cast<double>(count - 1);
    const double middle = track.x + static_cast<double>(place) * pitch_m;
    const double half_m = (1.0 - label_apart) / 2.0 * pitch_m;
    return {std::max(box.x, middle - half_m), std::min(box.x + box.width, middle + half_m)};
}

Span labelSpan(const Scale& scale, std::size_t place, double x, double width_m) {
    if (scale.kind == ScaleKind::steps) {
        const StepGrid grid = stepGrid(scale, x, width_m);
        const double left = grid.left + static_cast<double>(place) * grid.pitch_m;
        return {left, left + grid.step_m};
    }
    PanelSlider slider;
    slider.box = {x, 0.0, width_m, slider_height_m};
    return labelSpan(slider.track(), scale.labels.size(), place, slider.box);
}

/// The size, or less where a word is too long for the width.
double fittedSize(const std::string& text, double size_m, double width_m, bool bold) {
    const double widest_m = widestWord(text, size_m, bold);
    return widest_m <= width_m ? size_m : size_m * std::max(min_share, width_m / widest_m);
}

std::string joined(const std::vector<std::string>& lines) {
    return fmt::format("{}", fmt::join(lines, "\n"));
}

bool everyStepLabelled(const Scale& scale) {
    return !scale.labels.empty() && static_cast<int>(scale.labels.size()) == scale.steps() &&
           scale.steps() != 2;
}

}  // namespace

double textHeight(const std::string& text, double size_m, double width_m, bool bold) {
    if (text.empty()) return 0.0;
    const double fitted_m = fittedSize(text, size_m, width_m, bold);
    return static_cast<double>(wrapText(text, fitted_m, width_m, bold).size()) * fitted_m;
}

double buttonWidth(const std::string& label, ButtonRole role) {
    const double mark_m = role == ButtonRole::play ? play_mark_m : 0.0;
    return std::max(min_button_m, textWidth(label, button_size_m, true) + 2.0 * button_inset_m + mark_m);
}

bool fitsAsLabel(const std::string& text, double button_m) {
    constexpr double min_label = 0.7;
    return text.find('\n') == std::string::npos &&
           textWidth(text, min_label * button_size_m, true) <= button_m - 2.0 * label_inset_m;
}

bool fitAsCaptions(const std::vector<std::string>& labels, double button_m) {
    return std::all_of(labels.begin(), labels.end(), [&](const std::string& label) {
        return label.find('\n') == std::string::npos &&
               textWidth(label, label_size_m) <= button_m - 2.0 * label_inset_m;
    });
}

bool labelsFit(const Scale& scale, double width_m) {
    if (scale.kind == ScaleKind::steps && !everyStepLabelled(scale)) return true;
    for (std::size_t i = 0; i < scale.labels.size(); ++i) {
        const Span span = labelSpan(scale, i, 0.0, width_m);
        if (widestWord(scale.labels[i], label_size_m) > span.high - span.low) return false;
    }
    return true;
}

double Builder::text(const std::string& words, double x, double top, double width_m, const TextStyle& style) {
    if (words.empty()) return 0.0;
    PanelText made;
    made.size_m = style.fitted ? style.size_m : fittedSize(words, style.size_m, width_m, style.bold);
    const auto lines = wrapText(words, made.size_m, width_m, style.bold);
    const double height_m = std::max(style.min_height_m, static_cast<double>(lines.size()) * made.size_m);
    made.box = {x, top - height_m, width_m, height_m};
    made.text = joined(lines);
    made.bold = style.bold;
    made.centred = style.centred;
    made.faint = style.faint;
    made.level = style.min_height_m > 0.0;
    panel_.texts.push_back(std::move(made));
    return height_m;
}

double Builder::button(const ButtonSpec& spec, double x, double top, double width_m, double height_m) {
    PanelButton made;
    made.box = {x, top - height_m, width_m, height_m};
    made.label = spec.label;
    made.id = spec.id;
    made.role = spec.role;
    made.enabled = spec.enabled;
    panel_.buttons.push_back(std::move(made));
    return height_m;
}

double Builder::buttons(const std::vector<ButtonSpec>& specs, double x, double top, double width_m,
                        double height_m, bool centred) {
    double used_m = 0.0;
    for (std::size_t first = 0; first < specs.size();) {
        std::size_t end = first;
        double row_m = -button_gap_m;
        for (; end < specs.size(); ++end) {
            const double more =
                std::min(buttonWidth(specs[end].label, specs[end].role), width_m) + button_gap_m;
            if (end > first && row_m + more > width_m + 1e-9) break;
            row_m += more;
        }
        if (first > 0) used_m += button_gap_m;
        double at = centred ? x + (width_m - row_m) / 2.0 : x;
        for (; first < end; ++first) {
            const double one_m = std::min(buttonWidth(specs[first].label, specs[first].role), width_m);
            button(specs[first], at, top - used_m, one_m, height_m);
            at += one_m + button_gap_m;
        }
        used_m += height_m;
    }
    return used_m;
}

double Builder::scale(const ScalePart& part, double x, double top, double width_m) {
    return part.scale.kind == ScaleKind::slider ? slider(part, x, top, width_m)
                                                : steps(part, x, top, width_m);
}

double Builder::steps(const ScalePart& part, double x, double top, double width_m) {
    const Scale& scale = part.scale;
    const StepGrid grid = stepGrid(scale, x, width_m);
    const bool each = part.labelled && everyStepLabelled(scale);
    const bool names = each && part.named &&
                       std::all_of(scale.labels.begin(), scale.labels.end(),
                                   [&](const std::string& one) { return fitsAsLabel(one, grid.step_m); });
    const bool captions =
        !names && each && part.button_height_m >= button_height_m && fitAsCaptions(scale.labels, grid.step_m);
    const double height_m =
        captions ? std::max(caption_height_m, part.button_height_m) : part.button_height_m;

    TextStyle label_style{label_size_m, false, true};
    label_style.fitted = true;
    for (const std::string& label : scale.labels)
        label_style.size_m =
            std::min(label_style.size_m, fittedSize(label, label_size_m, grid.step_m, false));

    double used_m = 0.0;
    for (int row = 0; row < grid.rows; ++row) {
        if (row > 0) used_m += grid.pitch_m - grid.step_m;
        const double row_top = top - used_m;
        double labels_m = 0.0;
        for (int i = row * grid.in_row; i < std::min(scale.steps(), (row + 1) * grid.in_row); ++i) {
            const double at = grid.left + (i - row * grid.in_row) * grid.pitch_m;
            const int value = scale.low + i;
            button({std::to_string(value), part.first_id + i, ButtonRole::option, part.enabled}, at, row_top,
                   grid.step_m, height_m);
            lastButton().chosen = part.value == value;
            if (!each) continue;
            const std::string& label = scale.labels[static_cast<std::size_t>(i)];
            if (names)
                lastButton().label = label;
            else if (captions)
                lastButton().caption = label;
            else
                labels_m = std::max(
                    labels_m, text(label, at, row_top - height_m - label_gap_m, grid.step_m, label_style));
        }
        used_m += height_m + (labels_m > 0.0 ? label_gap_m + labels_m : 0.0);
    }
    if (!part.labelled || each || scale.labels.empty()) return used_m;
    return used_m + label_gap_m + scaleLabels(scale, x, top - used_m - label_gap_m, width_m);
}

double Builder::slider(const ScalePart& part, double x, double top, double width_m) {
    PanelSlider made;
    made.id = part.slider_id;
    made.low = part.scale.low;
    made.high = part.scale.high;
    made.value = part.value;
    made.enabled = part.enabled;
    made.box = {x, top, width_m, std::max(slider_height_m, part.labelled ? 0.0 : part.button_height_m)};
    if (part.labelled && !part.scale.labels.empty()) {
        made.labels = part.scale.labels;
        const auto widthOf = [&](std::size_t i) {
            const Span span = labelSpan(made.track(), made.labels.size(), i, made.box);
            return span.high - span.low;
        };
        made.label_size_m = label_size_m;
        for (std::size_t i = 0; i < made.labels.size(); ++i)
            made.label_size_m =
                std::min(made.label_size_m, fittedSize(made.labels[i], label_size_m, widthOf(i), false));
        std::size_t max = 1;
        for (std::size_t i = 0; i < made.labels.size(); ++i) {
            const auto lines = wrapText(made.labels[i], made.label_size_m, widthOf(i));
            max = std::max(max, lines.size());
            made.labels[i] = joined(lines);
        }
        made.box.height = slider_label_drop_m + static_cast<double>(max) * made.label_size_m;
    }
    const double height_m = made.box.height;
    made.box.y = top - height_m;
    panel_.sliders.push_back(std::move(made));
    return height_m;
}

void Builder::sliderValue(int value, double width_m, bool beside) {
    const PanelSlider& slider = panel_.sliders.back();
    const PanelRect track = slider.track();
    TextStyle style{label_size_m, true, true};
    style.fitted = true;
    const std::string number = std::to_string(value);
    if (beside) {
        text(number, slider.box.x + slider.box.width, track.y + 0.5 * (track.height + label_size_m), width_m,
             style);
    } else {
        const double share = static_cast<double>(value - slider.low) / std::max(1, slider.high - slider.low);
        text(number, track.x + share * track.width - 0.5 * width_m, slider.box.y, width_m, style);
    }
}

double Builder::scaleLabels(const Scale& scale, double x, double top, double width_m) {
    const std::vector<std::string>& labels = scale.labels;
    if (labels.empty()) return 0.0;
    const bool steps = scale.kind == ScaleKind::steps;
    const StepGrid grid = steps ? stepGrid(scale, x, width_m) : StepGrid{};
    if (grid.rows > 1)  // the ends stand in different rows
        return endLabels(fmt::format("{}: {}", scale.low, labels.front()),
                         fmt::format("{}: {}", scale.high, labels.back()), grid.left, top, grid.width_m);
    if (labels.size() == 2)
        return endLabels(labels.front(), labels.back(), steps ? grid.left : x, top,
                         steps ? grid.width_m : width_m);
    std::vector<Span> spans;
    TextStyle style{label_size_m, false, true};
    style.fitted = true;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        Span span = labelSpan(scale, i, x, width_m);
        if (!steps && i == 0) span.low -= label_reach_m;
        if (!steps && i + 1 == labels.size()) span.high += label_reach_m;
        spans.push_back(span);
        style.size_m =
            std::min(style.size_m, fittedSize(labels[i], label_size_m, span.high - span.low, false));
    }
    double height_m = 0.0;
    for (std::size_t i = 0; i < labels.size(); ++i)
        height_m =
            std::max(height_m, text(labels[i], spans[i].low, top, spans[i].high - spans[i].low, style));
    return height_m;
}

double Builder::endLabels(const std::string& low, const std::string& high, double x, double top,
                          double width_m) {
    const double max_m = (1.0 - label_apart) / 2.0 * width_m;
    const auto width = [&](const std::string& label) {
        return std::min(max_m, textWidth(label, label_size_m) + 1e-6);
    };
    const double low_m = text(low, x, top, width(low), {label_size_m});
    const double high_m =
        text(high, x + width_m - width(high), top, width(high), {label_size_m, false, true});
    return std::max(low_m, high_m);
}

void Builder::paragraph(const std::string& words, const TextStyle& style) {
    if (words.empty()) return;
    advance(text(words, margin_m, top_, inner(), style));
}

void Builder::question(const std::string& question, const std::string& hint,
                       const std::optional<ButtonSpec>& spec) {
    const double button_m = spec ? std::min(buttonWidth(spec->label, spec->role), 0.5 * inner()) : 0.0;
    const double width_m = inner() - (spec ? button_m + gap_m : 0.0);
    const double min_m = spec ? button_height_m : 0.0;
    TextStyle style{question_size_m, true, !spec};
    double row_m = 0.0;
    if (hint.empty()) {
        style.min_height_m = min_m;  // level with the button
        row_m = text(question, margin_m, top_, width_m, style);
    } else {
        const double question_m = textHeight(question, question_size_m, width_m, true);
        const double texts_m = question_m + label_gap_m + textHeight(hint, label_size_m, width_m);
        row_m = std::max(texts_m, min_m);
        const double texts_top = top_ - (row_m - texts_m) / 2.0;
        text(question, margin_m, texts_top, width_m, style);
        text(hint, margin_m, texts_top - question_m - label_gap_m, width_m,
             {label_size_m, false, !spec, true});
    }
    if (spec)
        button(*spec, panel_.width_m - margin_m - button_m, top_ - (row_m - button_height_m) / 2.0, button_m,
               button_height_m);
    advance(row_m);
}

Panel Builder::finish(double progress) {
    double lowest = 0.0;
    const auto each = [&](const auto& visit) {
        for (PanelText& part : panel_.texts) visit(part.box);
        for (PanelButton& part : panel_.buttons) visit(part.box);
        for (PanelSlider& part : panel_.sliders) visit(part.box);
        for (PanelField& part : panel_.fields) visit(part.box);
    };
    each([&](const PanelRect& box) { lowest = std::min(lowest, box.y); });
    panel_.progress = progress;
    panel_.height_m = -lowest + margin_m + (progress >= 0.0 ? progress_height_m : 0.0);
    each([&](PanelRect& box) { box.y += panel_.height_m; });
    return std::move(panel_);
}

}  // namespace deixis::studies::panel
