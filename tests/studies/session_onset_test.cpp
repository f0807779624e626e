// What a ray rests on when a board or the choice opens was not aimed at.
#include <doctest/doctest.h>

#include "session_fixture.hpp"
#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

const std::set<int> ratings_given{0, 1};  ///< of Driver(1, ..., false): what is left is the game

int litButtons(const PresentedFrame& frame) {
    int lit = 0;
    for (const PanelButton& button : frame.panel->buttons)
        if (button.hovered) ++lit;
    return lit;
}

/// Up to the frame that opens an answer, with the ray on a point all the time.
void toOpening(Driver& driver, const Vec3& point) {
    while (!answersOpen(driver.frame)) {
        if (resting(driver.frame))
            driver.leavePage();
        else
            driver.step(driver.pointing(point, false));
    }
}

/// Where the board of a rating has a button, as a rating shows it that is then given up.
Vec3 placeOfRating(int id) {
    Driver driver(1, 0.5, false);
    driver.start();
    REQUIRE(driver.toAnswer());
    return buttonCentre(*driver.frame.panel, id);
}

/// The ray to a point, turned to the side.
InputFrame turned(const Driver& driver, const Vec3& point, double degrees, bool select) {
    InputFrame input = driver.pointing(point, select);
    const Vec3 right = glm::normalize(glm::cross(input.pointer->direction, up));
    input.pointer->direction =
        glm::normalize(input.pointer->direction + std::tan(radiansFromDegrees(degrees)) * right);
    return input;
}

}  // namespace

TEST_SUITE("studies/session_onset") {
    TEST_CASE("a ray that rests on an option as the rating opens lights nothing and presses nothing") {
        const Vec3 option = placeOfRating(button_id::first_rating + 3);
        Driver driver(1, 0.5, false);
        driver.start();
        toOpening(driver, option);
        CHECK(litButtons(driver.frame) == 0);
        for (int i = 0; i < 120; ++i) {
            driver.step(driver.pointing(option, i % 3 == 0));
            REQUIRE(litButtons(driver.frame) == 0);
            REQUIRE_FALSE(driver.frame.tick);
        }
        CHECK(driver.responses.empty());
        CHECK(driver.frame.ray.has_value());

        SUBCASE("nor where a click shakes it by half a degree") {
            driver.step(turned(driver, option, 0.5, true));
            CHECK(litButtons(driver.frame) == 0);
            CHECK(driver.responses.empty());
        }
        SUBCASE("moved by more than a degree, still on the option, it lights it and is an answer") {
            driver.step(turned(driver, option, 1.2, false));
            CHECK(litButtons(driver.frame) == 1);
            driver.step(turned(driver, option, 1.2, true));
            REQUIRE(driver.responses.size() == 1);
            CHECK(ratingOf(driver.responses[0]) == 4);
        }
        SUBCASE("once it has been off the option, it is met where it was") {
            driver.step();
            driver.step(driver.pointing(option, false));
            CHECK(litButtons(driver.frame) == 1);
            driver.step(driver.pointing(option, true));
            CHECK(driver.responses.size() == 1);
        }
        SUBCASE("another option is met at once") {
            driver.press(button_id::first_rating + 1);
            REQUIRE(driver.responses.size() == 1);
            CHECK(ratingOf(driver.responses[0]) == 2);
        }
        SUBCASE("a key needs no ray") {
            InputFrame input = driver.pointing(option, false);
            input.digit = 5;
            driver.step(input);
            REQUIRE(driver.responses.size() == 1);
            CHECK(ratingOf(driver.responses[0]) == 5);
        }
    }

    TEST_CASE("clicking on without moving answers one trial, not the next") {
        Driver driver(2, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        const Vec3 option = buttonCentre(*driver.frame.panel, button_id::first_rating + 3);
        driver.step(driver.pointing(option, true));
        REQUIRE(driver.responses.size() == 1);
        toOpening(driver, option);
        for (int i = 0; i < 60; ++i) driver.step(driver.pointing(option, i % 2 == 0));
        CHECK(driver.responses.size() == 1);
        CHECK(litButtons(driver.frame) == 0);
    }

    TEST_CASE("a ball on which the ray rests as the choice opens is neither lit nor chosen, until it moves") {
        Driver driver(1, 0.5, false);
        driver.start(ratings_given);
        while (driver.frame.balls.empty()) {
            if (resting(driver.frame))
                driver.leavePage();
            else
                driver.step();
        }
        const Vec3 ball = driver.frame.balls[1].centre;
        toOpening(driver, ball);
        for (int i = 0; i < 60; ++i) {
            driver.step(driver.pointing(ball, i % 2 == 0));
            for (const BallView& view : driver.frame.balls) REQUIRE(view.look == BallLook::selectable);
        }
        CHECK(driver.responses.empty());
        CHECK(driver.state() == "choosing-across");
        driver.step();
        driver.step(driver.pointing(ball, false));
        CHECK(driver.state() == "aiming-across");
        driver.choose(1);
        CHECK(driver.responses.size() == 1);
    }

    TEST_CASE("where the viewer or the view is moved for a board, the ray that comes of it was not aimed") {
        // In the frame that opens the board the ray is elsewhere; in the next it rests on an option, and the
        // participant has done nothing.
        const Vec3 option = placeOfRating(button_id::first_rating);
        Driver driver(1, 0.5, false);
        driver.start();
        toOpening(driver, {0.0, 9.0, 0.0});
        for (int i = 0; i < 30; ++i) driver.step(driver.pointing(option, true));
        CHECK(driver.responses.empty());
    }

    TEST_CASE("consent is neither given nor refused by a ray that rests where its buttons come up") {
        for (const int id : {button_id::agree, button_id::decline}) {
            CAPTURE(id);
            Stage consent = pageStage("consent", "Take part?", StageKind::consent);
            Driver driver({consent});
            driver.add("consent", 0, {});
            driver.start();
            driver.step();
            REQUIRE(driver.state() == "consent");
            const Vec3 button = buttonCentre(*driver.frame.panel, id);
            for (int i = 0; i < 120; ++i) driver.step(driver.pointing(button, i % 5 == 0));
            CHECK(driver.responses.empty());
            CHECK(litButtons(driver.frame) == 0);
            driver.step();
            driver.press(id);
            if (id == button_id::decline) driver.wait(0.6);
            if (id == button_id::decline) driver.press(button_id::end_for_good);
            CHECK(driver.responses.size() == 1);
        }
    }

    TEST_CASE("a page that is only read can be left by a ray that rests on its button") {
        Driver driver(1, 0.5, false);
        driver.start();
        driver.step();
        const Vec3 go_on = buttonCentre(*driver.frame.panel, button_id::go_on);
        driver.restart();
        for (int i = 0; i < 40; ++i) driver.step(driver.pointing(go_on, false));
        CHECK(litButtons(driver.frame) == 1);
        const std::string page = textOf(*driver.frame.panel);
        driver.step(driver.pointing(go_on, true));
        CHECK(textOf(*driver.frame.panel) != page);
    }

    TEST_CASE("a key that may have gone down before the open answer was seen is no answer") {
        Driver driver(1, 0.5, false);
        driver.start();
        toOpening(driver, {0.0, 9.0, 0.0});
        const double shown_s = driver.time_s;
        InputFrame input;
        input.digit = 4;
        input.read_before_s = shown_s - 0.001;
        driver.step(input);
        CHECK(driver.responses.empty());
        input.read_before_s = shown_s + 0.001;
        driver.step(input);
        CHECK(driver.responses.size() == 1);
    }
}
