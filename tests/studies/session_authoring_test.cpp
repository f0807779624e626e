// Authoring: what a page tells is kept, with the time that it took.
#include <doctest/doctest.h>

#include <string>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Stage authoringStage(double limit_s = 60.0) {
    Stage stage;
    stage.name = "authoring";
    stage.kind = StageKind::authoring;
    stage.question = "Make gestures.";
    stage.authoring.keyframes_only = {"MANUAL"};
    stage.authoring.limit_s = limit_s;
    stage.authoring.practice_limit_s = 20.0;
    stage.authoring.practice_per_block = 1;
    stage.authoring.may_end_early = true;
    return stage;
}

struct Authoring : Driver {
    explicit Authoring(const Stage& stage = authoringStage(), bool practice = false) : Driver({stage}) {
        Trial& first = add("authoring", 0, {"SGT"});
        first.layout = "across";
        first.practice = practice;
        add("authoring", 1, {"MANUAL"}).layout = "across";
        start();
        step();
    }

    [[nodiscard]] const AuthoringTask& task() const {
        REQUIRE(frame.authoring.has_value());
        return *frame.authoring;
    }
    void tell(const std::string& project, int edits, bool finished = false) {
        InputFrame input;
        input.work = AuthoredWork{task().trial, {project, edits, 2, 1, 1}, finished};
        step(input);
    }
};

std::string keptText(const Response& response, const std::string& name) {
    for (const KeptValue& value : response.values)
        if (value.name == name) return value.text;
    return "(none)";
}

}  // namespace

