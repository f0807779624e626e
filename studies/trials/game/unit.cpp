// The referential game: which ball does the avatar point at? (Deichler et al. 2023, section 2.4.2.) After the
// choice a study may ask how sure the participant is, and show the target.
#include <fmt/core.h>

#include <vector>

#include "scale_answer.hpp"
#include "timed_trial.hpp"

namespace deixis::studies {

namespace {

constexpr double feedback_s = 1.0;

class GameTrial : public TimedTrial {
  public:
    GameTrial(SessionCore& core, const TimelineItem& item) : TimedTrial(core, item, feedback_s) {
        if (task_.confidence) confidence_.emplace(core, task_.confidence->text, task_.confidence->scale);
    }

    void enter(const InputFrame& input, bool moved) override {
        const double radius_m = core_.study.targets.ball_diameter_m / 2.0;
        for (std::size_t place = 0; place < trial_.ball_order.size(); ++place)
            core_.view.frame.balls.push_back(
                {trial_.ball(static_cast<int>(place)), radius_m, BallLook::waiting});
        lookAtTask();
        ClipTrial::enter(input, moved);
    }

    [[nodiscard]] std::string notice() const override {
        if (revealed_ && !late())
            return core_.words()(draft_.correct() ? "feedback_correct" : "feedback_wrong");
        return limit_.notice(core_.words(), done_, late());
    }

  private:
    bool chosen_ = false;
    std::optional<ScaleAnswer> confidence_{};

    [[nodiscard]] bool committed() const override { return chosen_; }

    /// What a flat screen is to hold now: the balls, and the arm that points or the board that asks.
    void lookAtTask() {
        PresentedFrame& frame = core_.view.frame;
        std::vector<Sphere> seen;
        for (const BallView& ball : frame.balls) seen.push_back({ball.centre, ball.radius_m});
        if (frame.panel) {
            const std::vector<Sphere> corners = panelCorners(*frame.panel);
            seen.insert(seen.end(), corners.begin(), corners.end());
        } else {
            seen = pointingScene(seen, core_.avatar, core_.idle);
        }
        frame.first_look = firstLook(frame.stage_from_viewer, core_.study.eye_height_m, seen);
    }
    void forgetAnswer() override {
        if (confidence_) confidence_->forget();
    }

    void openAnswer(const InputFrame& input) override {
        if (chosen_) {
            openConfidence(input);
            return;
        }
        beginAiming();
        if (const auto again = replayButton())
            core_.openPanel(gamePanel(task_.question, again), input, besideBalls());
        else
            core_.view.closePanel();
        lookAtTask();
        core_.view.openBalls();
        core_.view.aim(input.pointer, input.stage_from_head, true);
    }

    [[nodiscard]] PanelPlace besideBalls() const {
        return [balls = core_.view.frame.balls](const Panel& panel, const Pose& viewer, double eye_m) {
            return deskPoseBesideBalls(panel, viewer, eye_m, balls);
        };
    }

    void stepAnswer(const InputFrame& input) override {
        if (chosen_) {
            stepConfidence(input);
            return;
        }
        const Aim met = aimAtBalls(input);
        if (!gate_.accepts()) return;
        const bool selected = select(input);
        if (selected && met.button == button_id::replay) {
            limit_.forget();
            replay();
        } else if (selected && met.ball >= 0 && inTime(selectTime(input))) {
            choose(input, met.ball);
        } else {
            watchTime(input);
        }
    }

    void choose(const InputFrame& input, int place) {
        draft_.values = {{"chosen_place", place, {}},
                         {"correct", place == trial_.targetPlace() ? 1.0 : 0.0, {}}};
        chosen_ = true;
        limit_.forget();
        give(input, selectTime(input), "ray");
        if (confidence_)
            reopenAnswer(input);
        else
            finish();
    }

    void openConfidence(const InputFrame& input) {
        showState(PresentedState::confidence);
        core_.view.lookAtBalls(BallLook::waiting, draft_.chosenPlace(), BallLook::chosen);
        confidence_->open(
            input, std::nullopt,
            [balls = core_.view.frame.balls](const Panel& panel, const Pose& viewer, double eye_m) {
                return poseBesideBalls(panel, viewer, eye_m, balls)
                    .value_or(lecternPose(panel, viewer, eye_m));
            });
        lookAtTask();
        core_.view.aim(input.pointer, input.stage_from_head, false);
    }

    void stepConfidence(const InputFrame& input) {
        const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
        if (!core_.settled()) return;
        const bool selected = input.select && gate_.admitsSelect(input);
        const auto given = confidence_->step(input, met, gate_, selected);
        if (!given) return;
        draft_.answers.push_back({"confidence", -1, static_cast<double>(given->value), {}});
        confidence_->confirm(given->value);
        finish();
    }

    void showDone() override {
        const bool chosen = draft_.chosenPlace() >= 0;
        showState(revealed_ ? PresentedState::feedback
                  : chosen  ? PresentedState::chosen
                            : PresentedState::waiting);
        core_.view.lookAtBalls(chosen && !confidence_ ? BallLook::selectable : BallLook::waiting,
                               draft_.chosenPlace(), BallLook::chosen);
        if (!revealed_) return;
        core_.view.closePanel();
        lookAtTask();
        PresentedFrame& frame = core_.view.frame;
        frame.balls[static_cast<std::size_t>(trial_.targetPlace())].look = BallLook::revealed;
    }
};

/// Which ball was chosen, whatever its place.
int ballOf(const TrialAnswer& given) {
    const int place = given.response.chosenPlace();
    return place < 0 ? -1 : given.trial.ball_order.at(static_cast<std::size_t>(place));
}

CheckResult compareChoice(const TrialAnswer& first, const TrialAnswer& now, double /*tolerance*/) {
    const int before = ballOf(first);
    const int again = ballOf(now);
    return {before == again, fmt::format("repeat: ball {} first, {} now", before, again)};
}

}  // namespace

extern const UnitDeclaration game_unit{makeUnitOf<GameTrial>, compareChoice};

}  // namespace deixis::studies
