// What stands beside and behind the boards of a session.
#include <doctest/doctest.h>

#include <map>

#include "session_stages.hpp"
#include "studies/boards/panel_layout.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Stage sureGame() {
    Stage stage = gameStage();
    stage.confidence = question("sure", QuestionKind::scale);
    stage.confidence->scale = five_steps;
    return stage;
}

Stage reasonedPair() {
    Stage stage = pairStage();
    stage.reasons = question("why", QuestionKind::choices);
    return stage;
}

}  // namespace

TEST_SUITE("studies/session_boards") {
    TEST_CASE("no avatar stands behind a page, and in a trial it is there from its first frame on") {
        Driver driver({pageStage("consent", "May we?", StageKind::consent), pageStage("hello", "Hello."),
                       questionnaireStage({question("s", QuestionKind::scale)}), ratingStage(), sureGame(),
                       parallelStage(slider(0, 100)), reasonedPair()});
        driver.add("consent", 0, {});
        driver.add("questions", 0, {});
        driver.add("rating", 0, {"one"});
        driver.add("game", 1, {"one"}).layout = "across";
        driver.add("parallel", 2, {"one", "two"});
        driver.add("pairs", 3, {"one", "two"});
        driver.start();
        using State = PresentedState;
        std::map<State, bool> seen;
        State before = State::starting;
        bool reasoned = false;
        for (int i = 0; i < 20000 && driver.running(); ++i) {
            carryOn(driver);
            if (driver.frame.state == State::over) continue;
            if (driver.frame.state == State::rated && before == State::reasons) {
                CHECK_FALSE(driver.frame.scene_visible);  // its page still stands there
                reasoned = true;
                continue;
            }
            before = driver.frame.state;
            const auto known = seen.emplace(driver.frame.state, driver.frame.scene_visible);
            CAPTURE(presentedStateName(driver.frame));
            CHECK(known.first->second == driver.frame.scene_visible);
            if (i == 2000) {  // in the midst of it all
                driver.step(pauseFor(PauseReason::escape));
                CHECK_FALSE(driver.frame.scene_visible);
                driver.wait(0.6);
                driver.press(button_id::resume);
            }
        }
        REQUIRE(driver.finished());
        CHECK(reasoned);
        CHECK_FALSE(driver.frame.scene_visible);  // nor does anybody stand there afterwards
        for (const State page :
             {State::consent, State::instructions, State::questionnaire, State::reasons, State::closing}) {
            CAPTURE(presentedStateName(page));
            REQUIRE(seen.count(page) == 1);
            CHECK_FALSE(seen[page]);
        }
        for (const State trial :
             {State::waiting, State::playing, State::rating, State::rated, State::choosing, State::chosen,
              State::confidence, State::watching, State::comparing}) {
            CAPTURE(presentedStateName(trial));
            REQUIRE(seen.count(trial) == 1);
            CHECK(seen[trial]);
        }
    }

    TEST_CASE(
        "how to take part stands under the first pages and in a pause, where the station has words for it") {
        for (const std::string hint : {"Trigger: select.", ""}) {
            CAPTURE(hint);
            Driver driver({pageStage("consent", "May we?", StageKind::consent), pageStage("hello", "Hello."),
                           questionnaireStage({question("s", QuestionKind::scale)})});
            driver.add("consent", 0, {});
            driver.add("questions", 0, {});
            driver.session.emplace(driver.study, driver.plan, driver.clips, driver.avatar, driver.idle,
                                   driver.left, false, hint);
            const auto told = [&] { return contains(textOf(*driver.frame.panel), "Trigger: select."); };
            driver.wait(0.6);
            CHECK(driver.frame.state == PresentedState::consent);
            CHECK(told() == !hint.empty());
            driver.step(pauseFor(PauseReason::escape));
            CHECK(told() == !hint.empty());
            driver.wait(0.6);
            driver.press(button_id::resume);
            driver.wait(0.6);
            driver.press(button_id::agree);
            REQUIRE(driver.toState("instructions"));
            CHECK(told() == !hint.empty());
            REQUIRE(driver.leavePage());
            CHECK(driver.frame.state == PresentedState::questionnaire);
            CHECK_FALSE(told());
        }
    }

    TEST_CASE("no ball covers the board that asks how sure one is, nor that board a ball") {
        // Low balls, where the board usually stands.
        for (const double height_m : {0.5, 0.8, 1.0, 1.2, 1.5}) {
            CAPTURE(height_m);
            Driver driver({sureGame()});
            Trial& trial = driver.add("game", 0, {"one"});
            trial.layout = "across";
            trial.target = {0.1, height_m, 2.0};
            trial.distractors = {{-0.1, height_m + 0.1, 2.1}, {0.25, height_m - 0.05, 1.9}};
            driver.start();
            REQUIRE(driver.toAnswer());
            driver.choose(1);
            REQUIRE(driver.frame.state == PresentedState::confidence);
            const Vec3 eyes = driver.frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
            for (const BallView& ball : driver.frame.balls)
                CHECK_FALSE(overlapsBall(*driver.frame.panel, eyes, ball));
            driver.wait(0.5);
            driver.press(button_id::first_rating + 1);
            REQUIRE(driver.responses.size() == 1);
            CHECK(answerTo(driver.responses[0], "confidence") == 2.0);
        }
    }
}
