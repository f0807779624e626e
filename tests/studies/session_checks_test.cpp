// Attention checks: how they are shown, when they pass, and what follows when they do not.
#include <doctest/doctest.h>

#include <algorithm>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

AttentionChecks checksOf(CheckKind kind, CheckRule rule = CheckRule::note, int after_failures = 1,
                         double tolerance = 0.0) {
    AttentionChecks checks;
    checks.kind = kind;
    checks.rule = rule;
    checks.after_failures = after_failures;
    checks.tolerance = tolerance;
    return checks;
}

/// Ratings of which every trial asks for a number.
struct Numbers : Driver {
    Numbers(const AttentionChecks& checks, const std::vector<double>& expected, double clip_s = 0.5)
        : Driver({ratingStage()}, clip_s) {
        stage("rating").checks = {checks};
        for (const double number : expected)
            add("rating", 0, {"one"}).check = TrialCheck{CheckKind::number, 0, number, -1};
        add("rating", 1, {"one"});
        start();
    }
};

void rate(Driver& driver, int value) {
    REQUIRE(driver.toAnswer());
    driver.digit(value);
}

}  // namespace

TEST_SUITE("studies/session_checks") {
    TEST_CASE("the number is shown beside the avatar's head from the clip's middle to its end") {
        Numbers driver(checksOf(CheckKind::number), {4.0}, 2.0);
        REQUIRE(driver.toState("playing"));
        REQUIRE(driver.waitUntil([&] { return driver.count(NoteKind::stimulus_onset) == 1; }));
        const double onset_s = driver.last(NoteKind::stimulus_onset).at.time_s;
        double first_s = 0.0;
        while (!answersOpen(driver.frame)) {
            driver.step();
            CHECK(driver.frame.sign.has_value() == (driver.state() == "check"));
            if (!driver.frame.sign || first_s > 0.0) continue;
            first_s = driver.time_s;
            CHECK(textOf(*driver.frame.sign).find("4") != std::string::npos);
            CHECK(driver.frame.sign->buttons.empty());
            const auto head = static_cast<std::size_t>(driver.avatar.find("head"));
            const Vec3 centre =
                transformPoint(driver.frame.sign->stage_from_panel,
                               {driver.frame.sign->width_m / 2.0, driver.frame.sign->height_m / 2.0, 0.0});
            CHECK(glm::length(centre - driver.frame.avatar_joints[head].position) < 0.8);
        }
        CHECK(first_s - onset_s == doctest::Approx(1.0).epsilon(0.03));
        CHECK_FALSE(driver.frame.sign.has_value());
        rate(driver, 2);
        REQUIRE(driver.toState("pointing"));
        CHECK_MESSAGE(!driver.frame.sign.has_value(), "the next trial is no check");
    }

    TEST_CASE("a pause takes the number away, and the clip shows it again") {
        Numbers driver(checksOf(CheckKind::number), {4.0}, 2.0);
        REQUIRE(driver.toState("check"));
        driver.step(pauseFor(PauseReason::escape));
        CHECK_FALSE(driver.frame.sign.has_value());
        driver.wait(0.5);
        driver.press(button_id::resume);
        CHECK_FALSE(driver.frame.sign.has_value());
        REQUIRE(driver.toState("check"));
        CHECK(driver.frame.sign.has_value());
    }

    TEST_CASE("a number passes within the tolerance") {
        for (int given = 1; given <= 5; ++given) {
            CAPTURE(given);
            Numbers driver(checksOf(CheckKind::number, CheckRule::note, 1, 1.0), {4.0});
            rate(driver, given);
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].check_passed == (given >= 3));
            CHECK(driver.count(NoteKind::check_failed) == (given >= 3 ? 0 : 1));
            CHECK(driver.session->progress().checks_passed == (given >= 3 ? 1 : 0));
            CHECK(driver.session->progress().checks_failed == (given >= 3 ? 0 : 1));
            rate(driver, 1);
            CHECK_FALSE(driver.responses[1].check_passed.has_value());
        }
    }

    TEST_CASE("on a parallel page the number is shown with its own stimulus, and looked for in its rating") {
        for (const int given : {73, 40}) {
            CAPTURE(given);
            Stage stage = parallelStage(slider(0, 100));
            stage.checks = {checksOf(CheckKind::number, CheckRule::note, 1, 3.0)};
            Driver driver({stage});
            driver.add("parallel", 0, {"one", "two"}).check = TrialCheck{CheckKind::number, 1, 73.0, -1};
            driver.start();
            for (const int i : {0, 1}) {
                bool signs = false;
                driver.waitUntil([&] { return hasButton(driver.frame, button_id::first_play + i); });
                driver.wait(0.45);
                driver.press(button_id::first_play + i);
                while (driver.count(NoteKind::motion_end) == i) {
                    driver.step();
                    signs = signs || driver.frame.sign.has_value();
                }
                CHECK(signs == (i == 1));
                driver.step();
                CHECK_FALSE(driver.frame.sign.has_value());
                setSlider(driver, button_id::first_slider + i, i == 1 ? given : 10);
            }
            driver.step();
            driver.press(button_id::go_on);
            REQUIRE(driver.responses.size() == 1);
            CHECK(driver.responses[0].check_passed == (given == 73));
        }
    }

    TEST_CASE("a catch passes when the choice is right") {
        for (const int turn : {0, 1, 2}) {
            CAPTURE(turn);
            Stage stage = gameStage();
            stage.checks = {checksOf(CheckKind::catch_trial)};
            Driver driver({stage});
            driver.add("game", 0, {"one"}).check = TrialCheck{CheckKind::catch_trial, 0, 0.0, -1};
            driver.start();
            REQUIRE(driver.toAnswer());
            driver.choose(turn);
            const bool right = turn == driver.plan.trials[0].targetPlace();
            CHECK(driver.responses[0].check_passed == right);
            CHECK(driver.responses[0].correct() == right);
        }
    }

    TEST_CASE("a repeated rating passes near its first, also when that was given in an earlier session") {
        for (const bool visits : {false, true})
            for (const int again : {1, 3, 4, 5}) {
                CAPTURE(visits);
                CAPTURE(again);
                Stage stage = ratingStage();
                stage.checks = {checksOf(CheckKind::repeat, CheckRule::note, 1, 1.0)};
                Driver driver({stage});
                driver.add("rating", 0, {"one"});
                driver.add("rating", 1, {"one"});
                driver.add("rating", 0, {"one"}).check = TrialCheck{CheckKind::repeat, 0, 0.0, 0};
                driver.start();
                rate(driver, 4);
                rate(driver, 1);
                if (visits) driver.restart();
                rate(driver, again);
                CHECK(driver.responses.back().check_passed == (again >= 3));
            }
    }

    TEST_CASE("without the first answer a repeat is not judged") {
        Stage stage = ratingStage();
        stage.checks = {checksOf(CheckKind::repeat)};
        Driver driver({stage});
        driver.add("rating", 0, {"one"});
        driver.add("rating", 0, {"one"}).check = TrialCheck{CheckKind::repeat, 0, 0.0, 0};
        driver.start({0});
        rate(driver, 4);
        CHECK_FALSE(driver.responses[0].check_passed.has_value());
    }

    TEST_CASE("a repeated choice is the same ball, wherever it stands in the record") {
        for (const int place : {0, 1, 2}) {
            CAPTURE(place);
            Stage stage = gameStage();
            stage.checks = {checksOf(CheckKind::repeat)};
            Driver driver({stage});
            driver.add("game", 0, {"one"}).ball_order = {2, 0, 1};
            Trial& again = driver.add("game", 0, {"one"});
            again.check = TrialCheck{CheckKind::repeat, 0, 0.0, 0};
            again.ball_order = {0, 1, 2};
            driver.start();
            REQUIRE(driver.toAnswer());
            driver.choose(0);  // ball 2
            REQUIRE(driver.toAnswer());
            driver.choose(place);
            CHECK(driver.responses[1].check_passed == (place == 2));
        }
    }

    TEST_CASE("a repeated pair is compared by system, though left and right have changed") {
        for (const int key : {1, 3, 4, 5}) {
            CAPTURE(key);
            Stage stage = pairStage();
            stage.checks = {checksOf(CheckKind::repeat)};
            Driver driver({stage});
            driver.add("pairs", 0, {"one", "two"});
            driver.add("pairs", 0, {"two", "one"}).check = TrialCheck{CheckKind::repeat, 0, 0.0, 0};
            driver.start();
            for (const int given : {2, key}) {
                REQUIRE(playToEnd(driver, 0));
                REQUIRE(playToEnd(driver, 1));
                driver.digit(given);
            }
            CHECK(driver.responses[1].check_passed == (key == 4));
        }
    }

    TEST_CASE("a rule holds from the failure on that the study says; warnings are pages") {
        Numbers driver(checksOf(CheckKind::number, CheckRule::warn, 2), {5.0, 5.0, 5.0});
        rate(driver, 1);
        CHECK(driver.count(NoteKind::warned) == 0);
        rate(driver, 1);
        REQUIRE(driver.waitUntil([&] { return driver.state() == "attention"; }));
        CHECK(driver.count(NoteKind::warned) == 1);
        CHECK(driver.session->trialUnderWay() == -1);
        rate(driver, 5);
        rate(driver, 1);
        CHECK(driver.count(NoteKind::warned) == 1);
        CHECK(driver.exclusions.empty());
    }

    TEST_CASE("failures of earlier sessions count") {
        Numbers driver(checksOf(CheckKind::number, CheckRule::exclude, 2), {5.0, 5.0});
        rate(driver, 1);
        CHECK(driver.exclusions.empty());
        driver.restart();
        rate(driver, 1);
        REQUIRE(driver.exclusions.size() == 1);
        CHECK(driver.exclusions[0].reason == "attention check failed: rating, trial 1");
        CHECK(driver.session->progress().checks_failed == 2);
    }

    TEST_CASE("a rule counts the failures of its own kind of check alone, also those of earlier sessions") {
        Stage stage = ratingStage();
        stage.checks = {checksOf(CheckKind::number, CheckRule::exclude, 2),
                        checksOf(CheckKind::repeat, CheckRule::note)};
        Driver driver({stage});
        driver.add("rating", 0, {"one"}).check = TrialCheck{CheckKind::number, 0, 5.0, -1};
        driver.add("rating", 1, {"one"});
        driver.add("rating", 1, {"one"}).check = TrialCheck{CheckKind::repeat, 0, 0.0, 1};
        driver.add("rating", 1, {"one"}).check = TrialCheck{CheckKind::repeat, 0, 0.0, 1};
        driver.add("rating", 2, {"one"}).check = TrialCheck{CheckKind::number, 0, 5.0, -1};
        driver.start();
        for (const int given : {1, 2, 4}) rate(driver, given);  // a number and a repeat fail
        CHECK(driver.count(NoteKind::check_failed) == 2);
        driver.restart();
        rate(driver, 5);  // another repeat
        CHECK(driver.session->progress().checks_failed == 3);
        CHECK(driver.exclusions.empty());
        rate(driver, 1);  // the second number
        REQUIRE(driver.exclusions.size() == 1);
        CHECK(driver.exclusions[0].reason == "attention check failed: rating, trial 4");
    }

    TEST_CASE("what follows from an answer comes with it, so that nothing can part them") {
        Numbers driver(checksOf(CheckKind::number, CheckRule::end), {5.0});
        rate(driver, 1);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].exclusion == "attention check failed: rating, trial 0");
        CHECK(std::none_of(driver.all_events.begin(), driver.all_events.end(), [](const SessionEvent& event) {
            return std::holds_alternative<Exclusion>(event);
        }));
    }

    TEST_CASE("an exclusion lets the session go on, and is told once") {
        Numbers driver(checksOf(CheckKind::number, CheckRule::exclude), {5.0, 5.0});
        rate(driver, 1);
        rate(driver, 1);
        CHECK(driver.exclusions.size() == 1);
        rate(driver, 3);
        REQUIRE(driver.finish());
        CHECK(driver.responses.size() == 3);
    }

    TEST_CASE("a rule that ends the session does so after the answer has been kept") {
        Numbers driver(checksOf(CheckKind::number, CheckRule::end), {5.0, 5.0});
        REQUIRE(driver.toAnswer());
        driver.kept = false;
        driver.digit(1);
        CHECK(driver.exclusions.size() == 1);
        driver.wait(1.0);
        CHECK(driver.state() == "rated");
        driver.kept = true;
        REQUIRE(driver.waitUntil([&] { return driver.state() == "closing"; }));
        driver.leavePage();
        CHECK(driver.session->outcome() == SessionOutcome::excluded);
        CHECK(driver.responses.size() == 1);
        CHECK(driver.count(NoteKind::finished) == 0);
    }
}
