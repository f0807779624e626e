#include "frame_scene.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace deixis::app {

namespace {

renderer::Ball ballFromView(const studies::BallView& view) {
    renderer::Ball ball;
    ball.centre = view.centre;
    ball.radius_m = view.radius_m;
    switch (view.look) {
        case studies::BallLook::waiting:
            ball.colour = glm::vec3(0.012F);
            break;
        case studies::BallLook::selectable:
            ball.colour = glm::vec3(0.85F);
            break;
        case studies::BallLook::hovered:
            ball.colour = glm::vec3(0.95F, 0.72F, 0.30F);
            ball.glow = glm::vec3(0.35F, 0.20F, 0.03F);
            break;
        case studies::BallLook::chosen:
            ball.colour = glm::vec3(0.95F, 0.55F, 0.10F);
            ball.glow = glm::vec3(0.75F, 0.38F, 0.05F);
            break;
        case studies::BallLook::revealed:
            ball.colour = glm::vec3(0.10F, 0.60F, 0.22F);
            ball.glow = glm::vec3(0.03F, 0.42F, 0.10F);
            ball.ring = true;
            break;
    }
    return ball;
}

renderer::BoardRect rectFrom(const studies::PanelRect& r) {
    return {r.x, r.y, r.width, r.height};
}

renderer::ButtonLook lookOf(studies::ButtonRole role) {
    switch (role) {
        case studies::ButtonRole::go_on:
            return renderer::ButtonLook::go_on;
        case studies::ButtonRole::leave:
            return renderer::ButtonLook::leave;
        case studies::ButtonRole::play:
            return renderer::ButtonLook::play;
        case studies::ButtonRole::option:
            return renderer::ButtonLook::option;
        case studies::ButtonRole::other:
            break;
    }
    return renderer::ButtonLook::plain;
}

renderer::BoardSlider sliderFrom(const studies::PanelSlider& slider) {
    renderer::BoardSlider made;
    made.box = rectFrom(slider.box);
    made.track = rectFrom(slider.track());
    if (slider.value)
        made.value = static_cast<double>(*slider.value - slider.low) /
                     static_cast<double>(std::max(1, slider.high - slider.low));
    made.labels = slider.labels;
    made.enabled = slider.enabled;
    made.hovered = slider.hovered;
    return made;
}

renderer::Board boardFromPanel(const studies::Panel& panel) {
    renderer::Board board;
    board.stage_from_board = panel.stage_from_panel;
    board.width_m = panel.width_m;
    board.height_m = panel.height_m;
    board.progress = panel.progress;
    for (const auto& t : panel.texts)
        board.texts.push_back({rectFrom(t.box), t.text, t.size_m, t.bold, t.centred, t.faint, t.level});
    for (const auto& b : panel.buttons)
        board.buttons.push_back(
            {rectFrom(b.box), b.label, b.caption, b.enabled, b.hovered, b.chosen, lookOf(b.role)});
    for (const auto& s : panel.sliders) board.sliders.push_back(sliderFrom(s));
    for (const auto& f : panel.fields)
        board.fields.push_back({rectFrom(f.box), f.text, f.hint, f.active, f.enabled, f.hovered});
    return board;
}

// At the two spaces between sentences that are nearest to the middle.
std::string brokenInTheMiddle(const std::string& words) {
    const auto middle = static_cast<std::ptrdiff_t>(words.size() / 2);
    std::size_t best = std::string::npos;
    for (std::size_t at = words.find("  "); at != std::string::npos; at = words.find("  ", at + 2)) {
        const auto off = [&](std::size_t place) {
            return std::abs(static_cast<std::ptrdiff_t>(place) - middle);
        };
        if (best == std::string::npos || off(at) < off(best)) best = at;
    }
    return best == std::string::npos ? words : words.substr(0, best) + "\n" + words.substr(best + 2);
}

}  // namespace

renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame, const Pose& stage_from_eye) {
    renderer::Scene scene;
    scene.camera.stage_from_eye = stage_from_eye;
    if (frame.avatar_visible) {
        scene.avatars.push_back(frame.avatar_joints);
        if (!frame.right_avatar_joints.empty()) scene.avatars.push_back(frame.right_avatar_joints);
    }
    for (const auto& ball : frame.balls) scene.balls.push_back(ballFromView(ball));
    if (frame.ray) {
        renderer::Beam beam;
        beam.ray = frame.ray->ray;
        beam.length_m = frame.ray->length_m;
        scene.beams.push_back(beam);
    }
    if (frame.panel) scene.boards.push_back(boardFromPanel(*frame.panel));
    if (frame.sign) scene.boards.push_back(boardFromPanel(*frame.sign));
    return scene;
}

renderer::Board noticeBoard(const std::string& sentence, double line_m) {
    renderer::Board board;
    double letters = 0.0;
    for (const char byte : sentence) {
        const auto lead = static_cast<unsigned char>(byte);
        if (lead < 0x80U || lead >= 0xC0U) letters += lead < 0xE0U ? 0.52 : 0.75;
    }
    board.width_m = std::clamp(letters * line_m + 3.5 * line_m, 11.0 * line_m, 26.0 * line_m);
    board.height_m = 3.2 * line_m;
    renderer::BoardText text;
    text.box = {0.9 * line_m, 0.5 * line_m, board.width_m - 1.8 * line_m, 2.2 * line_m};
    text.text = sentence;
    text.size_m = line_m;
    text.centred = true;
    text.level = true;
    board.texts.push_back(text);
    return board;
}

void addNotice(renderer::Scene& scene, const std::string& notice) {
    if (notice.empty()) return;
    constexpr double line_m = 0.023;
    constexpr double away_m = 0.55;  // nearer than any avatar, ball or panel
    constexpr double above_m = 0.21;
    renderer::Board board = noticeBoard(notice, line_m);
    board.stage_from_board =
        scene.camera.stage_from_eye *
        Pose{{-board.width_m / 2.0, above_m - board.height_m / 2.0, -away_m}, no_rotation};
    scene.boards.push_back(std::move(board));
}

bool explainsControls(const studies::PresentedFrame& frame) {
    using studies::PresentedState;
    return frame.panel &&
           (frame.state == PresentedState::consent || frame.state == PresentedState::instructions ||
            frame.state == PresentedState::welcome_back || frame.state == PresentedState::paused);
}

void addFootLine(renderer::Board& board, const std::string& words) {
    constexpr double line_m = 0.036;
    constexpr double letter_m = 0.45 * line_m;
    const double width_m = board.width_m - 0.08;
    const bool two_lines = letter_m * static_cast<double>(words.size()) > width_m;
    const double lines = two_lines ? 2.0 : 1.0;
    const double foot_m = board.progress >= 0.0 ? 1.1 * line_m : line_m;  // over the bar
    const double added_m = foot_m + (lines + 0.4) * line_m;
    for (auto& text : board.texts) text.box.y += added_m;
    for (auto& button : board.buttons) button.box.y += added_m;
    for (auto& field : board.fields) field.box.y += added_m;
    for (auto& slider : board.sliders) {
        slider.box.y += added_m;
        slider.track.y += added_m;
    }
    board.stage_from_board.position -= board.stage_from_board.orientation * Vec3(0.0, added_m, 0.0);
    board.height_m += added_m;
    renderer::BoardText line;
    line.box = {0.04, foot_m, width_m, lines * line_m};
    line.text = two_lines ? brokenInTheMiddle(words) : words;
    line.size_m = line_m;
    line.centred = true;
    line.faint = true;
    board.texts.push_back(line);
}

}  // namespace deixis::app
