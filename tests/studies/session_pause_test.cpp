#include <doctest/doctest.h>

#include <map>

#include "core/random.hpp"
#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Everything that a hand could do by chance: aims at buttons, balls and nothing, keys, pauses.
InputFrame anything(const PresentedFrame& frame, Random& random) {
    InputFrame input;
    const double dice = random.uniform();
    Vec3 aim(random.uniform(-3.0, 3.0), random.uniform(0.0, 2.0), random.uniform(-3.0, 3.0));
    if (dice < 0.5 && frame.panel && !frame.panel->buttons.empty())
        aim = buttonCentre(*frame.panel, frame.panel->buttons[random.below(frame.panel->buttons.size())].id);
    else if (dice < 0.8 && !frame.balls.empty())
        aim = frame.balls[random.below(frame.balls.size())].centre;
    if (random.uniform() < 0.9) input.pointer = lookAt(frame, aim);
    input.select = random.uniform() < 0.4;
    input.confirm = random.uniform() < 0.1;
    if (random.uniform() < 0.1) input.digit = static_cast<int>(1 + random.below(9));
    if (random.uniform() < 0.01) input.pause = true;
    if (random.uniform() < 0.001) input.quit = true;
    return input;
}

}  // namespace

TEST_SUITE("studies/session_pause") {
    TEST_CASE("a pause while the clip plays starts it over and is counted") {
        Driver driver(1, 1.0, false);
        driver.start();
        driver.leavePage();
        driver.leavePage();
        REQUIRE(driver.waitUntil([&] { return driver.count(NoteKind::stimulus_onset) == 1; }));
        driver.wait(0.5);
        driver.step(pauseFor(PauseReason::focus_lost));
        REQUIRE(hasButton(driver.frame, button_id::resume));
        CHECK(driver.last(NoteKind::pause).detail == "focus lost");
        CHECK(driver.last(NoteKind::pause).trial_index == 0);
        const auto frozen = driver.frame.avatar_joints;
        driver.wait(3.0);
        CHECK(driver.frame.avatar_joints.back().position == frozen.back().position);
        CHECK(driver.count(NoteKind::motion_end) == 0);
        driver.press(button_id::resume);
        CHECK(driver.count(NoteKind::resume) == 1);
        REQUIRE(driver.toAnswer());
        CHECK(driver.count(NoteKind::stimulus_onset) == 2);
        driver.press(button_id::first_rating);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].pauses == 1);
        CHECK(driver.responses[0].onset.time_s == driver.last(NoteKind::stimulus_onset).at.time_s);
        const double played_s = driver.responses[0].motion_end.time_s - driver.responses[0].onset.time_s;
        CHECK(played_s == doctest::Approx(1.0).epsilon(0.04));
    }

    TEST_CASE("a session whose very first frame is paused shows the avatar and goes on") {
        Driver driver(1, 1.0, false);
        driver.start();
        driver.step(pauseFor(PauseReason::focus_lost));
        CHECK(driver.frame.avatar_joints.size() > 0);
        REQUIRE(hasButton(driver.frame, button_id::resume));
        driver.wait(1.0);
        driver.press(button_id::resume);
        CHECK(driver.state() == "instructions");
    }

    TEST_CASE("a pause while the answer is open is taken off the response time and shows no clip again") {
        for (const bool game : {false, true}) {
            CAPTURE(game);
            Driver driver(1, 0.5, false);
            driver.start(game ? std::set<int>{0, 1} : std::set<int>{});
            REQUIRE(driver.toAnswer());
            driver.wait(1.0);
            driver.step(pauseFor(PauseReason::escape));
            const double paused_s = driver.time_s;
            driver.wait(5.0);
            CHECK(driver.responses.empty());
            if (game) {
                for (const BallView& ball : driver.frame.balls) CHECK(ball.look == BallLook::waiting);
                driver.choose(0);
                CHECK(driver.responses.empty());
            }
            driver.press(button_id::resume);
            const double away_s = driver.time_s - paused_s;
            driver.wait(0.5);
            if (game)
                driver.choose(1);
            else
                driver.digit(3);
            REQUIRE(driver.responses.size() == 1);
            const Response& response = driver.responses[0];
            CHECK(response.paused_s == doctest::Approx(away_s));
            CHECK(response.response_time_s ==
                  doctest::Approx(response.answered.time_s - response.motion_end.time_s - away_s));
            CHECK(response.response_time_s < 2.0);
            CHECK(response.pauses == 1);
            CHECK(driver.count(NoteKind::stimulus_onset) == 1);
        }
    }

    TEST_CASE("a second loss of focus does not end a pause") {
        Driver driver(1);
        driver.start();
        driver.step();
        driver.step(pauseFor(PauseReason::focus_lost));
        driver.wait(1.0);
        driver.step(pauseFor(PauseReason::focus_lost));
        driver.wait(1.0);
        CHECK(hasButton(driver.frame, button_id::resume));
        CHECK(driver.count(NoteKind::pause) == 1);
        CHECK(driver.count(NoteKind::resume) == 0);
    }

    TEST_CASE("quitting ends at once, by the window or on the pause panel, and a resume asks only the rest") {
        for (const bool by_panel : {false, true}) {
            CAPTURE(by_panel);
            Driver driver(2);
            driver.start();
            for (int i = 0; i < 4; ++i) {
                REQUIRE(driver.toAnswer());
                driver.answerSomehow(i);
            }
            if (by_panel) {
                driver.step(pauseFor(PauseReason::escape));
                driver.wait(0.5);
                driver.press(button_id::end_session);
                CHECK_FALSE(driver.hasQuit());
                CHECK(driver.frame.panel->texts.front().text == "End the session?");
                driver.wait(0.5);
                driver.press(button_id::back);
                driver.wait(0.5);
                driver.press(button_id::end_session);
                driver.wait(0.5);
                driver.press(button_id::end_for_good);
            } else {
                InputFrame input;
                input.quit = true;
                driver.step(input);
            }
            CHECK(driver.hasQuit());
            CHECK_FALSE(driver.finished());
            CHECK(driver.count(NoteKind::quit) == 1);
            std::set<int> answered;
            for (const Response& response : driver.responses) answered.insert(response.trial_index);
            CHECK(answered == std::set<int>{1, 2, 3});  // the first of the four was practice

            driver.notes.clear();
            driver.frame = {};
            driver.start();
            driver.step();
            CHECK(driver.frame.panel->texts.front().text == "Welcome back");
            REQUIRE(driver.finish());
            std::vector<int> asked;
            for (const Response& response : driver.responses) asked.push_back(response.trial_index);
            CHECK(asked == std::vector<int>{1, 2, 3, 4, 6, 7, 8, 9});
            // The begun stage is not practised again, the one not begun is.
            CHECK(driver.practised.size() == 2);
            CHECK(driver.last(NoteKind::session_start).detail == "resumed after 3 of 8 answers");
        }
    }

    TEST_CASE("with everything answered only the last page is left") {
        Driver driver(1);
        driver.start({1, 2, 4, 5});
        driver.step();
        REQUIRE(driver.frame.panel.has_value());
        CHECK(driver.frame.panel->texts.front().text == "Thank you");
        CHECK(driver.frame.panel->progress == 1.0);
        REQUIRE(driver.finish());
        CHECK(driver.responses.empty());
    }

    TEST_CASE(
        "whatever is done, over 50 seeds, every scored trial is answered exactly once and never before its "
        "end") {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            CAPTURE(seed);
            Random random(seed, "session fuzz");
            Driver driver(2, 0.4);
            driver.stage("naturalness").max_replays = static_cast<int>(random.below(3));
            driver.stage("game").max_replays = static_cast<int>(random.below(3));
            driver.stage("game").break_every = static_cast<int>(random.below(4));
            driver.frame_time_s = 1.0 / random.uniform(15.0, 90.0);
            std::set<int> answered;
            bool finished = false;
            for (int visits = 0; visits < 500 && !finished; ++visits) {
                driver.restart();
                for (int i = 0; i < 100000 && !driver.finished() && !driver.hasQuit(); ++i) {
                    const bool was_open = answersOpen(driver.frame);
                    const std::size_t before = driver.responses.size();
                    driver.step(anything(driver.frame, random), random.uniform() < 0.9);
                    if (driver.responses.size() > before) {
                        REQUIRE(driver.responses.size() == before + 1);
                        CHECK(was_open);
                        CHECK(answered.insert(driver.responses.back().trial_index).second);
                    }
                }
                finished = driver.finished();
            }
            CHECK(finished);
            CHECK(answered == std::set<int>{1, 2, 3, 4, 6, 7, 8, 9});
            for (const Response& response : driver.responses) {
                CHECK(response.onset.time_s + 0.4 <= response.motion_end.time_s + 1e-9);
                CHECK(response.motion_end.time_s < response.answered.time_s);
                CHECK(response.response_time_s > 0.0);
                CHECK(response.response_time_s <=
                      response.answered.time_s - response.motion_end.time_s + 1e-9);
                const bool game = response.trial_index >= 5;
                CHECK((ratingOf(response) >= 1 && ratingOf(response) <= 5) == !game);
                CHECK((response.chosenPlace() >= 0 && response.chosenPlace() <= 2) == game);
            }
        }
    }
}
