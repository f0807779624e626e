#include "desktop_view.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/session.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/study_file/standing.hpp"

using namespace deixis;
using namespace deixis::app;
using studies::PresentedFrame;
using studies::PresentedState;

namespace {

constexpr double aspects[] = {16.0 / 9.0, 4.0 / 3.0, 16.0 / 10.0, 21.0 / 9.0, 0.66};

/// The window's camera, without a window.
class Screen {
  public:
    explicit Screen(double eye_height_m) : eye_height_m_(eye_height_m) {}

    void present(const PresentedFrame& frame) {
        if (looksAgain(frame, before_)) look_ = lookAtTask(frame, eye_height_m_);
        before_ = frame;
    }

    [[nodiscard]] Pose head() const {
        return before_.stage_from_viewer *
               Pose{Vec3(0.0, eye_height_m_, 0.0),
                    yawRotation(look_.yaw_rad) * glm::angleAxis(look_.pitch_rad, Vec3(1.0, 0.0, 0.0))};
    }

    /// How far from the middle of the picture, 1 at its edge.
    [[nodiscard]] double farthest(const Vec3& point, double aspect) const {
        const auto at = inPicture(head(), verticalView_rad(before_, aspect), aspect, point);
        return at ? std::max(std::abs(at->x), std::abs(at->y)) : 1e9;
    }

  private:
    double eye_height_m_;
    PresentedFrame before_{};
    Look look_{};
};

/// One clip for all, as long as a blink: what is looked at is boards and balls.
class BlinkClip : public studies::ClipSource {
  public:
    explicit BlinkClip(const motion::Skeleton& avatar) {
        clip_.skeleton = avatar;
        clip_.frame_time_s = 0.1;
        clip_.frames.assign(3, motion::relaxedPose(avatar));
    }
    [[nodiscard]] const motion::Clip& clip(const studies::Stimulus&) const override { return clip_; }

  private:
    motion::Clip clip_;
};

const std::vector<std::string> shipped{"pointing2023", "sgtoolkit2021", "genea-pairwise",
                                       "distractor-distance", "pointing-style"};

/// A simulated participant's session, frame by frame.
void play(const studies::Study& study, const studies::StudyPlan& plan, std::uint64_t seed,
          const std::function<void(const PresentedFrame&)>& shown) {
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::LocalPose idle = motion::relaxedPose(avatar);
    const BlinkClip clips(avatar);
    studies::SessionRunner session(study, plan, clips, avatar, idle, {}, true,
                                   study.words("station_desktop_controls"));
    studies::SimulatedParameters parameters;
    parameters.reaction_mean_s = 0.1;
    parameters.reaction_sd_s = 0.01;
    // Who overlooks a number comes to the page that ends the session.
    if (study.name == "sgtoolkit2021") parameters.attention_lapse_rate = 1.0;
    studies::SimulatedParticipant participant(parameters, avatar, seed, true);
    double time_s = 0.0;
    while (session.outcome() == studies::SessionOutcome::running) {
        REQUIRE(time_s < 4.0 * 3600.0);
        time_s += 1.0 / 20.0;
        const studies::SessionStep step = session.step(participant.act(time_s));
        shown(step.frame);
        (void)session.shown({step.frame.number, true, time_s});
        participant.see(step.frame, time_s);
    }
}

studies::StudyPlan planOf(const StudySetup& setup, int number) {
    auto plan = studies::buildPlan(setup.study, setup.targets, "P01", number,
                                   studies::assignGroups(setup.study, {}, number));
    REQUIRE(plan.has_value());
    return *plan;
}

}  // namespace

