// What a game may add to the choice: plays, replays, a time limit, a confidence, feedback; and practice.
#include <doctest/doctest.h>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct Playing : Driver {
    explicit Playing(const Stage& game, int trials = 2) : Driver({game}) {
        for (int item = 0; item < trials; ++item) add("game", item, {"one"}).layout = "across";
        start();
    }
};

Question confidence(const Scale& scale) {
    Question asked = question("sure", QuestionKind::scale);
    asked.text = "How sure are you?";
    asked.scale = scale;
    return asked;
}

/// Practice of two trials in up to `attempts` attempts, then the game.
struct Practising : Driver {
    Practising(double criterion, int attempts, bool end_if_failed)
        : Driver({practiceOf(gameStage()), gameStage()}) {
        stage("game-practice").practice =
            Practice{"game", criterion, attempts, end_if_failed, "Look at the finger."};
        for (int attempt = 0; attempt < attempts; ++attempt)
            for (int item = 0; item < 2; ++item) add("game-practice", item, {"one"}).attempt = attempt;
        add("game", 5, {"one"});
        start();
    }
};

void choose(Driver& driver, bool rightly) {
    REQUIRE(driver.toAnswer());
    const auto index = static_cast<std::size_t>(driver.session->trialUnderWay());
    const int target = driver.plan.trials[index].targetPlace();
    driver.choose(rightly ? target : (target + 1) % 3);
}

}  // namespace

