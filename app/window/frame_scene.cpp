#include "app/window/frame_scene.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "studies/boards/panel_hit.hpp"
#include "studies/station/notice.hpp"

namespace deixis::app {

namespace {

using studies::PresentedFrame;

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
            ball.colour = glm::vec3(0.04F, 0.16F, 0.80F);
            ball.glow = glm::vec3(0.01F, 0.10F, 0.42F);
            ball.rings = 1;
            break;
        case studies::BallLook::revealed:
            ball.colour = glm::vec3(0.10F, 0.60F, 0.22F);
            ball.glow = glm::vec3(0.03F, 0.42F, 0.10F);
            ball.rings = 2;
            break;
    }
    return ball;
}

// A ray from the very eye would be seen as a point that hides what it is on: it is drawn from the hand. That
// one may cross a board where the ray does not: none is drawn then, as the mouse's own cursor shows the
// place.
std::optional<renderer::Beam> beamFrom(const PresentedFrame& frame, const Pose& stage_from_eye) {
    constexpr double at_eye_m = 0.01;
    constexpr double margin_m = 0.01;
    const Vec3 hand{0.20, -0.28, -0.20};
    const auto& [ray, length_m] = *frame.ray;
    if (glm::length(ray.origin - stage_from_eye.position) > at_eye_m) return renderer::Beam{ray, length_m};
    const Vec3 from = transformPoint(stage_from_eye, hand);
    const Vec3 way = ray.origin + length_m * ray.direction - from;
    const Ray drawn{from, glm::normalize(way)};
    const double drawn_m = glm::length(way);
    if (frame.panel) {
        const auto met = studies::meetPanel(*frame.panel, drawn);
        if (met && met->distance_m < drawn_m + margin_m) return std::nullopt;
    }
    return renderer::Beam{drawn, drawn_m};
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
    made.label_size_m = slider.label_size_m;
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

}  // namespace

renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame, const Pose& stage_from_eye) {
    renderer::Scene scene;
    scene.camera.stage_from_eye = stage_from_eye;
    if (frame.scene_visible) {
        for (const auto& ball : frame.balls) scene.balls.push_back(ballFromView(ball));
        scene.avatars.push_back(frame.avatar_joints);
        if (!frame.right_avatar_joints.empty()) scene.avatars.push_back(frame.right_avatar_joints);
    }
    if (frame.ray)
        if (const auto beam = beamFrom(frame, stage_from_eye)) scene.beams.push_back(*beam);
    if (frame.panel) scene.boards.push_back(boardFromPanel(*frame.panel));
    if (frame.sign) scene.boards.push_back(boardFromPanel(*frame.sign));
    return scene;
}

renderer::Board noticeBoard(const std::string& sentence, double line_m) {
    return boardFromPanel(studies::noticePanel(sentence, line_m));
}

void addNotice(renderer::Scene& scene, const std::string& notice) {
    if (notice.empty()) return;
    constexpr double line_m = 0.023;
    constexpr double away_m = 0.55;  // nearer than any avatar, ball or panel
    constexpr double above_m = 0.21;
    constexpr double aside_m = 0.28;
    constexpr double rings = 1.25;  // what is drawn around a ball, of its radius
    const Pose& eye = scene.camera.stage_from_eye;
    studies::Panel panel = studies::noticePanel(notice, line_m);
    const auto standAt = [&](double x, double y) {
        panel.stage_from_panel =
            eye * Pose{{x - panel.width_m / 2.0, y - panel.height_m / 2.0, -away_m}, no_rotation};
    };
    const auto hidesBall = [&] {
        return std::any_of(scene.balls.begin(), scene.balls.end(), [&](const renderer::Ball& ball) {
            return studies::overlapsBall(panel, eye.position, {ball.centre, rings * ball.radius_m});
        });
    };
    for (const double x : {0.0, -aside_m, aside_m})
        for (const double y : {above_m, -above_m}) {
            standAt(x, y);
            if (hidesBall()) continue;
            scene.boards.push_back(boardFromPanel(panel));
            return;
        }
    standAt(0.0, above_m);
    scene.boards.push_back(boardFromPanel(panel));
}

}  // namespace deixis::app
