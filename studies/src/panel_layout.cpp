#include "panel_layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deixis::studies {

namespace {

constexpr double margin_m = 0.07;
constexpr double gap_m = 0.04;
constexpr double title_size_m = 0.066;
constexpr double body_size_m = 0.046;
constexpr double question_size_m = 0.05;
constexpr double button_height_m = 0.13;
constexpr double button_gap_m = 0.03;
constexpr double progress_height_m = 0.03;
constexpr double line_spacing = 1.15;  // leaves room for fonts that run a little wider than estimated
constexpr double average_character_em = 0.45;

constexpr double message_distance_m = 1.3;
constexpr double message_below_eyes_m = 0.12;
constexpr double lectern_distance_m = 1.3;
constexpr double lectern_below_eyes_m = 0.47;
constexpr double lectern_tilt_rad = radiansFromDegrees(18.0);
constexpr double desk_distance_m = 1.1;
constexpr double desk_below_eyes_m = 0.72;
constexpr double desk_tilt_rad = radiansFromDegrees(32.0);
constexpr double avatar_reach_m = 0.38;  // half its width with the arms hanging, and a little air

int codePoints(std::string_view text) {
    return static_cast<int>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

double textHeight(const std::string& text, double size_m, double width_m) {
    return text.empty() ? 0.0 : estimateLines(text, size_m, width_m) * size_m * line_spacing;
}

double buttonWidth(const std::string& label) {
    return std::max(0.26, codePoints(label) * body_size_m * average_character_em + 0.1);
}

PanelButton button(const ButtonSpec& spec, const PanelRect& box) {
    PanelButton made;
    made.box = box;
    made.label = spec.label;
    made.id = spec.id;
    return made;
}

/// The panel at a given width; its height follows from the text.
Panel messageAtWidth(double width_m, const std::string& title, const std::string& body,
                     const std::string& emphasis, const std::vector<ButtonSpec>& buttons, double progress) {
    Panel panel;
    panel.width_m = width_m;
    panel.progress = progress;
    const double inner = width_m - 2.0 * margin_m;

    // From the foot upwards: buttons, emphasis, body, title.
    double y = margin_m + (progress >= 0.0 ? progress_height_m : 0.0);
    double row = -button_gap_m;
    for (const ButtonSpec& spec : buttons) row += buttonWidth(spec.label) + button_gap_m;
    double x = (width_m - row) / 2.0;
    for (const ButtonSpec& spec : buttons) {
        const double button_width = buttonWidth(spec.label);
        panel.buttons.push_back(button(spec, {x, y, button_width, button_height_m}));
        x += button_width + button_gap_m;
    }
    if (!buttons.empty()) y += button_height_m + 1.5 * gap_m;

    const auto text = [&](const std::string& words, double size_m, bool bold) {
        if (words.empty()) return;
        PanelText line;
        line.box = {margin_m, y, inner, textHeight(words, size_m, inner)};
        line.text = words;
        line.size_m = size_m;
        line.bold = bold;
        y += line.box.height + gap_m;
        panel.texts.push_back(std::move(line));
    };
    text(emphasis, body_size_m, true);
    text(body, body_size_m, false);
    text(title, title_size_m, true);
    std::reverse(panel.texts.begin(), panel.texts.end());
    panel.height_m = y - gap_m + margin_m;
    return panel;
}

/// Lays the question at the left of the panel's head and the button, if any, at its right, both above
/// `foot_m`.
void addQuestionRow(Panel& panel, double foot_m, const std::string& question,
                    const std::optional<ButtonSpec>& spec) {
    double inner = panel.width_m - 2.0 * margin_m;
    const double button_width = spec ? buttonWidth(spec->label) : 0.0;
    if (spec) inner -= button_width + gap_m;
    const double text_height = textHeight(question, question_size_m, inner);
    const double row_height = std::max(text_height, spec ? button_height_m : 0.0);
    PanelText text;
    text.box = {margin_m, foot_m + (row_height - text_height) / 2.0, inner, text_height};
    text.text = question;
    text.size_m = question_size_m;
    text.bold = true;
    text.centred = !spec;
    panel.texts.push_back(std::move(text));
    if (spec)
        panel.buttons.push_back(
            button(*spec, {panel.width_m - margin_m - button_width,
                           foot_m + (row_height - button_height_m) / 2.0, button_width, button_height_m}));
    panel.height_m = foot_m + row_height + margin_m;
}

/// How far to the left (radians) a panel must stand so that an avatar nearer than it does not cover it: where
/// the viewer stands at the avatar's shoulder. 0 where the avatar is farther away than the panel.
double bearingBesideAvatar(const Panel& panel, const Pose& stage_from_viewer, double distance_m) {
    const Vec3 avatar = transformPoint(inverse(stage_from_viewer), Vec3(0.0));
    const double away_m = std::hypot(avatar.x, avatar.z);
    if (away_m > distance_m + avatar_reach_m) return 0.0;
    const double avatar_bearing = std::atan2(-avatar.x, -avatar.z);
    const double apart =
        std::asin(std::min(1.0, avatar_reach_m / away_m)) + std::atan(panel.width_m / 2.0 / distance_m);
    if (std::abs(avatar_bearing) >= apart) return 0.0;
    return avatar_bearing > 0.0 ? avatar_bearing - apart : avatar_bearing + apart;
}

/// The panel's centre at `distance_m` before the viewer and `height_m` above the floor, its top leaning away.
Pose stand(const Panel& panel, const Pose& stage_from_viewer, double distance_m, double height_m,
           double tilt_rad) {
    const Quat tilt(std::cos(tilt_rad / 2.0), -std::sin(tilt_rad / 2.0), 0.0, 0.0);
    const Pose turned{Vec3(0.0), yawRotation(bearingBesideAvatar(panel, stage_from_viewer, distance_m))};
    const Pose turned_from_centre{{0.0, height_m, -distance_m}, tilt};
    const Pose centre_from_corner{{-panel.width_m / 2.0, -panel.height_m / 2.0, 0.0}, no_rotation};
    return stage_from_viewer * turned * turned_from_centre * centre_from_corner;
}

bool inside(const PanelRect& box, double x, double y) {
    return x >= box.x && x <= box.x + box.width && y >= box.y && y <= box.y + box.height;
}

}  // namespace

int estimateLines(std::string_view text, double size_m, double width_m) {
    const int fits = std::max(1, static_cast<int>(width_m / (size_m * average_character_em)));
    int lines = 0;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t stop = std::min(text.find('\n', start), text.size());
        const std::string_view paragraph = text.substr(start, stop - start);
        ++lines;
        int used = 0;
        std::size_t word_start = 0;
        while (word_start < paragraph.size()) {
            const std::size_t word_stop = std::min(paragraph.find(' ', word_start), paragraph.size());
            const int word = codePoints(paragraph.substr(word_start, word_stop - word_start));
            if (used > 0 && used + 1 + word > fits) {
                ++lines;
                used = 0;
            }
            used += word + (used > 0 ? 1 : 0);
            for (; used > fits; used -= fits) ++lines;  // a word longer than a line
            word_start = word_stop + 1;
        }
        start = stop + 1;
    }
    return lines;
}

