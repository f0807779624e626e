// Sessions that break off and go on, and what the operator does to a session under way.
#include <doctest/doctest.h>

#include "core/random.hpp"
#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// A study with every kind of stage, in one session.
struct Everything : Driver {
    Everything() : Driver(stages(), 0.2) {
        study.inter_trial_s = 0.5;
        frame_time_s = 1.0 / 30.0;
        add("consent", 0, {});
        for (const int page : {0, 1}) add("questions", 0, {}).page = page;
        for (const int attempt : {0, 1}) add("game-practice", 0, {"one"}).attempt = attempt;
        for (const int item : {1, 2}) add("game", item, {"one"});
        add("rating", 3, {"one"});
        add("parallel", 4, {"one", "two"});
        add("pairs", 5, {"one", "two"});
    }

    static std::vector<Stage> stages() {
        Stage practice = practiceOf(gameStage());
        practice.practice = Practice{"game", 1.0, 2, false, "Once more."};
        Stage game = gameStage();
        game.confidence = question("sure", QuestionKind::scale);
        game.feedback = true;
        game.break_every = 1;
        Stage pairs = pairStage();
        pairs.reasons = question("why", QuestionKind::choice);
        const std::vector<Question> questions{question("a", QuestionKind::scale),
                                              question("b", QuestionKind::scale)};
        return {pageStage("welcome", "Hello."),
                pageStage("consent", "May we?", StageKind::consent),
                questionnaireStage(questions, 1),
                pageStage("how", "Watch."),
                practice,
                game,
                pageStage("rest", "Rest.", StageKind::rest),
                ratingStage(),
                parallelStage(slider(0, 10)),
                pairs,
                pageStage("thanks", "Thanks.")};
    }
};

std::string pagesRead(const Driver& driver) {
    std::string pages_read;
    for (const Note& note : driver.notes)
        if (note.kind == NoteKind::instructions_read) pages_read += note.detail + " ";
    return pages_read;
}

}  // namespace

