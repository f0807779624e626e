// When a press of select is an answer, and what a ray can meet.
#include <doctest/doctest.h>

#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

const std::set<int> ratings_answered{0, 1};  ///< of Driver(1, ..., false): what is left is the game

/// Reads the pages up to the first trial.
void toFirstTrial(Driver& driver) {
    while (driver.session->trialUnderWay() < 0) {
        if (resting(driver.frame))
            driver.leavePage();
        else
            driver.step();
    }
}

void toOpening(Driver& driver) {
    toFirstTrial(driver);
    while (!answersOpen(driver.frame)) driver.step();
}

/// A head that looks `degrees` to the side of a point, on the driver's place.
Quat besides(const Driver& driver, const Vec3& point, double degrees) {
    const Quat at_it = rotationBetween(Vec3(0.0, 0.0, -1.0), lookAt(driver.frame, point).direction);
    return at_it * yawRotation(radiansFromDegrees(degrees));
}

}  // namespace

TEST_SUITE("studies/session_select") {
    TEST_CASE("an answer with the ray is dated by the moment at which select went down") {
        Driver driver(1, 0.5, false);
        driver.start(ratings_answered);
        REQUIRE(driver.toAnswer());
        driver.wait(0.5);
        driver.select_ago_s = 0.013;
        InputFrame input = driver.pointing(driver.frame.balls[1].centre, true);
        input.input_time_s = driver.time_s + 0.005;
        driver.step(input);
        REQUIRE(driver.responses.size() == 1);
        const Response& response = driver.responses[0];
        CHECK(response.answered.time_s == doctest::Approx(driver.time_s - 0.013));
        CHECK(response.answered.utc_s == doctest::Approx(driver.time_s - 0.013 + 1.0e9).epsilon(1e-13));
        CHECK(response.response_time_s ==
              doctest::Approx(driver.time_s - 0.013 - response.motion_end.time_s));
    }

    TEST_CASE("without its own time an answer is dated by when the input was read, as one by key is") {
        for (const bool by_key : {false, true}) {
            CAPTURE(by_key);
            Driver driver(1, 0.5, false);
            driver.start();
            REQUIRE(driver.toAnswer());
            driver.wait(0.5);
            InputFrame input =
                driver.pointing(buttonCentre(*driver.frame.panel, button_id::first_rating), !by_key);
            if (by_key) {
                input.digit = 1;
                driver.select_ago_s = 0.013;  // of no concern to a key
            }
            input.input_time_s = driver.time_s + 0.005;
            driver.step(input);
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].input == (by_key ? "key" : "ray"));
            CHECK(driver.responses[0].answered.time_s == *input.input_time_s);
        }
    }

    TEST_CASE("select that went down before the open answer was displayed is no answer, but noted") {
        Driver driver(1, 0.5, false);
        driver.display_delay_s = 0.05;  // three frames on their way to the display
        driver.start(ratings_answered);
        toOpening(driver);
        const double displayed_s = driver.time_s + 0.05;
        const Vec3 ball = driver.frame.balls[2].centre;

        driver.step(driver.pointing(ball, true));
        CHECK(driver.responses.empty());
        REQUIRE(driver.count(NoteKind::early_select) == 1);
        CHECK(driver.last(NoteKind::early_select).trial_index == 2);
        CHECK(driver.last(NoteKind::early_select).at.time_s == driver.time_s);
        CHECK(driver.last(NoteKind::early_select).at.utc_s ==
              doctest::Approx(driver.time_s + 1.0e9).epsilon(1e-13));

        while (driver.time_s < displayed_s) driver.step();
        driver.select_ago_s = driver.time_s + driver.frame_time_s - displayed_s + 0.001;
        driver.step(driver.pointing(ball, true));
        CHECK(driver.responses.empty());
        CHECK(driver.count(NoteKind::early_select) == 2);
        CHECK(driver.last(NoteKind::early_select).detail == "0.001 s before the answer was open");
        CHECK(driver.last(NoteKind::early_select).at.time_s == doctest::Approx(displayed_s - 0.001));

        driver.select_ago_s = driver.time_s + driver.frame_time_s - displayed_s - 0.001;
        driver.step(driver.pointing(ball, true));
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].answered.time_s == doctest::Approx(displayed_s + 0.001));
        CHECK(driver.responses[0].response_time_s > 0.0);
        CHECK(driver.count(NoteKind::early_select) == 2);
    }

    TEST_CASE("a key that went down before the open answer was displayed is no answer either") {
        Driver driver(1, 0.5, false);
        driver.display_delay_s = 0.05;
        driver.start();
        toOpening(driver);
        driver.digit(4);
        CHECK(driver.responses.empty());
        driver.wait(0.1);
        driver.digit(4);
        CHECK(driver.responses.size() == 1);
    }

    TEST_CASE("select while the answer is not open is noted once in a trial, with what was shown") {
        Driver driver(1, 0.5, false);
        driver.start(ratings_answered);
        toFirstTrial(driver);
        CHECK(driver.count(NoteKind::early_select) == 0);
        while (driver.state() != "playing-across") driver.step();
        driver.step(driver.pointing(driver.frame.balls[0].centre, true));
        driver.step(driver.pointing(driver.frame.balls[0].centre, true));
        CHECK(driver.count(NoteKind::early_select) == 1);
        CHECK(driver.last(NoteKind::early_select).trial_index == 2);
        CHECK(driver.last(NoteKind::early_select).detail == "playing-across");
        CHECK(driver.responses.empty());

        REQUIRE(driver.toAnswer());
        driver.choose(0);
        driver.step(driver.pointing(driver.frame.balls[0].centre, true));  // a double click is not early
        CHECK(driver.count(NoteKind::early_select) == 1);
        REQUIRE(driver.waitUntil([&] { return driver.state() == "waiting-side-by-side"; }));
        driver.step(driver.pointing(driver.frame.balls[0].centre, true));
        CHECK(driver.count(NoteKind::early_select) == 2);
        CHECK(driver.last(NoteKind::early_select).trial_index == 3);
        CHECK(driver.last(NoteKind::early_select).detail == "waiting-side-by-side");
    }

    TEST_CASE("presses on pages and on the pause page are not early") {
        Driver driver(1, 0.5, false);
        driver.start();
        toFirstTrial(driver);
        InputFrame pause;
        pause.pause = true;
        driver.step(pause);
        driver.wait(0.5);
        driver.press(button_id::resume);
        REQUIRE(driver.toAnswer());
        CHECK(driver.count(NoteKind::early_select) == 0);
    }

    TEST_CASE("a ball out of sight is neither lit nor chosen; within 60 degrees it is") {
        Driver driver(1, 0.5, false);
        driver.start(ratings_answered);
        REQUIRE(driver.toAnswer());
        const Vec3 ball = driver.frame.balls[0].centre;
        for (const double degrees : {-170.0, -90.0, -62.0, 62.0, 120.0, 180.0}) {
            CAPTURE(degrees);
            driver.looking = besides(driver, ball, degrees);
            driver.step(driver.pointing(ball, true));
            CHECK(driver.responses.empty());
            for (const BallView& view : driver.frame.balls) CHECK(view.look == BallLook::selectable);
            CHECK_FALSE(driver.frame.tick);
            REQUIRE(driver.frame.ray.has_value());
            CHECK(driver.frame.ray->length_m < 5.0);  // it still ends at the ball
        }
        driver.looking = besides(driver, ball, 58.0);
        driver.step(driver.pointing(ball, false));
        CHECK(driver.frame.balls[0].look == BallLook::hovered);
        driver.step(driver.pointing(ball, true));
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].chosenPlace() == 0);
    }

    TEST_CASE("a ball is lit and chosen however far away, up to the floor; the ray is drawn up to it") {
        for (const double away_m : {4.0, 5.5, 9.0, 19.0}) {
            CAPTURE(away_m);
            Driver driver(1, 0.5, false);
            driver.start(ratings_answered);
            REQUIRE(driver.toAnswer());
            const Vec3 eye = driver.frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
            const Vec3 ahead = driver.frame.stage_from_viewer.orientation * Vec3(0.0, 0.0, -1.0);
            const Vec3 ball = eye + away_m * ahead;
            driver.plan.trials[static_cast<std::size_t>(driver.session->trialUnderWay())].target = ball;
            driver.session.reset();
            driver.frame = {};
            driver.start(ratings_answered);
            REQUIRE(driver.toAnswer());
            const int place =
                driver.plan.trials[static_cast<std::size_t>(driver.session->trialUnderWay())].targetPlace();
            driver.step(driver.pointing(ball, false));
            CHECK(driver.frame.balls[static_cast<std::size_t>(place)].look == BallLook::hovered);
            CHECK(driver.frame.ray->length_m == doctest::Approx(away_m - 0.05).epsilon(0.01));
            driver.step(driver.pointing(ball, true));
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].chosenPlace() == place);
        }
        Driver driver(1, 0.5, false);
        driver.start(ratings_answered);
        REQUIRE(driver.toAnswer());
        driver.step(driver.pointing(driver.frame.stage_from_viewer.position + Vec3(0.0, 2.5, -9.0), false));
        CHECK_MESSAGE(driver.frame.ray->length_m == 5.0, "it meets nothing");
    }

    TEST_CASE("a button out of sight cannot be pressed, but a key can") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        const Vec3 button = buttonCentre(*driver.frame.panel, button_id::first_rating + 1);
        driver.looking = besides(driver, button, 100.0);
        driver.step(driver.pointing(button, true));
        CHECK(driver.responses.empty());
        for (const PanelButton& one : driver.frame.panel->buttons) CHECK_FALSE(one.hovered);
        driver.digit(3);
        REQUIRE(driver.responses.size() == 1);
        CHECK(ratingOf(driver.responses[0]) == 3);

        driver.looking.reset();
        REQUIRE(driver.waitUntil([&] { return driver.state() == "waiting"; }));
        InputFrame pause;
        pause.pause = true;
        driver.step(pause);
        driver.wait(0.5);
        driver.looking = besides(driver, buttonCentre(*driver.frame.panel, button_id::end_session), 100.0);
        driver.press(button_id::end_session);
        CHECK(hasButton(driver.frame, button_id::end_session));
        driver.looking.reset();
        driver.press(button_id::end_session);
        CHECK(hasButton(driver.frame, button_id::end_for_good));
    }

    TEST_CASE(
        "the ray ticks in the frame in which it meets a ball or a button, and not while it stays there") {
        Driver driver(1, 0.5, false);
        driver.start();
        driver.wait(0.5);
        const auto ticksAt = [&](const Vec3& point) {
            driver.step(driver.pointing(point, false));
            return driver.frame.tick;
        };
        const Vec3 nothing(0.0, 9.0, 0.0);
        const Vec3 go_on = buttonCentre(*driver.frame.panel, button_id::go_on);
        CHECK_FALSE(ticksAt(nothing));
        CHECK(ticksAt(go_on));
        CHECK_FALSE(ticksAt(go_on));
        CHECK_FALSE(ticksAt(nothing));
        CHECK(ticksAt(go_on));
        driver.press(button_id::go_on);
        const Vec3 next = buttonCentre(*driver.frame.panel, button_id::go_on);
        CHECK(ticksAt(next));  // the next page's button is another one
        CHECK_FALSE(ticksAt(next));

        REQUIRE(driver.toAnswer());
        const Panel& panel = *driver.frame.panel;
        CHECK(ticksAt(buttonCentre(panel, button_id::first_rating)));
        CHECK(ticksAt(buttonCentre(panel, button_id::first_rating + 1)));
        CHECK_FALSE(ticksAt(transformPoint(panel.stage_from_panel, {0.01, 0.01, 0.0})));  // the bare board
        driver.press(button_id::first_rating);
        CHECK_FALSE(ticksAt(buttonCentre(*driver.frame.panel, button_id::first_rating + 1)));  // disabled now

        REQUIRE(driver.waitUntil([&] { return driver.session->trialUnderWay() == 1; }));
        REQUIRE(driver.toAnswer());
        driver.press(button_id::first_rating);
        REQUIRE(driver.toAnswer());
        REQUIRE(driver.frame.balls.size() == 3);
        CHECK(ticksAt(driver.frame.balls[1].centre));
        CHECK_FALSE(ticksAt(driver.frame.balls[1].centre));
        CHECK(ticksAt(driver.frame.balls[2].centre));
        driver.choose(2);
        CHECK_FALSE(driver.frame.tick);
        for (int frames = 0; frames < 20; ++frames) CHECK_FALSE(ticksAt(driver.frame.balls[1].centre));
    }
}