TEST_SUITE("immersive/desktop_view") {
    TEST_CASE("The ray through a point of the picture is the one on which that point is seen") {
        Random random(1, "desktop view");
        for (int i = 0; i < 1000; ++i) {
            const Pose eye{{random.uniform(-3.0, 3.0), 1.65, random.uniform(-3.0, 3.0)},
                           yawRotation(random.uniform(-3.0, 3.0)) *
                               glm::angleAxis(random.uniform(-1.3, 1.3), Vec3(1.0, 0.0, 0.0))};
            const double view_rad = random.uniform(0.5, 2.2);
            const double aspect = random.uniform(0.4, 3.0);
            const PicturePoint at{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
            const Ray ray = rayThrough(eye, view_rad, aspect, at);
            CHECK(glm::length(ray.direction) == doctest::Approx(1.0));
            const auto seen =
                inPicture(eye, view_rad, aspect, ray.origin + random.uniform(0.1, 9.0) * ray.direction);
            REQUIRE(seen.has_value());
            CHECK(seen->x == doctest::Approx(at.x));
            CHECK(seen->y == doctest::Approx(at.y));
            CHECK_FALSE(inPicture(eye, view_rad, aspect, ray.origin - ray.direction).has_value());
        }
    }

    TEST_CASE("The upper edge of a 60 degree view is 30 degrees up, its right edge as far as it is wider") {
        const Ray top = rayThrough({}, radiansFromDegrees(60.0), 16.0 / 9.0, {0.0, 1.0});
        CHECK(degreesFromRadians(std::atan2(top.direction.y, -top.direction.z)) == doctest::Approx(30.0));
        const Ray right = rayThrough({}, radiansFromDegrees(60.0), 16.0 / 9.0, {1.0, 0.0});
        CHECK(right.direction.x / -right.direction.z == doctest::Approx(16.0 / 9.0 * 0.57735).epsilon(1e-5));
    }

    TEST_CASE("A narrow window shows as much across as one of 16:9, and a wide one as much upwards") {
        const PresentedFrame frame;
        for (const double aspect : aspects) {
            CAPTURE(aspect);
            const double up = std::tan(0.5 * verticalView_rad(frame, aspect));
            CHECK(up >= doctest::Approx(0.57735).epsilon(1e-5));
            CHECK(up * aspect >= doctest::Approx(0.57735 * 16.0 / 9.0).epsilon(1e-5));
        }
        CHECK(degreesFromRadians(verticalView_rad(frame, 16.0 / 9.0)) == doctest::Approx(60.0));
        CHECK(degreesFromRadians(verticalView_rad(frame, 3.0)) == doctest::Approx(60.0));
    }

    TEST_CASE("The view goes back to the task with each page, trial and place, and after a pause") {
        const auto frame = [](PresentedState state, bool panel, const char* place = "across") {
            PresentedFrame made;
            made.state = state;
            made.viewer_place = place;
            if (panel) made.panel = studies::Panel{};
            return made;
        };
        using State = PresentedState;
        CHECK(looksAgain(frame(State::consent, true), {}));
        CHECK(looksAgain(frame(State::closing, true), frame(State::rated, true)));
        CHECK(looksAgain(frame(State::closing, true), frame(State::consent, true)));
        CHECK_FALSE(looksAgain(frame(State::consent, true), frame(State::consent, true)));
        CHECK(looksAgain(frame(State::rating, true), frame(State::paused, true)));
        CHECK(looksAgain(frame(State::comparing, true), frame(State::instructions, true)));
        CHECK(looksAgain(frame(State::watching, true), frame(State::rated, true)));
        CHECK(looksAgain(frame(State::waiting, false), frame(State::rated, true)));
        CHECK(looksAgain(frame(State::waiting, false), frame(State::chosen, false)));
        CHECK(looksAgain(frame(State::waiting, false, "side-by-side"), frame(State::waiting, false)));
        CHECK_FALSE(
            looksAgain(frame(State::waiting, true), frame(State::watching, true)));  // a clip is played
        CHECK_FALSE(looksAgain(frame(State::watching, true), frame(State::pointing, true)));
        CHECK_FALSE(looksAgain(frame(State::rating, true), frame(State::pointing, false)));
        CHECK_FALSE(looksAgain(frame(State::choosing, false), frame(State::pointing, false)));
        CHECK_FALSE(looksAgain(frame(State::rated, true), frame(State::reasons, true)));
        CHECK_FALSE(looksAgain(frame(State::playing, false), frame(State::waiting, false)));
    }

    TEST_CASE("Every full page of every study that ships is in view whole, and every button beside a task") {
        std::map<std::string, double> farthest;  // by study and state
        for (const std::string& name : shipped) {
            const auto setup = loadStudySetup(name);
            REQUIRE(setup.has_value());
            Screen screen(setup->study.eye_height_m);
            const studies::Study study = studies::standingAs(setup->study, studies::Standing::desktop);
            play(study, planOf(*setup, 1), 3, [&](const PresentedFrame& frame) {
                screen.present(frame);
                if (!frame.panel) return;
                double& worst = farthest[name + " " + presentedStateName(frame)];
                const auto see = [&](const Pose& stage_from_board, const studies::PanelRect& box) {
                    for (const double aspect : aspects)
                        for (const double x : {box.x, box.x + box.width})
                            for (const double y : {box.y, box.y + box.height})
                                worst = std::max(
                                    worst,
                                    screen.farthest(transformPoint(stage_from_board, {x, y, 0.0}), aspect));
                };
                if (isFullPage(frame.state)) {
                    see(frame.panel->stage_from_panel,
                        {0.0, 0.0, frame.panel->width_m, frame.panel->height_m});
                    return;
                }
                for (const auto& button : frame.panel->buttons)
                    see(frame.panel->stage_from_panel, button.box);
                for (const auto& slider : frame.panel->sliders)
                    see(frame.panel->stage_from_panel, slider.box);
            });
            CHECK_MESSAGE(farthest.count(name + " closing") + farthest.count(name + " instructions") > 0,
                          name);
        }
        CHECK(farthest.count("sgtoolkit2021 closing") == 1);
        CHECK(farthest.size() >= 20);
        for (const auto& seen : farthest) {
            CAPTURE(seen.first);
            CHECK(seen.second < 1.0);
        }
    }

    TEST_CASE("From first to last all balls are in view in both places, and the board that asks, whole") {
        std::set<std::string> places;
        std::set<std::string> targets;
        std::set<PresentedState> states;
        for (const char* name : {"pointing2023", "distractor-distance", "pointing-style"})
            for (int participant = 1; participant <= 4; ++participant) {
                auto setup = loadStudySetup(name);
                REQUIRE(setup.has_value());
                for (studies::Stage& stage : setup->study.stages)
                    if (stage.kind == studies::StageKind::game) stage.feedback = true;
                Screen screen(setup->study.eye_height_m);
                const studies::StudyPlan plan = planOf(*setup, participant);
                for (const studies::Trial& trial : plan.trials)
                    if (trial.kind == studies::StageKind::game) targets.insert(trial.stimuli.at(0).item);
                play(studies::standingAs(setup->study, studies::Standing::desktop), plan, 5,
                     [&](const PresentedFrame& frame) {
                         screen.present(frame);
                         if (frame.balls.empty() || isFullPage(frame.state)) return;
                         places.insert(frame.viewer_place);
                         states.insert(frame.state);
                         CAPTURE(name);
                         CAPTURE(studies::sessionStatusText(frame.status));
                         CAPTURE(presentedStateName(frame));
                         if (frame.panel)
                             for (const double x : {0.0, frame.panel->width_m})
                                 for (const double y : {0.0, frame.panel->height_m})
                                     REQUIRE(screen.farthest(
                                                 transformPoint(frame.panel->stage_from_panel, {x, y, 0.0}),
                                                 aspects[0]) < 1.0);
                         for (const auto& ball : frame.balls)
                             for (const double aspect : aspects)
                                 for (const Vec3& edge : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0),
                                                          Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
                                     REQUIRE(screen.farthest(ball.centre + ball.radius_m * edge, aspect) <
                                             1.0);
                     });
            }
        CHECK(places == std::set<std::string>{"across", "side-by-side"});
        CHECK(targets.size() > 30);
        CHECK(states.count(PresentedState::confidence) == 1);
        CHECK(states.count(PresentedState::feedback) == 1);
    }
}