TEST_SUITE("studies/session_resume") {
    TEST_CASE("what is left is what was not answered, in order, of one visit and without vain practice") {
        Everything driver;
        const auto left = [&](const std::map<int, bool>& answered) {
            return trialsLeft(driver.study, driver.plan, answered);
        };
        CHECK(left({}) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
        CHECK_MESSAGE((left({{0, true}, {3, true}}) == std::vector<int>{1, 2, 5, 6, 7, 8, 9}),
                      "practice met");
        CHECK_MESSAGE((left({{3, false}}) == std::vector<int>{0, 1, 2, 4, 5, 6, 7, 8, 9}), "practice failed");
        CHECK_MESSAGE((left({{5, false}}) == std::vector<int>{0, 1, 2, 6, 7, 8, 9}), "the game has begun");
        driver.stage("parallel").session = 2;
        driver.stage("pairs").session = 2;
        CHECK(left({{0, true}, {3, true}}) == std::vector<int>{1, 2, 5, 6, 7});
        CHECK(left({{0, true}, {1, true}, {2, true}, {5, true}, {6, true}, {7, true}}) ==
              std::vector<int>{8, 9});
    }

    TEST_CASE("a whole session of every kind of stage answers each unit once, and tells how far it is") {
        Everything driver;
        driver.start();
        REQUIRE(carryOnUntil(driver, [&] { return driver.session->trialUnderWay() == 8; }));
        const SessionProgress progress = driver.session->progress();
        REQUIRE(progress.stages.size() == 11);
        for (const StageProgress& stage : progress.stages) {
            CAPTURE(stage.name);
            CHECK(stage.current == (stage.name == "parallel"));
            const bool page = stage.name == "welcome" || stage.name == "how" || stage.name == "rest";
            if (page) CHECK((stage.of == 0 && stage.done == 1));
            if (stage.name == "questions") CHECK((stage.of == 2 && stage.done == 2));
            if (stage.name == "pairs") CHECK((stage.of == 1 && stage.done == 0));
        }
        CHECK(progress.trial.find("one T005, two T005") != std::string::npos);
        REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
        CHECK(driver.finished());
        CHECK(trialsOf(driver.responses) == std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9});
        CHECK(pagesRead(driver) == "welcome how thanks ");
        CHECK(driver.count(NoteKind::break_end) == 2);
    }

    TEST_CASE("killed after any event, a further session asks exactly what was not kept") {
        std::size_t events = 0;
        for (std::size_t killed = 0; killed == 0 || killed < events; ++killed) {
            CAPTURE(killed);
            Everything driver;
            if (killed > 0) driver.max_events = killed;
            driver.start();
            REQUIRE(carryOnUntil(
                driver, [&] { return !driver.running() || driver.all_events.size() >= driver.max_events; }));
            if (killed == 0) {
                events = driver.all_events.size();
                CHECK(driver.finished());
                continue;
            }
            driver.max_events = 100000;
            const std::set<int> begun = driver.left.begun;
            const std::map<int, bool> before = driver.left.answered;
            const std::vector<int> left = trialsLeft(driver.study, driver.plan, before);
            driver.notes.clear();
            driver.restart();
            REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
            CHECK(driver.finished());
            CHECK((driver.last(NoteKind::session_start).detail.empty() == before.empty()));
            CHECK_MESSAGE(trialsLeft(driver.study, driver.plan, driver.left.answered).empty(), left.size());
            std::vector<int> all = trialsOf(driver.responses);
            CHECK(all == std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9});
            std::set<int> practised;
            for (const Response& response : driver.practised)
                CHECK(practised.insert(response.trial_index).second);
            for (const auto* kept : {&driver.responses, &driver.practised})
                for (const Response& response : *kept)
                    if (before.count(response.trial_index) == 0)
                        CHECK(response.begun_before == (begun.count(response.trial_index) > 0));
            // Pages that led to what had begun do not come again; those to what had not, do.
            const bool welcome = pagesRead(driver).find("welcome ") != std::string::npos;
            CHECK(welcome == before.empty());
            CHECK((pagesRead(driver).find("welcome-back") != std::string::npos) ==
                  (!before.empty() && !left.empty()));
        }
        CHECK(events > 40);
    }

    TEST_CASE("a pause in any state is left again where it was, and the session goes on to its end") {
        std::vector<std::string> states;
        {
            Everything driver;
            driver.start();
            while (driver.running()) {
                const std::string before = driver.state();
                carryOn(driver);
                if (driver.state() != before) states.push_back(driver.state());
            }
        }
        CHECK(states.size() > 50);
        for (const bool repeats : {false, true})
            for (std::size_t nth = 0; nth + 1 < states.size(); ++nth) {
                CAPTURE(nth);
                CAPTURE(states[nth]);
                Everything driver;
                if (repeats) driver.study.after_interruption = AfterInterruption::repeat;
                driver.start();
                std::size_t changes = 0;
                while (changes <= nth) {
                    const std::string before = driver.state();
                    carryOn(driver);
                    if (driver.state() != before) ++changes;
                }
                CHECK(driver.state() == states[nth]);
                const std::size_t kept = driver.left.answered.size();
                driver.step(pauseFor(PauseReason::escape));
                CHECK(driver.state() == "paused");
                CHECK_FALSE(driver.frame.sign.has_value());
                driver.wait(0.5);
                CHECK(driver.left.answered.size() == kept);
                driver.press(button_id::resume);
                CHECK(driver.state() != "paused");
                driver.step();  // the ray leaves the button; it may rest on what has opened there
                REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
                CHECK(driver.finished());
                CHECK(trialsOf(driver.responses) == std::vector<int>{0, 1, 2, 5, 6, 7, 8, 9});
                CHECK(driver.count(NoteKind::pause) == 1);
                int pauses = 0;
                for (const Response& response : driver.responses) pauses += response.pauses;
                CHECK(pauses <= 1);
            }
    }

    TEST_CASE("instructions come again after a long time, also those before the practice, but no break") {
        for (const bool long_ago : {false, true})
            for (const bool practised : {false, true}) {
                CAPTURE(long_ago);
                CAPTURE(practised);
                Driver driver({pageStage("welcome", "Hello."),
                               questionnaireStage({question("a", QuestionKind::scale)}),
                               pageStage("how", "Watch."), practiceOf(gameStage()),
                               pageStage("rest", "Rest.", StageKind::rest), pageStage("now", "It counts."),
                               gameStage()});
                driver.add("questions", 0, {});
                driver.add("game-practice", 0, {"one"});
                for (const int item : {1, 2}) driver.add("game", item, {"one"});
                driver.study.instructions_again_after_s = 100.0;
                driver.left.gap_s = long_ago ? 101.0 : 100.0;
                driver.start(practised ? std::set<int>{0, 1, 2} : std::set<int>{0});
                REQUIRE(driver.toAnswer());
                CHECK(pagesRead(driver) == (!practised ? "welcome-back how "
                                            : long_ago ? "welcome-back how now "
                                                       : "welcome-back "));
            }
    }

    TEST_CASE("the last trial is done again right away, its answer marked") {
        Driver driver(2, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.digit(1);
        REQUIRE(driver.waitUntil([&] { return driver.session->trialUnderWay() == 1; }));
        driver.order(OperatorAction::repeat_last, "slipped");
        REQUIRE(driver.superseded.size() == 1);
        CHECK(driver.superseded[0].trial_index == 0);
        CHECK(driver.superseded[0].reason == "slipped");
        CHECK(driver.last(NoteKind::operator_repeat).detail == "slipped");
        CHECK(driver.session->trialUnderWay() == 0);
        driver.order(OperatorAction::repeat_last);
        CHECK(driver.superseded.size() == 1);
        CHECK(driver.last(NoteKind::operator_repeat).detail == "nothing to repeat");
        REQUIRE(driver.toAnswer());
        driver.digit(5);
        REQUIRE(driver.finish());
        CHECK(trialsOf(driver.responses) == std::vector<int>{0, 0, 1, 2, 3, 4, 5, 6, 7});
        CHECK(ratingOf(driver.responses[1]) == 5);
    }

    TEST_CASE("where the next clip has been seen, the repeated trial follows it") {
        Driver driver(2, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.digit(1);
        REQUIRE(driver.waitUntil([&] { return driver.count(NoteKind::stimulus_onset) == 2; }));
        driver.order(OperatorAction::repeat_last);
        CHECK(driver.session->trialUnderWay() == 1);
        REQUIRE(driver.finish());
        CHECK(trialsOf(driver.responses) == std::vector<int>{0, 1, 0, 2, 3, 4, 5, 6, 7});
    }

    TEST_CASE("a trial can be repeated while its answer is shown, on a page, in a pause, and at the end") {
        for (const char* when : {"rated", "break", "paused", "instructions"}) {
            CAPTURE(when);
            const bool at_end = std::string(when) == "instructions";
            Driver driver(2, 0.5, false);
            removeStage(driver.study, "game-instructions");
            driver.plan.stages = emptyPlan(driver.study).stages;
            driver.start(at_end ? std::set<int>{0, 1, 2, 4, 5, 6, 7} : std::set<int>{});
            REQUIRE(driver.toAnswer());
            driver.digit(1);
            if (!at_end) {
                REQUIRE(driver.toAnswer());
                driver.digit(2);
            }
            const int last = at_end ? 3 : 1;
            if (std::string(when) == "paused") {
                REQUIRE(driver.waitUntil([&] { return driver.state() == "break"; }));
                driver.step(pauseFor(PauseReason::experimenter));
            }
            REQUIRE(driver.waitUntil([&] { return driver.state() == when; }));
            driver.order(OperatorAction::repeat_last);
            if (std::string(when) == "paused") {
                driver.wait(0.5);
                CHECK(driver.state() == "paused");
                driver.press(button_id::resume);
            }
            REQUIRE(driver.waitUntil([&] { return driver.state() == "waiting"; }));
            CHECK(driver.session->trialUnderWay() == last);
            REQUIRE(driver.toAnswer());
            driver.digit(3);
            REQUIRE(driver.waitUntil([&] { return resting(driver.frame); }));
            CHECK(driver.state() == (at_end ? "instructions" : "break"));
            REQUIRE(driver.finish());
        }
    }

    TEST_CASE("a repeated check is judged by its new answer, and a repeated practice by its new choice") {
        Stage stage = ratingStage();
        AttentionChecks checks;
        checks.rule = CheckRule::exclude;
        checks.after_failures = 2;
        stage.checks = {checks};
        Driver driver({stage});
        for (int item = 0; item < 3; ++item)
            driver.add("rating", item, {"one"}).check = TrialCheck{CheckKind::number, 0, 5.0, -1};
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.digit(1);
        driver.order(OperatorAction::repeat_last);
        for (const int given : {5, 1, 5}) {
            REQUIRE(driver.toAnswer());
            driver.digit(given);
        }
        CHECK(driver.exclusions.empty());
        CHECK(driver.session->progress().checks_failed == 1);
        CHECK(driver.session->progress().checks_passed == 2);
    }

    TEST_CASE("a trial is skipped with its reason at any point, also in a pause, and the next one follows") {
        for (const char* when : {"waiting", "playing", "rating", "paused"}) {
            CAPTURE(when);
            Driver driver(2, 0.5, false);
            driver.start();
            const bool in_pause = std::string(when) == "paused";
            REQUIRE(driver.toState(in_pause ? "pointing" : when));
            if (in_pause) driver.step(pauseFor(PauseReason::experimenter));
            driver.order(OperatorAction::skip, "fire alarm");
            REQUIRE(driver.responses.size() == 1);
            const Response& response = driver.responses[0];
            CHECK(response.status == ResponseStatus::skipped);
            CHECK(response.reason == "fire alarm");
            CHECK(response.answers.empty());
            CHECK(response.onset.time_s > 0.0);
            CHECK(response.answered.time_s >= response.motion_end.time_s);
            CHECK(driver.last(NoteKind::operator_skip).detail == "fire alarm");
            if (in_pause) {
                driver.wait(0.5);
                CHECK(driver.state() == "paused");
                driver.press(button_id::resume);
            }
            REQUIRE(driver.waitUntil([&] { return driver.session->trialUnderWay() == 1; }));
            REQUIRE(driver.finish());
            CHECK(driver.responses.size() == 8);
        }
    }

    TEST_CASE("no page and no consent is skipped") {
        Everything driver;
        driver.start();
        driver.step();
        driver.order(OperatorAction::skip, "?");
        CHECK(driver.last(NoteKind::operator_skip).detail == "nothing to skip");
        REQUIRE(driver.toState("consent"));
        driver.order(OperatorAction::skip, "?");
        CHECK(driver.responses.empty());
        CHECK(driver.state() == "consent");
        REQUIRE(carryOnUntil(driver, [&] { return driver.state() == "questionnaire"; }));
        driver.order(OperatorAction::repeat_last);
        CHECK_MESSAGE(driver.superseded.empty(), "a consent is not asked twice");
        driver.order(OperatorAction::skip, "refused");
        CHECK(driver.responses.back().status == ResponseStatus::skipped);
    }

    TEST_CASE("an abort ends the session at once; a note is kept with the trial under way") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(driver.toState("playing"));
        driver.order(OperatorAction::note, "laughs");
        CHECK(driver.last(NoteKind::operator_note).detail == "laughs");
        CHECK(driver.last(NoteKind::operator_note).trial_index == 0);
        driver.order(OperatorAction::abort, "unwell");
        CHECK(driver.last(NoteKind::operator_abort).detail == "unwell");
        CHECK(driver.session->outcome() == SessionOutcome::aborted);
        CHECK(driver.state() == "over");
        CHECK(driver.session->trialUnderWay() == -1);
        CHECK(driver.responses.empty());
        driver.order(OperatorAction::note, "late");
        CHECK(driver.count(NoteKind::operator_note) == 1);
    }

    TEST_CASE("over 20 seeds of an impatient operator every trial has one answer that counts") {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            CAPTURE(seed);
            Random random(seed, "operator");
            Everything driver;
            driver.start();
            for (int i = 0; i < 60000 && !driver.finished(); ++i) {
                const double dice = random.uniform();
                if (dice < 0.004)
                    driver.order(OperatorAction::repeat_last, "again");
                else if (dice < 0.006)
                    driver.order(OperatorAction::skip, "skip");
                else if (dice < 0.010)
                    driver.step(pauseFor(PauseReason::experimenter));
                else if (hasButton(driver.frame, button_id::resume))
                    driver.press(button_id::resume);
                else if (dice < 0.012)
                    driver.restart();
                else
                    carryOn(driver);
            }
            REQUIRE(driver.finished());
            std::map<int, int> counts;
            for (const Response& response : driver.responses) ++counts[response.trial_index];
            for (const Response& response : driver.practised) ++counts[response.trial_index];
            for (const Superseded& again : driver.superseded) --counts[again.trial_index];
            for (const auto& counted : counts) {
                const int index = counted.first;
                const int count = counted.second;
                CAPTURE(index);
                CHECK((count == 1 ||
                       (driver.plan.trials[static_cast<std::size_t>(index)].practice && count == 0)));
            }
            for (const int index : {0, 1, 2, 5, 6, 7, 8, 9}) CHECK(counts[index] == 1);
        }
    }
}
