#include "studies/simulated_participant.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "core/files.hpp"
#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct Answers {
    std::vector<int> given;  ///< rating or place, in order
    std::vector<double> times_s;
    int correct = 0;
    bool finished = false;

    bool operator==(const Answers&) const = default;
};

Answers simulate(const Driver& driver, const StudyPlan& plan, std::uint64_t seed) {
    SimulatedStation station({}, driver.avatar, seed);
    SessionRunner session(driver.study, plan, driver.clips, driver.avatar, driver.idle, {});
    Answers answers;
    const auto keep = [&answers](const std::vector<SessionEvent>& events) {
        for (const SessionEvent& event : events) {
            const auto* response = std::get_if<Response>(&event);
            if (response == nullptr) continue;
            answers.given.push_back(response->rating > 0 ? response->rating : response->chosen_place);
            answers.times_s.push_back(response->response_time_s);
            if (response->correct) ++answers.correct;
        }
    };
    for (int i = 0; i < 20000 && !session.finished(); ++i) {
        const SessionStep step = session.step(station.beginFrame());
        keep(step.events);
        keep(session.shown(station.present(step.frame)));
    }
    answers.finished = session.finished();
    return answers;
}

/// The same balls at the same places in every trial, but another of them is the target.
StudyPlan withOtherTargets(StudyPlan plan) {
    for (Trial& trial : plan.trials) {
        if (trial.stage != StageKind::game) continue;
        std::swap(trial.target, trial.distractors[0]);
        for (int& ball : trial.ball_order) ball = ball == 0 ? 1 : ball == 1 ? 0 : ball;
    }
    return plan;
}

std::filesystem::path writeParameters(const std::string& name, const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / ("deixis_" + name + ".toml");
    REQUIRE(writeFile(path, text).has_value());
    return path;
}

}  // namespace

