// Studies that want an interrupted trial to start over: nothing that was begun of its answer is left, in
// trials of every kind.
#include <doctest/doctest.h>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// A session of one trial that wants interrupted trials repeated, or not.
struct Interrupted : Driver {
    Interrupted(const Stage& stage, const std::vector<std::string>& systems, bool repeats) : Driver({stage}) {
        study.after_interruption = repeats ? AfterInterruption::repeat : AfterInterruption::resume;
        keyboard = true;
        Trial& trial = add(stage.name, 0, systems);
        if (stage.kind == StageKind::game) trial.layout = "across";
        start();
        wait(0.6);
    }
    void interrupt() {
        step(pauseFor(PauseReason::headset_taken_off));
        wait(0.6);
        press(button_id::resume);
        wait(0.6);
    }
    [[nodiscard]] std::optional<int> valueOf(int slider_id) const {
        const PanelSlider* one = sliderOf(frame, slider_id);
        REQUIRE(one != nullptr);
        return one->value;
    }
    [[nodiscard]] int shownClips() const { return count(NoteKind::stimulus_onset); }
};

Stage confidenceGame(const Scale& scale) {
    Stage stage = gameStage();
    stage.confidence = question("sure", QuestionKind::scale);
    stage.confidence->scale = scale;
    return stage;
}

}  // namespace

