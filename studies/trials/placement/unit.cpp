// Free placement: the participant takes the ball with the ray, puts it where they believe that the avatar
// points, and confirms. Wheel, key or thumbstick move it along the ray.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "studies/design/angles.hpp"
#include "studies/design/visibility.hpp"
#include "studies/session/replay.hpp"
#include "timed_trial.hpp"

namespace deixis::studies {

namespace {

constexpr double target_shown_s = 1.5;
constexpr double nearest_on_ray_m = 0.3;  ///< along the ray
constexpr double farthest_on_ray_m = 5.0;
constexpr double really_moved_m = 0.01;  ///< more than a click shakes a hand
/// Where the ball waits: beside the participant's right hand, nearer than any target, so that it tells none.
const Vec3 rest_in_viewer{0.5, 1.0, -0.8};
/// What a flat screen is to hold beside it: the arm as it points ahead, and so nothing of the target.
const Vec3 arm_ahead{0.0, 1.1, 1.6};

Vec3 onStoredGrid(const Vec3& point) {
    return {std::round(point.x * 1e4) / 1e4, std::round(point.y * 1e4) / 1e4,
            std::round(point.z * 1e4) / 1e4};
}

class PlacementTrial : public TimedTrial {
  public:
    PlacementTrial(SessionCore& core, const TimelineItem& item) : TimedTrial(core, item, target_shown_s) {}

    void enter(const InputFrame& input, bool moved) override {
        PresentedFrame& frame = core_.view.frame;
        frame.balls.push_back({rest(), core_.study.targets.ball_diameter_m / 2.0, BallLook::waiting});
        const Sphere ball{rest(), frame.balls[0].radius_m};
        std::vector<Sphere> seen = pointingScene({{arm_ahead, ball.radius_m}}, core_.avatar, core_.idle);
        seen.push_back(ball);
        frame.first_look = firstLook(frame.stage_from_viewer, core_.study.eye_height_m, seen);
        ClipTrial::enter(input, moved);
    }

    [[nodiscard]] std::string notice() const override {
        if (revealed_) return {};
        return limit_.notice(core_.words(), done_, late());
    }

  private:
    bool held_ = false;
    bool moved_ = false;    ///< it has been put somewhere: there is something to confirm
    double along_m_ = 0.0;  ///< the ray, while it is held
    Vec3 taken_from_{0.0};

    [[nodiscard]] Vec3 rest() const {
        return transformPoint(core_.view.frame.stage_from_viewer, rest_in_viewer);
    }
    [[nodiscard]] BallView& ball() { return core_.view.frame.balls.at(0); }

    void forgetAnswer() override {
        held_ = moved_ = false;
        ball().centre = rest();
    }

    void openAnswer(const InputFrame& input) override {
        held_ = false;
        beginAiming();
        core_.openPanel(board(), input, besideBall());
        core_.view.openBalls();
        core_.view.aim(input.pointer, input.stage_from_head, true);
    }

    /// Where the board hides neither the ball nor where it waits.
    [[nodiscard]] PanelPlace besideBall() {
        const BallView waiting{rest(), ball().radius_m, BallLook::waiting};
        return [balls = std::vector{ball(), waiting}](const Panel& panel, const Pose& viewer, double eye_m) {
            return deskPoseBesideBalls(panel, viewer, eye_m, balls);
        };
    }

    [[nodiscard]] Panel board() const {
        std::vector<ButtonSpec> buttons{
            {core_.words()("confirm"), button_id::go_on, ButtonRole::go_on, moved_}};
        if (const auto again = replayButton()) buttons.push_back(*again);
        return messagePanel("", task_.question, "", buttons, -1.0);
    }

    void stepAnswer(const InputFrame& input) override {
        if (held_) {
            carry(input);
            watchTime(input);
            return;
        }
        const Aim met = aimAtBalls(input);
        if (!gate_.accepts()) return;
        const bool selected = select(input);
        if (selected && met.button == button_id::replay) {
            limit_.forget();
            replay();
        } else if (selected && met.ball >= 0) {
            take(input);
        } else if (moved_ && selected && met.button == button_id::go_on && inTime(selectTime(input))) {
            confirm(input, selectTime(input), "ray");
        } else if (moved_ && input.confirm && gate_.admitsKey(input) && inTime(keyTime(input))) {
            confirm(input, keyTime(input), "key");
        } else {
            watchTime(input);
        }
    }

