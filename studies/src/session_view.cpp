#include "session_view.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace deixis::studies {

namespace {

constexpr double ray_length_m = 5.0;                    // of a ray that meets nothing
constexpr double sight_rad = radiansFromDegrees(60.0);  // off the looking direction: farther, nothing is seen

double distanceToFloor(const Ray& ray) {
    if (ray.direction.y >= 0.0 || ray.origin.y <= 0.0) return ray_length_m;
    return std::min(ray_length_m, -ray.origin.y / ray.direction.y);
}

bool sees(const Pose& stage_from_head, const Vec3& point) {
    const Vec3 looking = stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
    return angleBetween(looking, point - stage_from_head.position) <= sight_rad;
}

}  // namespace

void SessionView::beginFrame() {
    ++frame.number;
    frame.key_moment = false;
    frame.tick = false;
    met_before_ = std::exchange(met_, {});
}

bool SessionView::place(const Layout& layout) {
    if (frame.viewer_place == layout.name) return false;
    frame.viewer_place = layout.name;
    // The viewer looks along -z, a heading is where +z would turn to: half a turn apart.
    frame.stage_from_viewer = {{layout.viewer_x_m, 0.0, layout.viewer_z_m},
                               yawRotation(radiansFromDegrees(layout.heading_deg) + pi)};
    frame.key_moment = true;
    return true;
}

void SessionView::openPanel(Panel panel, double eye_height_m, PanelPlace stand) {
    panel.stage_from_panel = stand(panel, frame.stage_from_viewer, eye_height_m);
    frame.panel = std::move(panel);
    frame.key_moment = true;
    met_ = {};  // its buttons are others, also where their ids are the same
}

void SessionView::closePanel() {
    frame.key_moment = frame.key_moment || frame.panel.has_value();
    frame.panel.reset();
    frame.ray.reset();
}

void SessionView::lookAtBalls(BallLook all, int place, BallLook one) {
    for (std::size_t i = 0; i < frame.balls.size(); ++i) {
        const BallLook look = static_cast<int>(i) == place ? one : all;
        frame.key_moment = frame.key_moment || frame.balls[i].look != look;
        frame.balls[i].look = look;
    }
}

Aim SessionView::aim(const std::optional<Ray>& pointer, const Pose& stage_from_head, bool at_balls) {
    Aim met;
    int button = -1;
    frame.ray.reset();
    if (pointer) {
        double length_m = distanceToFloor(*pointer);
        const auto hit = frame.panel ? meetPanel(*frame.panel, *pointer) : std::nullopt;
        if (hit && hit->distance_m < length_m) {
            length_m = hit->distance_m;
            button = hit->button;
        }
        for (std::size_t i = 0; at_balls && i < frame.balls.size(); ++i) {
            const BallView& ball = frame.balls[i];
            const double distance_m = distanceToSphere(*pointer, ball.centre, ball.radius_m);
            if (distance_m < 0.0 || distance_m >= length_m) continue;
            length_m = distance_m;
            met.ball = static_cast<int>(i);
            button = -1;
        }
        frame.ray = RayView{*pointer, length_m};
        if (!sees(stage_from_head, pointer->origin + length_m * pointer->direction)) {
            met.ball = -1;
            button = -1;
        }
    }
    for (std::size_t i = 0; frame.panel && i < frame.panel->buttons.size(); ++i) {
        PanelButton& one = frame.panel->buttons[i];
        const bool hovered = static_cast<int>(i) == button;
        frame.key_moment = frame.key_moment || one.hovered != hovered;
        one.hovered = hovered;
        if (hovered) met.button = one.id;
    }
    if (at_balls) lookAtBalls(BallLook::selectable, met.ball, BallLook::hovered);
    met_ = met;
    frame.tick = met != Aim{} && met != met_before_;
    return met;
}

void SessionView::confirmButton(int id) {
    frame.key_moment = true;
    frame.ray.reset();
    for (std::size_t i = 0; frame.panel && i < frame.panel->buttons.size(); ++i) {
        PanelButton& one = frame.panel->buttons[i];
        one.enabled = false;
        one.hovered = one.id == id;
    }
}

void SessionView::notice(std::string_view sentence) {
    if (frame.notice == sentence) return;
    frame.notice = sentence;
    frame.key_moment = true;
}

}  // namespace deixis::studies