Panel messagePanel(const std::string& title, const std::string& body, const std::string& emphasis,
                   const std::vector<ButtonSpec>& buttons, double progress) {
    constexpr double comfortable_height_m = 1.0;
    Panel panel;
    for (const double width_m : {1.1, 1.3, 1.5}) {
        panel = messageAtWidth(width_m, title, body, emphasis, buttons, progress);
        if (panel.height_m <= comfortable_height_m) break;
    }
    return panel;
}

Panel ratingPanel(const std::string& question, const std::vector<std::string>& labels, int first_id,
                  const std::optional<ButtonSpec>& replay) {
    constexpr double scale_button_height_m = 0.17;  // a number and two lines of caption
    const auto count = static_cast<double>(labels.size());
    Panel panel;
    panel.width_m = std::max(1.55, 2.0 * margin_m + count * (0.14 + button_gap_m) - button_gap_m);
    const double inner = panel.width_m - 2.0 * margin_m;
    const double width = std::min(0.3, (inner - (count - 1.0) * button_gap_m) / count);
    double x = (panel.width_m - count * width - (count - 1.0) * button_gap_m) / 2.0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const int value = static_cast<int>(i) + 1;
        PanelButton made = button({std::to_string(value), first_id + value - 1},
                                  {x, margin_m, width, scale_button_height_m});
        made.caption = labels[i];
        panel.buttons.push_back(std::move(made));
        x += width + button_gap_m;
    }
    addQuestionRow(panel, margin_m + scale_button_height_m + gap_m, question, replay);
    return panel;
}

Panel questionPanel(const std::string& question, const ButtonSpec& spec) {
    Panel panel;
    panel.width_m = 1.0;
    addQuestionRow(panel, margin_m, question, spec);
    return panel;
}

Pose messagePose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    // A tall board would reach into the floor before a seated person: it keeps its foot above it.
    const double height_m = std::max(eye_height_m - message_below_eyes_m, 0.2 + panel.height_m / 2.0);
    return stand(panel, stage_from_viewer, message_distance_m, height_m, 0.0);
}

Pose lecternPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    return stand(panel, stage_from_viewer, lectern_distance_m, eye_height_m - lectern_below_eyes_m,
                 lectern_tilt_rad);
}

Pose deskPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    return stand(panel, stage_from_viewer, desk_distance_m, eye_height_m - desk_below_eyes_m, desk_tilt_rad);
}

std::optional<PanelHit> meetPanel(const Panel& panel, const Ray& ray) {
    const Pose panel_from_stage = inverse(panel.stage_from_panel);
    const Vec3 origin = transformPoint(panel_from_stage, ray.origin);
    const Vec3 direction = panel_from_stage.orientation * ray.direction;
    if (std::abs(direction.z) < 1e-9) return std::nullopt;
    const double distance = -origin.z / direction.z;
    if (distance < 0.0) return std::nullopt;
    const Vec3 point = origin + distance * direction;
    if (!inside({0.0, 0.0, panel.width_m, panel.height_m}, point.x, point.y)) return std::nullopt;
    PanelHit hit{distance, -1};
    for (std::size_t i = 0; i < panel.buttons.size(); ++i)
        if (panel.buttons[i].enabled && inside(panel.buttons[i].box, point.x, point.y))
            hit.button = static_cast<int>(i);
    return hit;
}

}  // namespace deixis::studies