    /// The ball is on the ray from here on.
    void take(const InputFrame& input) {
        held_ = true;
        taken_from_ = ball().centre;
        along_m_ = glm::dot(ball().centre - input.pointer->origin, input.pointer->direction);
        showState(PresentedState::aiming);
    }

    void carry(const InputFrame& input) {
        along_m_ = std::clamp(along_m_ + input.farther_m, nearest_on_ray_m, farthest_on_ray_m);
        core_.view.frame.ray.reset();
        if (input.pointer) {
            Vec3 at = input.pointer->origin + along_m_ * input.pointer->direction;
            at.y = std::max(at.y, ball().radius_m);  // not into the floor
            ball().centre = onStoredGrid(at);
            core_.view.frame.ray = RayView{*input.pointer, along_m_};
        }
        core_.view.lookAtBalls(BallLook::hovered);
        moved_ = moved_ || glm::length(ball().centre - taken_from_) >= really_moved_m;
        if (input.select_held) return;
        held_ = false;
        core_.openPanel(board(), input, besideBall());  // it could not be taken again from behind the board
        core_.view.admitRestingRay();                   // which was aimed there
    }

    void confirm(const InputFrame& input, double at_s, const char* by) {
        const Vec3 at = ball().centre;
        const double distance_cm = std::round(glm::length(at - trial_.target) * 1e4) / 1e2;
        const double angle_deg = angleSeen_deg(StandingAvatar::reference().eyes(), trial_.target, at);
        limit_.forget();
        give(input, at_s, by);
        draft_.values = {{"placed_x_m", at.x, {}}, {"placed_y_m", at.y, {}}, {"placed_z_m", at.z, {}}};
        draft_.answers = {{"distance", 0, distance_cm, {}}, {"angle", 0, angle_deg, {}}};
        core_.view.confirmButton(button_id::go_on);
        finish();
    }

    void showDone() override {
        PresentedFrame& frame = core_.view.frame;
        const bool placed = draft_.status == ResponseStatus::answered;
        showState(revealed_ ? PresentedState::feedback
                  : placed  ? PresentedState::chosen
                            : PresentedState::waiting);
        core_.view.lookAtBalls(BallLook::waiting, placed ? 0 : -1, BallLook::chosen);
        if (!revealed_) return;
        core_.view.closePanel();
        if (frame.balls.size() < 2)
            frame.balls.push_back({trial_.target, ball().radius_m, BallLook::revealed});
        frame.balls[1].look = BallLook::revealed;
    }
};

CheckResult comparePlacements(const TrialAnswer& first, const TrialAnswer& now, double tolerance) {
    const auto at = [](const TrialAnswer& given) {
        const auto of = [&](const char* name) {
            return keptNumber(given.response.values, name).value_or(0.0);
        };
        return Vec3(of("placed_x_m"), of("placed_y_m"), of("placed_z_m"));
    };
    const double apart_cm = 100.0 * glm::length(at(now) - at(first));
    return {apart_cm <= tolerance, fmt::format("repeat: {:.1f} cm from the first place", apart_cm)};
}

/// The ball where it waited, and once it was confirmed where it was put; its way there is not kept.
std::vector<BallView> replayedPlacement(const RecordedTrial& recorded, double time_s) {
    const auto x = keptNumber(recorded.values, "placed_x_m"), y = keptNumber(recorded.values, "placed_y_m"),
               z = keptNumber(recorded.values, "placed_z_m");
    BallView ball{transformPoint(viewerPose(recorded.layout), rest_in_viewer),
                  recorded.ball_diameter_m / 2.0};
    if (time_s >= recorded.open_s) ball.look = BallLook::selectable;
    if (time_s >= recorded.answered_s && x && y && z) {
        ball.centre = {*x, *y, *z};
        ball.look = BallLook::chosen;
    }
    return {ball};
}

}  // namespace

extern const UnitDeclaration placement_unit{makeUnitOf<PlacementTrial>, comparePlacements, replayedPlacement};

}  // namespace deixis::studies
