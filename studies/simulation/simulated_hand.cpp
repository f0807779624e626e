#include "simulated_hand.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double aim_s = 0.25;        ///< it aims so long before it presses
constexpr double look_s = 0.5;        ///< it looks at what it means so long before it presses
constexpr double drag_s = 0.4;        ///< it drags so long
constexpr double head_turn_s = 0.15;  ///< time constant of its head
const Vec3 hand_in_viewer{0.2, 1.15, -0.35};
const Vec3 hanging_hand_in_viewer{0.25, 0.75, -0.05};

/// Where there is something in the way, the hand is held elsewhere: the usual place first.
template <typename Try>
std::optional<Ray> fromSomewhere(const Pose& stage_from_viewer, const Try& aims) {
    for (const double aside_m : {0.0, 0.25, -0.65, 0.5, -0.9})
        for (const double raised_m : {0.0, 0.35, -0.4}) {
            const Vec3 hand =
                transformPoint(stage_from_viewer, hand_in_viewer + Vec3(aside_m, raised_m, 0.0));
            if (std::optional<Ray> ray = aims(hand)) return ray;
        }
    return std::nullopt;
}

/// True where the ray meets this ball before the others and any panel.
bool meetsFirst(const PresentedFrame& frame, const Ray& ray, std::size_t place) {
    const double own = distanceToSphere(ray, frame.balls[place].centre, frame.balls[place].radius_m);
    if (own < 0.0) return false;
    for (std::size_t i = 0; i < frame.balls.size(); ++i) {
        if (i == place) continue;
        const double other = distanceToSphere(ray, frame.balls[i].centre, frame.balls[i].radius_m);
        if (other >= 0.0 && other <= own) return false;
    }
    const auto panel = frame.panel ? meetPanel(*frame.panel, ray) : std::nullopt;
    return !panel || panel->distance_m > own;
}

bool passesBalls(const PresentedFrame& frame, const Ray& ray, double distance_m) {
    return std::none_of(frame.balls.begin(), frame.balls.end(), [&](const BallView& ball) {
        const double met = distanceToSphere(ray, ball.centre, ball.radius_m);
        return met >= 0.0 && met <= distance_m;
    });
}

Ray straight(const Pose& stage_from_viewer, const Vec3& point) {
    const Vec3 hand = transformPoint(stage_from_viewer, hand_in_viewer);
    return {hand, glm::normalize(point - hand)};
}

Quat lookRotation(const Vec3& forward) {
    const double yaw = std::atan2(-forward.x, -forward.z);
    const double pitch = std::asin(std::clamp(forward.y, -1.0, 1.0));
    return yawRotation(yaw) * Quat(std::cos(pitch / 2.0), std::sin(pitch / 2.0), 0.0, 0.0);
}

}  // namespace

Vec3 pointOnPanel(const Panel& panel, double x_m, double y_m) {
    return transformPoint(panel.stage_from_panel, {x_m, y_m, 0.0});
}

Ray restingRay(const Pose& stage_from_viewer) {
    return {transformPoint(stage_from_viewer, hanging_hand_in_viewer), -up};
}

Ray aimAtBall(const PresentedFrame& frame, std::size_t place) {
    const BallView& ball = frame.balls[place];
    const auto found = fromSomewhere(frame.stage_from_viewer, [&](const Vec3& hand) -> std::optional<Ray> {
        const Vec3 direction = glm::normalize(ball.centre - hand);
        const Vec3 right = glm::normalize(glm::cross(direction, up));
        const Vec3 above = glm::cross(right, direction);
        const double edge_m = 0.8 * ball.radius_m;
        for (const Vec3& offset :
             {Vec3(0.0), right * edge_m, right * -edge_m, above * edge_m, above * -edge_m}) {
            const Ray ray{hand, glm::normalize(ball.centre + offset - hand)};
            if (meetsFirst(frame, ray, place)) return ray;
        }
        return std::nullopt;
    });
    return found ? *found : straight(frame.stage_from_viewer, ball.centre);
}