TEST_SUITE("studies/session_authoring") {
    TEST_CASE("a trial begins with the stimulus' project, and tells whose means and how long") {
        const Authoring driver;
        CHECK(driver.frame.state == PresentedState::authoring);
        CHECK_FALSE(driver.frame.scene_visible);
        CHECK_FALSE(driver.frame.panel.has_value());
        CHECK(driver.task().trial == 1);
        CHECK(driver.task().of == 2);
        CHECK(driver.task().system == "SGT");
        CHECK_FALSE(driver.task().keyframes_only);
        CHECK_FALSE(driver.task().practice);
        CHECK(driver.task().so_far.project == R"({"version":2})");
        CHECK(driver.task().limit_s == 60.0);
        CHECK(driver.task().may_end_early);
    }

    TEST_CASE("finishing keeps the work, with all edits told and the time used") {
        Authoring driver;
        driver.wait(10.0);
        driver.tell("{\"a\":1}", 2);
        driver.wait(5.0);
        driver.tell("{\"a\":2}", 3, true);
        REQUIRE(driver.responses.size() == 1);
        const Response& given = driver.responses[0];
        CHECK(given.status == ResponseStatus::answered);
        CHECK(given.input == "ray");
        CHECK(keptText(given, "project") == "{\"a\":2}");
        CHECK(keptNumber(given.values, "edits") == 5.0);
        CHECK(keptNumber(given.values, "generated") == 2.0);
        CHECK(keptNumber(given.values, "poses") == 2.0);
        CHECK(keptNumber(given.values, "styles") == 1.0);
        CHECK(answerTo(given, "time", 0).value_or(0.0) == doctest::Approx(15.0).epsilon(0.01));
        CHECK_FALSE(driver.frame.authoring.has_value());
        REQUIRE(driver.waitUntil([&] { return driver.frame.authoring.has_value(); }));
        CHECK(driver.task().keyframes_only);
        CHECK(driver.task().trial == 2);
        CHECK(driver.task().so_far.edits == 0);
    }

    TEST_CASE("at the time limit the latest work is the answer, after the page's last word") {
        Authoring driver;
        driver.tell("{\"a\":1}", 1);
        driver.wait(60.1);
        CHECK(driver.task().left_s == 0.0);
        CHECK(driver.responses.empty());
        driver.tell("{\"a\":2}", 1);
        REQUIRE(driver.responses.size() == 1);
        CHECK(keptText(driver.responses[0], "project") == "{\"a\":2}");
        CHECK(answerTo(driver.responses[0], "time", 0) == 60.0);
        CHECK(driver.responses[0].input.empty());
    }

    TEST_CASE("nobody waits for a page that says nothing; without work the answer is what it began with") {
        Authoring driver;
        driver.wait(61.0);
        CHECK(driver.responses.empty());
        driver.wait(1.5);
        REQUIRE(driver.responses.size() == 1);
        CHECK(keptText(driver.responses[0], "project") == R"({"version":2})");
        CHECK(keptNumber(driver.responses[0].values, "edits") == 0.0);
        CHECK(answerTo(driver.responses[0], "time", 0) == 60.0);
    }

    TEST_CASE("a trial ends early only where it may, and work of another trial is not taken") {
        Stage stage = authoringStage();
        stage.authoring.may_end_early = false;
        Authoring driver(stage);
        driver.tell("{\"a\":1}", 1, true);
        driver.wait(1.0);
        CHECK(driver.responses.empty());
        CHECK(driver.task().so_far.project == "{\"a\":1}");
        InputFrame other;
        other.work = AuthoredWork{2, {"{\"b\":1}", 1}, true};
        driver.step(other);
        CHECK(driver.task().so_far.project == "{\"a\":1}");
    }

    TEST_CASE("practice has its own limit, is marked, and kept apart") {
        Authoring driver(authoringStage(), true);
        CHECK(driver.task().practice);
        CHECK(driver.task().limit_s == 20.0);
        CHECK_FALSE(driver.task().may_end_early);
        driver.wait(22.5);
        CHECK(driver.responses.empty());
        REQUIRE(driver.practised.size() == 1);
        CHECK(answerTo(driver.practised[0], "time", 0) == 20.0);
    }

    TEST_CASE("a pause is not counted, and work that comes late is taken in it") {
        Authoring driver;
        driver.wait(10.0);
        driver.step(pauseFor(PauseReason::unsaid));
        CHECK(driver.frame.state == PresentedState::paused);
        const double left_s = driver.task().left_s;
        driver.wait(100.0);
        driver.tell("{\"late\":1}", 1);
        CHECK(driver.task().left_s == left_s);
        driver.press(button_id::resume);
        driver.step();
        CHECK(driver.frame.state == PresentedState::authoring);
        CHECK(driver.task().so_far.project == "{\"late\":1}");
        CHECK(driver.task().left_s == doctest::Approx(left_s).epsilon(0.01));
        driver.tell("{\"late\":2}", 1, true);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "time", 0).value_or(0.0) == doctest::Approx(10.1).epsilon(0.02));
        CHECK(driver.responses[0].paused_s > 99.0);
        CHECK(driver.responses[0].pauses == 1);
    }

    TEST_CASE("an interrupted trial goes on with its work and the time used") {
        Authoring driver;
        driver.wait(10.0);
        driver.tell("{\"a\":1}", 4);
        driver.left.work = UnfinishedWork{0, driver.task().so_far, 60.0 - driver.task().left_s};
        driver.time_s += 5000.0;  // the program does not run
        driver.restart();
        driver.step();
        REQUIRE(driver.toState("authoring"));
        CHECK(driver.task().so_far.project == "{\"a\":1}");
        CHECK(driver.task().left_s == doctest::Approx(50.0).epsilon(0.01));
        driver.tell("{\"a\":2}", 1, true);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].begun_before);
        CHECK(keptNumber(driver.responses[0].values, "edits") == 5.0);
        CHECK(answerTo(driver.responses[0], "time", 0).value_or(0.0) == doctest::Approx(10.0).epsilon(0.02));
        REQUIRE(driver.waitUntil([&] { return driver.frame.authoring.has_value(); }));
        CHECK(driver.task().so_far.project == R"({"version":2})");
    }

    TEST_CASE("time runs only once the trial was shown") {
        Driver driver({authoringStage()});
        driver.add("authoring", 0, {"SGT"}).layout = "across";
        driver.start();
        for (int i = 0; i < 300; ++i) driver.step({}, false);
        REQUIRE(driver.frame.authoring.has_value());
        CHECK(driver.frame.authoring->left_s == 60.0);
        driver.step();
        driver.wait(1.0);
        CHECK(driver.frame.authoring->left_s < 60.0);
    }

    TEST_CASE("the experimenter can skip a trial") {
        Authoring driver;
        driver.wait(1.0);
        driver.order(OperatorAction::skip, "the page broke");
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].status == ResponseStatus::skipped);
        CHECK(driver.responses[0].values.empty());
        CHECK(driver.task().trial == 2);
    }
}