TEST_SUITE("studies/session_repeat") {
    TEST_CASE("a rating's slider is untouched again, and the clip is shown once more") {
        for (const bool repeats : {true, false}) {
            CAPTURE(repeats);
            Stage stage = ratingStage();
            stage.scale = slider(0, 100);
            Interrupted driver(stage, {"one"}, repeats);
            REQUIRE(driver.toAnswer());
            driver.wait(0.5);
            setSlider(driver, button_id::first_slider, 70);
            CHECK(driver.valueOf(button_id::first_slider) == 70);
            driver.interrupt();
            REQUIRE(driver.toAnswer());
            driver.wait(0.5);
            CHECK(driver.shownClips() == (repeats ? 2 : 1));
            CHECK(driver.valueOf(button_id::first_slider) ==
                  (repeats ? std::nullopt : std::optional<int>(70)));
            CHECK(hasButton(driver.frame, button_id::go_on) != repeats);
        }
    }

    TEST_CASE("a rating's slider is untouched again where the pause came in a replay") {
        Stage stage = ratingStage();
        stage.scale = slider(0, 100);
        stage.max_replays = 1;
        Interrupted driver(stage, {"one"}, true);
        REQUIRE(driver.toAnswer());
        driver.wait(0.5);
        setSlider(driver, button_id::first_slider, 70);
        driver.press(button_id::replay);
        REQUIRE(driver.waitUntil([&] { return driver.shownClips() == 2; }));
        driver.interrupt();
        REQUIRE(driver.toAnswer());
        CHECK_FALSE(driver.valueOf(button_id::first_slider).has_value());
    }

    TEST_CASE("a choice that was made stands, and how sure one is of it is asked again") {
        for (const bool repeats : {true, false}) {
            CAPTURE(repeats);
            Interrupted driver(confidenceGame(slider(0, 100)), {"one"}, repeats);
            REQUIRE(driver.toAnswer());
            driver.choose(2);
            driver.wait(0.5);
            setSlider(driver, button_id::first_slider, 90);
            driver.interrupt();
            CHECK(driver.frame.state == PresentedState::confidence);
            CHECK(driver.valueOf(button_id::first_slider) ==
                  (repeats ? std::nullopt : std::optional<int>(90)));
            setSlider(driver, button_id::first_slider, 20);
            driver.step();
            driver.press(button_id::go_on);
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].chosenPlace() == 2);
            CHECK(answerTo(driver.responses[0], "confidence") == 20.0);
            CHECK(driver.shownClips() == 1);
        }
    }

    TEST_CASE("no ball is lit or chosen when the game starts over") {
        Interrupted driver(gameStage(), {"one"}, true);
        REQUIRE(driver.toAnswer());
        driver.step(driver.pointing(driver.frame.balls[1].centre, false));
        CHECK(driver.frame.balls[1].look == BallLook::hovered);
        driver.interrupt();
        REQUIRE(driver.toAnswer());
        CHECK(driver.shownClips() == 2);
        for (const BallView& ball : driver.frame.balls) CHECK(ball.look == BallLook::selectable);
    }

    TEST_CASE("a parallel page starts over: no movement counts as seen, no slider or step as set") {
        for (const bool slides : {true, false})
            for (const bool repeats : {true, false}) {
                CAPTURE(slides);
                CAPTURE(repeats);
                Interrupted driver(parallelStage(slides ? slider(0, 100) : five_steps), {"one", "two"},
                                   repeats);
                REQUIRE(playToEnd(driver, 0));
                const int step_id = button_id::first_option + 3;
                if (slides)
                    setSlider(driver, button_id::first_slider, 64);
                else
                    driver.press(step_id);
                driver.step();
                driver.interrupt();
                CHECK(driver.count(NoteKind::trial_repeated) == (repeats ? 1 : 0));
                const bool set = slides ? driver.valueOf(button_id::first_slider).has_value()
                                        : buttonOf(driver.frame, step_id)->chosen;
                CHECK(set != repeats);
                if (slides)
                    CHECK(sliderOf(driver.frame, button_id::first_slider)->enabled != repeats);
                else
                    CHECK(buttonOf(driver.frame, step_id)->enabled != repeats);
                if (!repeats) continue;
                for (const int i : {0, 1}) REQUIRE(playToEnd(driver, i));
                CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
                for (const int i : {0, 1})
                    if (slides)
                        setSlider(driver, button_id::first_slider + i, 10 + i);
                    else
                        driver.press(button_id::first_option + 100 * i);
                driver.wait(0.1);
                driver.press(button_id::go_on);
                REQUIRE(driver.responses.size() == 1);
                const Response& response = driver.responses[0];
                CHECK(response.plays == std::vector<int>{1, 1});
                CHECK(response.pauses == 1);
                CHECK(response.paused_s == 0.0);
                CHECK(answerTo(response, "rating", 0) == (slides ? 10.0 : 1.0));
            }
    }

    TEST_CASE(
        "a movement of a page that was interrupted does not go on by itself when the page starts over") {
        Interrupted driver(parallelStage(slider(0, 100)), {"one", "two"}, true);
        driver.press(button_id::first_play);
        REQUIRE(driver.waitUntil([&] { return driver.shownClips() == 1; }));
        driver.interrupt();
        CHECK(driver.frame.state == PresentedState::watching);
        driver.wait(3.0);
        CHECK(driver.shownClips() == 1);
        CHECK(hasButton(driver.frame, button_id::first_play));
    }

    TEST_CASE("of a pair both are played again; a preference that was given stands, its reasons do not") {
        Stage stage = pairStage();
        stage.reasons = question("why", QuestionKind::text);
        Interrupted driver(stage, {"one", "two"}, true);
        REQUIRE(playToEnd(driver, 0));
        REQUIRE(playToEnd(driver, 1));
        CHECK(hasButton(driver.frame, button_id::first_rating));
        driver.interrupt();
        CHECK_FALSE(hasButton(driver.frame, button_id::first_rating));
        REQUIRE(playToEnd(driver, 0));
        REQUIRE(playToEnd(driver, 1));
        driver.wait(0.5);
        driver.press(button_id::first_rating);
        REQUIRE(driver.frame.state == PresentedState::reasons);
        driver.wait(0.5);
        type(driver, "because");
        CHECK(driver.frame.panel->fields.at(0).text == "because");
        driver.interrupt();
        REQUIRE(driver.frame.state == PresentedState::reasons);
        CHECK(driver.frame.panel->fields.at(0).text.empty());
        CHECK(driver.frame.panel->fields.at(0).active);
        type(driver, "smoother");
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "preference") == -2.0);
        CHECK(textOf(driver.responses[0], "reasons") == "smoother");
    }

    TEST_CASE("a questionnaire shows no clip: what was entered stays") {
        Driver driver({questionnaireStage({question("t", QuestionKind::text)})});
        driver.study.after_interruption = AfterInterruption::repeat;
        driver.keyboard = true;
        driver.add("questions", 0, {});
        driver.start();
        driver.wait(0.6);
        type(driver, "half");
        driver.step(pauseFor(PauseReason::escape));
        driver.wait(0.6);
        driver.press(button_id::resume);
        CHECK(driver.frame.panel->fields.at(0).text == "half");
    }
}