Ray aimAtBoard(const PresentedFrame& frame, const Vec3& point) {
    const auto found = fromSomewhere(frame.stage_from_viewer, [&](const Vec3& hand) -> std::optional<Ray> {
        const Ray ray{hand, glm::normalize(point - hand)};
        if (passesBalls(frame, ray, glm::length(point - hand))) return ray;
        return std::nullopt;
    });
    return found ? *found : straight(frame.stage_from_viewer, point);
}

void SimulatedHand::press(const Ray& aim, const Vec3& meant, double at_s) {
    plan_ = Plan{aim, std::nullopt, meant, at_s};
}

void SimulatedHand::drag(const Ray& from, const Ray& to, const Vec3& meant, double at_s) {
    plan_ = Plan{from, to, meant, at_s};
}

void SimulatedHand::drop() {
    plan_.reset();
}

std::optional<Vec3> SimulatedHand::lookedAt(double time_s) const {
    if (!plan_ || time_s < plan_->press_at_s - look_s) return std::nullopt;
    return plan_->meant;
}

bool SimulatedHand::act(const Pose& stage_from_viewer, InputFrame& input) {
    if (!plan_ || input.time_s < plan_->press_at_s - aim_s) {
        input.pointer = restingRay(stage_from_viewer);
        return false;
    }
    Plan& plan = *plan_;
    input.pointer = plan.from;
    if (!plan.pressed_s) {
        if (!plan.aimed || input.time_s < plan.press_at_s) {
            plan.aimed = true;
            return false;
        }
        input.select = true;
        input.select_held = true;
        plan.pressed_s = input.time_s;
        if (plan.to) return false;
    } else {
        const double way = std::min(1.0, (input.time_s - *plan.pressed_s) / drag_s);
        input.pointer =
            Ray{plan.from.origin + way * (plan.to->origin - plan.from.origin),
                glm::normalize(plan.from.direction + way * (plan.to->direction - plan.from.direction))};
        input.select_held = !plan.arrived;
        const bool released = plan.arrived;
        plan.arrived = way >= 1.0;
        if (!released) return false;
    }
    plan_.reset();
    return true;
}

void SimulatedHead::turn(const PresentedFrame& frame, const Vec3& eyes, const Vec3& towards, double time_s) {
    const bool moved = place_ != frame.viewer_place;
    if (moved) place_ = frame.viewer_place;
    const Vec3 goal = glm::normalize(towards - eyes);
    const double turned = moved ? 1.0 : 1.0 - std::exp(-(time_s - seen_s_) / head_turn_s);
    const Vec3 next = look_ + turned * (goal - look_);
    look_ = glm::length(next) > 1e-6 ? glm::normalize(next) : goal;
    seen_s_ = time_s;
}

Quat SimulatedHead::orientation() const {
    return lookRotation(look_);
}

Vec3 placeToLook(const PresentedFrame& frame, const Vec3& eyes, int head_joint, bool reads_board) {
    const auto chest = [head_joint](const std::vector<Pose>& joints) {
        return joints[static_cast<std::size_t>(head_joint)].position - Vec3(0.0, 0.25, 0.0);
    };
    Vec3 avatar = chest(frame.avatar_joints);
    if (!frame.right_avatar_joints.empty()) avatar = (avatar + chest(frame.right_avatar_joints)) / 2.0;
    if (!frame.balls.empty()) {
        const Vec3 ahead = frame.stage_from_viewer.orientation * Vec3(0.0, 0.0, -1.0);
        const Vec3 to_avatar = glm::normalize(avatar - eyes);
        Vec3 middle(0.0);
        for (const BallView& ball : frame.balls)
            middle += ball.centre / static_cast<double>(frame.balls.size());
        // Beside the avatar, the balls; its arm is then in view anyway.
        const double avatar_share = glm::dot(to_avatar, ahead) > 0.7 ? 0.5 : 0.1;
        return eyes + avatar_share * to_avatar + (1.0 - avatar_share) * glm::normalize(middle - eyes);
    }
    if (!frame.panel) return avatar;
    const Vec3 board = pointOnPanel(*frame.panel, frame.panel->width_m / 2.0, frame.panel->height_m / 2.0);
    if (reads_board) return board;
    // Both at once, where the board is open beside who is shown.
    return eyes + 0.5 * glm::normalize(avatar - eyes) + 0.5 * glm::normalize(board - eyes);
}

}  // namespace deixis::studies