TEST_SUITE("studies/simulated_participant") {
    TEST_CASE("it goes through a whole session by itself and answers every trial") {
        const Driver driver(3);
        const Answers answers = simulate(driver, driver.plan, 1);
        CHECK(answers.finished);
        CHECK(answers.given.size() == 12);
        for (const double time_s : answers.times_s) {
            CHECK(time_s > 0.2);
            CHECK(time_s < 4.0);
        }
    }

    TEST_CASE(
        "it always holds a pointer, looks at what it presses, and is never early, lost or off its place") {
        for (const char* const rated_from : {"across", "side-by-side"}) {
            CAPTURE(rated_from);
            Driver driver(3);
            driver.study.layouts[1] = {"side-by-side", -0.6, -0.95, 15.0};
            for (Trial& trial : driver.plan.trials)
                if (trial.stage == StageKind::naturalness) trial.layout = rated_from;
            int presses = 0;
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                CAPTURE(seed);
                SimulatedStation station({}, driver.avatar, seed);
                SessionRunner session(driver.study, driver.plan, driver.clips, driver.avatar, driver.idle,
                                      {});
                std::optional<RayView> shown_ray;
                for (int i = 0; i < 20000 && !session.finished(); ++i) {
                    const InputFrame input = station.beginFrame();
                    REQUIRE(input.pointer.has_value());
                    if (input.select) {
                        ++presses;
                        REQUIRE(shown_ray.has_value());
                        const Vec3 met =
                            shown_ray->ray.origin + shown_ray->length_m * shown_ray->ray.direction;
                        const Vec3 looking = input.stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
                        CHECK(angleBetween(looking, met - input.stage_from_head.position) <
                              radiansFromDegrees(15.0));
                    }
                    const SessionStep step = session.step(input);
                    driver.keep(step.events);
                    CHECK(step.frame.notice.empty());
                    shown_ray = step.frame.ray;
                    driver.keep(session.shown(station.present(step.frame)));
                }
                CHECK(session.finished());
            }
            CHECK(presses >= 5 * 14);
            for (const char* const kind : {"early_select", "pointer_lost", "off_place", "pause"})
                CHECK(driver.count(kind) == 0);
        }
    }

    TEST_CASE("the same seed gives the same answers at the same times, another seed others") {
        const Driver driver(4);
        const Answers first = simulate(driver, driver.plan, 11);
        CHECK(first == simulate(driver, driver.plan, 11));
        CHECK_FALSE(first == simulate(driver, driver.plan, 12));
    }

    TEST_CASE("it does not know the answer: with another ball as the target it chooses the same places") {
        const Driver driver(6);
        const StudyPlan other = withOtherTargets(driver.plan);
        int correct = 0;
        int correct_other = 0;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            const Answers answers = simulate(driver, driver.plan, seed);
            const Answers same = simulate(driver, other, seed);
            CHECK(answers.given == same.given);
            CHECK(answers.times_s == same.times_s);
            correct += answers.correct;
            correct_other += same.correct;
        }
        CHECK(correct != correct_other);
    }

    TEST_CASE("its ray meets the chosen ball first, also where another stands in front of it") {
        const Driver driver(1);
        PresentedFrame frame;
        frame.avatar_joints = motion::worldPose(driver.avatar, driver.idle);
        frame.stage_from_viewer = {{0.0, 0.0, 3.4}, no_rotation};
        frame.viewer_place = "across";
        // From the hand's place, the first ball stands exactly behind the second and the third just beside.
        const Vec3 hand(0.2, 1.15, 3.05);
        const Vec3 direction = glm::normalize(Vec3(-0.3, 0.05, -1.0));
        frame.balls = {{hand + 1.6 * direction, 0.05, BallLook::waiting},
                       {hand + 1.2 * direction, 0.05, BallLook::waiting},
                       {hand + 1.2 * direction + Vec3(0.1, 0.0, 0.0), 0.05, BallLook::waiting}};
        SimulatedParameters parameters;
        parameters.lapse_rate = 1.0;
        std::array<int, 3> chosen{0, 0, 0};
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            SimulatedParticipant participant(parameters, driver.avatar, seed);
            for (BallView& ball : frame.balls) ball.look = BallLook::waiting;
            participant.see(frame, 0.0);
            for (BallView& ball : frame.balls) ball.look = BallLook::selectable;
            std::optional<Ray> before;
            bool selected = false;
            for (int i = 1; i < 300 && !selected; ++i) {
                const InputFrame input = participant.act(i / 30.0);
                if (input.select) {
                    selected = true;
                    REQUIRE(input.pointer.has_value());
                    REQUIRE(before.has_value());
                    CHECK(glm::length(before->direction - input.pointer->direction) < 1e-12);
                    std::size_t met = 3;
                    double nearest_m = 1e9;
                    for (std::size_t place = 0; place < 3; ++place) {
                        const double distance_m =
                            distanceToSphere(*input.pointer, frame.balls[place].centre, 0.05);
                        if (distance_m < 0.0 || distance_m >= nearest_m) continue;
                        nearest_m = distance_m;
                        met = place;
                    }
                    REQUIRE(met < 3);
                    ++chosen[met];
                }
                before = input.pointer;
                participant.see(frame, i / 30.0);
            }
            CHECK(selected);
        }
        // Random places: were the hidden ball out of reach, its share would go to the one in front.
        for (const int times : chosen) CHECK(times >= 6);
    }

    TEST_CASE("the parameters that ship are the defaults") {
        const auto read = loadSimulatedParameters(std::filesystem::path(DEIXIS_SOURCE_DIR) /
                                                  "assets/data/simulated_participant.toml");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        const SimulatedParameters defaults;
        CHECK(read->pointing_ray == defaults.pointing_ray);
        const auto numbers = [](const SimulatedParameters& p) {
            return std::vector<double>{p.pointing_noise_deg,
                                       p.pointing_noise_between,
                                       p.lapse_rate,
                                       p.rating_base,
                                       p.rating_profile_weight,
                                       p.rating_participation_weight,
                                       p.rating_steadiness_weight,
                                       p.profile_abrupt,
                                       p.profile_smooth,
                                       p.participation_deg,
                                       p.steady_speed_m_s,
                                       p.unsteady_speed_m_s,
                                       p.rating_bias_between,
                                       p.rating_noise_within,
                                       p.reaction_mean_s,
                                       p.reaction_sd_s,
                                       p.eye_height_m,
                                       p.frame_rate_hz};
        };
        CHECK(numbers(*read) == numbers(defaults));
    }

    TEST_CASE("a parameter file with an unknown ray or key, or a missing one, is refused with line and key") {
        const auto shipped =
            readFile(std::filesystem::path(DEIXIS_SOURCE_DIR) / "assets/data/simulated_participant.toml");
        REQUIRE(shipped.has_value());
        const auto changed = [&](const std::string& from, const std::string& to) {
            std::string text = *shipped;
            REQUIRE(text.find(from) != std::string::npos);
            text.replace(text.find(from), from.size(), to);
            const auto read = loadSimulatedParameters(writeParameters("parameters", text));
            REQUIRE_FALSE(read.has_value());
            return read.error().text();
        };
        const std::string ray = changed("\"eye-fingertip\"", "\"nose\"");
        CHECK(ray.find("pointing.ray") != std::string::npos);
        CHECK(ray.find("nose") != std::string::npos);
        CHECK(ray.find(".toml:10") != std::string::npos);
        CHECK(changed("lapse_rate", "lapses").find("lapse_rate") != std::string::npos);
        CHECK(changed("profile_smooth = 1.4", "profile_smooth = 1.0").find("profile_abrupt") !=
              std::string::npos);
        CHECK(changed("[station]", "[stations]").find("station") != std::string::npos);
        CHECK_FALSE(loadSimulatedParameters("/no/such/file.toml").has_value());
    }
}
