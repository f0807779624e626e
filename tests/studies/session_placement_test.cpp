// Free placement: a ball is taken with the ray, put somewhere and confirmed.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "session_stages.hpp"
#include "studies/design/visibility.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Stage placementStage() {
    Stage stage = gameStage("placement");
    stage.kind = StageKind::placement;
    stage.question = "Put the ball where it points.";
    return stage;
}

struct Placing : Driver {
    explicit Placing(const Stage& stage = placementStage(), int trials = 1) : Driver({stage}) {
        for (int item = 0; item < trials; ++item) add("placement", item, {"one"}).layout = "across";
        start();
    }

    [[nodiscard]] const Vec3& ball() const { return frame.balls.at(0).centre; }

    /// Takes the ball, carries it with the button held, and lets it go there.
    void dragTo(const Vec3& point) {
        if (just_opened) step();
        step(pointing(ball(), true));
        InputFrame held = pointing(point, false);
        held.select_held = true;
        held.farther_m =
            glm::length(point - held.pointer->origin) - glm::length(ball() - held.pointer->origin);
        step(held);
        held.farther_m = 0.0;
        step(held);
        step(pointing(point, false));
    }
};

}  // namespace

TEST_SUITE("studies/session_placement") {
    TEST_CASE("nothing can be confirmed before the ball was moved, and it can be moved again before that") {
        Placing driver;
        REQUIRE(driver.frame.balls.empty());
        REQUIRE(driver.toAnswer());
        REQUIRE(driver.frame.balls.size() == 1);
        CHECK(driver.frame.balls[0].look == BallLook::selectable);
        const Vec3 rest = driver.ball();
        driver.press(button_id::go_on);
        InputFrame enter;
        enter.confirm = true;
        driver.step(enter);
        CHECK(driver.responses.empty());
        driver.step(driver.pointing(rest, true));  // a click that moves nothing
        driver.step(driver.pointing(rest, false));
        driver.step(enter);
        CHECK(driver.responses.empty());

        driver.dragTo({0.5, 1.2, 1.5});
        CHECK(glm::length(driver.ball() - Vec3(0.5, 1.2, 1.5)) < 0.02);
        CHECK(driver.responses.empty());
        driver.dragTo({-0.4, 0.9, 1.8});
        CHECK(glm::length(driver.ball() - Vec3(-0.4, 0.9, 1.8)) < 0.02);
        CHECK(driver.responses.empty());
        const Vec3 put = driver.ball();
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        const Response& given = driver.responses[0];
        CHECK(given.input == "ray");
        CHECK(keptNumber(given.values, "placed_x_m") == put.x);
        CHECK(keptNumber(given.values, "placed_y_m") == put.y);
        CHECK(keptNumber(given.values, "placed_z_m") == put.z);
        CHECK(driver.frame.balls[0].look == BallLook::chosen);
    }

    TEST_CASE("kept are the distance from the target in cm and the angle at the avatar's eyes") {
        Placing driver;
        REQUIRE(driver.toAnswer());
        driver.dragTo({0.3, 1.4, 1.6});
        InputFrame enter;
        enter.confirm = true;
        driver.step(enter);
        REQUIRE(driver.responses.size() == 1);
        const Response& given = driver.responses[0];
        CHECK(given.input == "key");
        const Vec3 put(*keptNumber(given.values, "placed_x_m"), *keptNumber(given.values, "placed_y_m"),
                       *keptNumber(given.values, "placed_z_m"));
        const Vec3 target = driver.plan.trials[0].target;
        REQUIRE(given.answers.size() == 2);
        CHECK(given.answers[0].question == "distance");
        CHECK(*given.answers[0].value == doctest::Approx(100.0 * glm::length(put - target)).epsilon(1e-4));
        // By the law of cosines, in the triangle of the eyes, the target and the ball.
        const Vec3 eyes = StandingAvatar::reference().eyes();
        const double a = glm::length(put - target), b = glm::length(put - eyes),
                     c = glm::length(target - eyes);
        const double angle = std::acos((b * b + c * c - a * a) / (2.0 * b * c)) * 180.0 / pi;
        CHECK(given.answers[1].question == "angle");
        CHECK(*given.answers[1].value == doctest::Approx(angle).epsilon(1e-3));
    }

    TEST_CASE("a placement whose time runs out is kept without a place") {
        Stage stage = placementStage();
        stage.time_limit_s = 3.0;
        Placing driver(stage);
        REQUIRE(driver.toAnswer());
        driver.wait(3.2);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].status == ResponseStatus::timed_out);
        CHECK(driver.responses[0].answers.empty());
        CHECK(driver.responses[0].values.empty());
    }

    TEST_CASE("before the clip is over the ball waits where it tells no target, and is not to be taken") {
        Placing one, other;
        other.plan.trials[0].target = Vec3(-1.0, 0.4, 1.7);
        other.start();
        for (Placing* driver : {&one, &other}) {
            REQUIRE(driver->toState("playing-across"));
            CHECK(driver->frame.balls.at(0).look == BallLook::waiting);
            driver->step(driver->pointing(driver->ball(), true));
            CHECK(driver->responses.empty());
        }
        CHECK(one.ball() == other.ball());
    }
}
