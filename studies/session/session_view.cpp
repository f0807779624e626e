#include "session_view.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "ball_met.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::studies {

namespace {

constexpr double sight_rad = radiansFromDegrees(60.0);  // off the looking direction: farther, nothing is seen

double distanceToFloor(const Ray& ray) {
    if (ray.direction.y >= 0.0 || ray.origin.y <= 0.0) return std::numeric_limits<double>::infinity();
    return -ray.origin.y / ray.direction.y;
}

bool sees(const Pose& stage_from_head, const Vec3& point) {
    const Vec3 looking = stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
    return angleBetween(looking, point - stage_from_head.position) <= sight_rad;
}

}  // namespace

void SessionView::beginFrame() {
    ++frame.number;
    frame.tick = false;
    frame.sound.reset();
    met_before_ = std::exchange(met_, {});
    onset_.beginFrame();
}

void SessionView::show(PresentedState state, bool in_game) {
    frame.state = state;
    frame.in_game = in_game;
}

bool SessionView::place(const Layout& layout) {
    if (frame.viewer_place == layout.name) return false;
    frame.viewer_place = layout.name;
    frame.stage_from_viewer = viewerPose(layout);
    return true;
}

void SessionView::openPanel(Panel panel, double eye_height_m, PanelPlace stand) {
    eye_height_m_ = eye_height_m;
    stand_ = std::move(stand);
    met_ = {};  // its buttons are others, also where their ids are the same
    grabbed_ = 0;
    onset_.open();
    ++frame.board;
    updatePanel(std::move(panel));
}

void SessionView::updatePanel(Panel panel) {
    panel.stage_from_panel = stand_(panel, frame.stage_from_viewer, eye_height_m_);
    frame.panel = std::move(panel);
    lightUp(met_);
}

void SessionView::closePanel() {
    frame.panel.reset();
    frame.ray.reset();
    grabbed_ = 0;
}

void SessionView::showSign(const std::string& sentence, const std::string& large, const Vec3& avatar_head,
                           const Vec3& eyes) {
    Panel sign = signPanel(sentence, large);
    sign.stage_from_panel = signPose(sign, avatar_head, eyes);
    frame.sign = std::move(sign);
}

void SessionView::closeSign() {
    frame.sign.reset();
}

void SessionView::lookAtBalls(BallLook all, int place, BallLook one) {
    for (std::size_t i = 0; i < frame.balls.size(); ++i)
        frame.balls[i].look = static_cast<int>(i) == place ? one : all;
}

Aim SessionView::aim(const std::optional<Ray>& pointer, const Pose& stage_from_head, bool at_balls) {
    Aim met;
    frame.ray.reset();
    if (pointer) {
        double reach_m = distanceToFloor(*pointer);
        double length_m = std::min(reach_m, free_ray_m);
        const auto hit = frame.panel ? meetPanel(*frame.panel, *pointer) : std::nullopt;
        if (hit && hit->distance_m < reach_m) {
            reach_m = length_m = hit->distance_m;
            const auto idOf = [](const auto& parts, int index) {
                return index < 0 ? 0 : parts[static_cast<std::size_t>(index)].id;
            };
            met.button = idOf(frame.panel->buttons, hit->button);
            met.slider = idOf(frame.panel->sliders, hit->slider);
            met.field = idOf(frame.panel->fields, hit->field);
        }
        const BallMet ball = at_balls ? nearestBall(frame.balls, *pointer, reach_m) : BallMet{};
        if (ball.place >= 0) {
            length_m = ball.distance_m;
            met = {};
            met.ball = ball.place;
        }
        frame.ray = RayView{*pointer, length_m};
        if (!sees(stage_from_head, pointer->origin + length_m * pointer->direction)) met = {};
    }
    met = onset_.admit(met, pointer);
    lightUp(met);
    if (at_balls) lookAtBalls(BallLook::selectable, met.ball, BallLook::hovered);
    met_ = met;
    frame.tick = met != Aim{} && met != met_before_;
    return met;
}

void SessionView::lightUp(const Aim& met) {
    if (!frame.panel) return;
    const auto light = [](auto& parts, int id) {
        for (auto& one : parts) one.hovered = id != 0 && one.id == id && one.enabled;
    };
    light(frame.panel->buttons, met.button);
    light(frame.panel->sliders, met.slider);
    light(frame.panel->fields, met.field);
}

std::optional<SliderSet> SessionView::drag(const InputFrame& input, const Aim& met, bool pressed) {
    if (pressed) grabbed_ = met.slider;
    if (!pressed && !input.select_held) grabbed_ = 0;
    if (grabbed_ == 0 || !frame.panel || !input.pointer) return std::nullopt;
    const Panel& panel = *frame.panel;
    const auto x_m = alongPanel(panel, *input.pointer);
    if (!x_m) return std::nullopt;
    for (PanelSlider& slider : frame.panel->sliders) {
        if (slider.id != grabbed_) continue;
        const PanelRect track = slider.track();
        const Vec3 there = transformPoint(panel.stage_from_panel, {*x_m, track.y, 0.0});
        if (!slider.enabled || !sees(input.stage_from_head, there)) return std::nullopt;
        const int value = slider.valueAt(*x_m);
        slider.value = value;
        return SliderSet{slider.id, value};
    }
    return std::nullopt;
}

void SessionView::confirmButton(int id) {
    frame.ray.reset();
    for (std::size_t i = 0; frame.panel && i < frame.panel->buttons.size(); ++i) {
        PanelButton& one = frame.panel->buttons[i];
        one.enabled = false;
        one.hovered = false;
        one.chosen = one.chosen || one.id == id;
    }
    for (std::size_t i = 0; frame.panel && i < frame.panel->sliders.size(); ++i)
        frame.panel->sliders[i].enabled = false;
    grabbed_ = 0;
}

void SessionView::notice(std::string_view sentence) {
    if (frame.notice == sentence) return;
    frame.notice = sentence;
}

}  // namespace deixis::studies