TEST_SUITE("studies/session_game") {
    TEST_CASE("a clip is played as often as the study says before the answer opens, and every play is told") {
        Stage stage = gameStage();
        stage.plays = 3;
        stage.max_replays = 1;
        Playing driver(stage, 1);
        REQUIRE(driver.toAnswer());
        CHECK(driver.count(NoteKind::stimulus_onset) == 3);
        CHECK(driver.last(NoteKind::stimulus_onset).detail == "play 3");
        driver.press(button_id::replay);
        REQUIRE(driver.toAnswer());
        CHECK_MESSAGE(driver.count(NoteKind::stimulus_onset) == 4, "a replay is one play");
        CHECK(driver.last(NoteKind::stimulus_onset).detail == "replay 1");
        CHECK_FALSE(driver.frame.panel.has_value());
        driver.choose(0);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].plays == std::vector<int>{4});
        CHECK(driver.responses[0].replays == 1);
    }

    TEST_CASE("a trial whose time runs out is kept without a choice, and the next one follows") {
        Stage stage = gameStage();
        stage.time_limit_s = 12.0;
        Playing driver(stage);
        REQUIRE(driver.toAnswer());
        driver.wait(6.0);
        CHECK(driver.frame.notice.empty());
        driver.step(pauseFor(PauseReason::escape));
        driver.wait(20.0);
        CHECK_MESSAGE(driver.responses.empty(), "a pause takes no time");
        driver.press(button_id::resume);
        driver.wait(2.0);
        CHECK(driver.frame.notice.find("seconds left") != std::string::npos);
        REQUIRE(driver.waitUntil([&] { return !driver.responses.empty(); }));
        const Response& late = driver.responses[0];
        CHECK(late.status == ResponseStatus::timed_out);
        CHECK(late.chosenPlace() == -1);
        CHECK_FALSE(late.correct());
        CHECK(late.answers.empty());
        CHECK(late.input.empty());
        CHECK(late.response_time_s == doctest::Approx(12.0));
        CHECK(driver.frame.notice == LanguageTable::english()("notice_time_up"));
        REQUIRE(driver.toAnswer());
        driver.choose(0);
        CHECK(driver.responses.back().status == ResponseStatus::answered);
        CHECK(driver.responses.back().trial_index == 1);
    }

    TEST_CASE("a choice just within the limit counts, one that went down after it does not") {
        Stage stage = gameStage();
        stage.time_limit_s = 2.0;
        for (const bool within : {true, false}) {
            CAPTURE(within);
            Playing driver(stage, 1);
            REQUIRE(driver.toAnswer());
            const double limit_s = driver.last(NoteKind::motion_end).at.time_s + 2.0;
            while (driver.time_s + driver.frame_time_s < limit_s) driver.step();
            driver.select_ago_s = driver.time_s + driver.frame_time_s - limit_s + (within ? 0.001 : -0.001);
            driver.choose(1);
            REQUIRE(driver.responses.size() == 1);
            CHECK((driver.responses[0].status == ResponseStatus::answered) == within);
            CHECK(driver.responses[0].response_time_s <= 2.0 + 1e-9);
        }
    }

    TEST_CASE("feedback shows the target for about a second after the choice, also after a wrong one") {
        Stage stage = gameStage();
        stage.feedback = true;
        for (const bool rightly : {true, false}) {
            CAPTURE(rightly);
            Playing driver(stage, 1);
            choose(driver, rightly);
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].correct() == rightly);
            CHECK(driver.state() == "chosen-across");
            for (const BallView& ball : driver.frame.balls) CHECK(ball.look != BallLook::revealed);
            REQUIRE(driver.waitUntil([&] { return driver.state() == "feedback-across"; }));
            const double revealed_s = driver.time_s;
            const auto target = static_cast<std::size_t>(driver.plan.trials[0].targetPlace());
            CHECK(driver.frame.balls[target].look == BallLook::revealed);
            CHECK(driver.frame.notice.find(rightly ? "Correct" : "green ball") != std::string::npos);
            CHECK(driver.count(NoteKind::feedback) == 1);
            driver.wait(0.5);
            driver.step(pauseFor(PauseReason::escape));
            driver.wait(2.0);
            for (const BallView& ball : driver.frame.balls) CHECK(ball.look != BallLook::revealed);
            const double resumed_s = driver.time_s;
            driver.press(button_id::resume);
            CHECK(driver.frame.balls[target].look == BallLook::revealed);
            REQUIRE(driver.waitUntil([&] { return driver.frame.balls.empty(); }));
            CHECK(driver.time_s - revealed_s - (resumed_s - revealed_s - 0.5) ==
                  doctest::Approx(1.0).epsilon(0.1));
            CHECK(driver.responses.size() == 1);
        }
    }

    TEST_CASE("a confidence is asked after the choice; both are one response, timed by the choice") {
        for (const bool slides : {false, true}) {
            CAPTURE(slides);
            Stage stage = gameStage();
            stage.confidence = confidence(slides ? slider(0, 100) : five_steps);
            Playing driver(stage);
            REQUIRE(driver.toAnswer());
            driver.wait(0.5);
            driver.choose(1);
            const double chosen_s = driver.time_s;
            CHECK(driver.state() == "confidence-across");
            CHECK(driver.frame.balls[1].look == BallLook::chosen);
            CHECK(driver.responses.empty());
            if (!slides) {
                driver.step();
                driver.press(button_id::first_rating + 1);
                CHECK_MESSAGE(driver.responses.empty(), "a double click gives no confidence");
            }
            driver.step(pauseFor(PauseReason::escape));
            driver.wait(3.0);
            driver.press(button_id::resume);
            CHECK(driver.state() == "confidence-across");
            driver.wait(0.6);
            if (slides) {
                CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
                setSlider(driver, button_id::first_slider, 83);
                CHECK(driver.responses.empty());
                driver.press(button_id::go_on);
            } else {
                driver.press(button_id::first_rating + 3);
            }
            REQUIRE(driver.responses.size() == 1);
            const Response& response = driver.responses[0];
            CHECK(response.chosenPlace() == 1);
            CHECK(answerTo(response, "confidence") == (slides ? 83.0 : 4.0));
            CHECK(response.answered.time_s == chosen_s);
            CHECK(response.response_time_s == doctest::Approx(chosen_s - response.motion_end.time_s));
            CHECK(response.pauses == 1);
            CHECK(driver.state() == "chosen-across");
            CHECK(markedOptions(driver.frame) ==
                  std::vector<int>{slides ? button_id::go_on : button_id::first_rating + 3});
            CHECK(driver.count(NoteKind::early_select) == 0);
        }
    }

    TEST_CASE("where interrupted trials are repeated, a choice that waits for its confidence stands") {
        Stage stage = gameStage();
        stage.confidence = confidence(five_steps);
        Playing driver(stage, 1);
        driver.study.after_interruption = AfterInterruption::repeat;
        REQUIRE(driver.toAnswer());
        driver.choose(2);
        driver.step(pauseFor(PauseReason::tracking_lost));
        driver.wait(0.5);
        driver.press(button_id::resume);
        CHECK(driver.state() == "confidence-across");
        CHECK(driver.count(NoteKind::trial_repeated) == 0);
    }

    TEST_CASE("practice gives feedback where the practice says so, whatever the game does") {
        for (const bool in_practice : {true, false}) {
            CAPTURE(in_practice);
            Practising driver(0.0, 1, false);
            driver.stage("game-practice").feedback = in_practice;
            driver.stage("game").feedback = !in_practice;
            choose(driver, true);
            choose(driver, true);
            choose(driver, true);
            REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
            CHECK(driver.count(NoteKind::feedback) == (in_practice ? 2 : 1));
        }
    }

    TEST_CASE("practice that meets its criterion ends; its further attempts are not done") {
        Practising driver(0.5, 3, false);
        choose(driver, false);
        choose(driver, true);
        CHECK(driver.count(NoteKind::practice_met) == 1);
        CHECK(driver.last(NoteKind::practice_met).detail == "0.50");
        choose(driver, true);
        CHECK(trialsOf(driver.practised) == std::vector<int>{0, 1});
        CHECK(trialsOf(driver.responses) == std::vector<int>{6});
        REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
        CHECK(driver.finished());
    }

    TEST_CASE("practice that fails is done again after its page, as often as the study allows") {
        Practising driver(1.0, 2, false);
        choose(driver, true);
        choose(driver, false);
        CHECK(driver.count(NoteKind::practice_failed) == 1);
        REQUIRE(driver.waitUntil([&] { return driver.state() == "practice-again"; }));
        CHECK(textOf(*driver.frame.panel).find("Look at the finger.") != std::string::npos);
        choose(driver, false);
        CHECK(driver.session->progress().stages[0].done == 3);
        choose(driver, true);
        CHECK(driver.count(NoteKind::practice_failed) == 2);
        choose(driver, true);
        CHECK_MESSAGE(trialsOf(driver.responses) == std::vector<int>{4}, "the session goes on");
        CHECK(driver.exclusions.empty());
    }

    TEST_CASE("practice that fails at last ends the session where the study wants that") {
        Practising driver(1.0, 2, true);
        for (int i = 0; i < 4; ++i) choose(driver, i % 2 == 0);
        REQUIRE(driver.waitUntil([&] { return driver.state() == "closing"; }));
        REQUIRE(driver.exclusions.size() == 1);
        CHECK(driver.exclusions[0].reason == "practice failed: game-practice");
        CHECK(driver.practised.back().exclusion == "practice failed: game-practice");
        driver.leavePage();
        CHECK(driver.session->outcome() == SessionOutcome::excluded);
        CHECK(driver.responses.empty());
        // Whoever comes back after all is not let past it.
        driver.restart();
        driver.step();
        CHECK(driver.state() == "closing");
    }

    TEST_CASE("a session that breaks off in practice goes on in it, and not before it") {
        Practising driver(1.0, 2, false);
        choose(driver, true);
        choose(driver, false);
        choose(driver, true);
        driver.restart();
        driver.step();
        CHECK(driver.state() == "welcome-back");
        choose(driver, true);
        CHECK(driver.count(NoteKind::practice_met) == 1);
        choose(driver, true);
        CHECK(trialsOf(driver.practised) == std::vector<int>{0, 1, 2, 3});
        CHECK(trialsOf(driver.responses) == std::vector<int>{4});
    }
}
