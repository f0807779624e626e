// Trials that are repeated, answers that wait for the disk, and everything at once.
#include <doctest/doctest.h>

#include "core/random.hpp"
#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

void resume(Driver& driver) {
    driver.wait(0.5);
    driver.press(button_id::resume);
}

/// Somebody in a headset who does anything at any time.
struct Restless {
    explicit Restless(Driver& driven, std::uint64_t seed) : driver(driven), random(seed, "restless") {}

    Driver& driver;
    Random random;
    double kept_at_s = 0.0;

    InputFrame act() {
        if (random.uniform() < 0.01) driver.holds_pointer = !driver.holds_pointer;
        if (random.uniform() < 0.02) driver.place_offset_m = random.uniform(0.0, 0.6);
        driver.kept = driver.time_s >= kept_at_s;
        driver.looking.reset();
        if (random.uniform() < 0.3) driver.looking = yawRotation(random.uniform(-pi, pi));
        driver.select_ago_s.reset();
        if (random.uniform() < 0.7) driver.select_ago_s = random.uniform(0.0, 0.1);

        InputFrame input;
        const PresentedFrame& frame = driver.frame;
        if (driver.holds_pointer) {
            Vec3 at(random.uniform(-3.0, 3.0), random.uniform(0.0, 2.0), random.uniform(-3.0, 3.0));
            if (random.uniform() < 0.7 && frame.panel && !frame.panel->buttons.empty())
                at = buttonCentre(*frame.panel,
                                  frame.panel->buttons[random.below(frame.panel->buttons.size())].id);
            else if (random.uniform() < 0.9 && !frame.balls.empty())
                at = frame.balls[random.below(frame.balls.size())].centre;
            input.pointer = lookAt(frame, at);
        }
        input.select = random.uniform() < 0.3;
        input.confirm = random.uniform() < 0.05;
        if (random.uniform() < 0.03) input.digit = static_cast<int>(1 + random.below(6));
        if (random.uniform() < 0.005) {
            using enum PauseReason;
            constexpr PauseReason reasons[] = {headset_taken_off, tracking_lost, experimenter, menu};
            input.pause = true;
            input.pause_reason = reasons[random.below(4)];
        }
        if (random.uniform() < 0.05) input.notes.push_back({NoteKind::xr_state, "visible", driver.time_s});
        return input;
    }
};

}  // namespace

TEST_SUITE("studies/session_interruption") {
    TEST_CASE("a trial interrupted with its answer open starts over where the study wants it repeated") {
        for (const bool game : {false, true}) {
            CAPTURE(game);
            Driver driver(1, 0.5, false);
            driver.study.after_interruption = AfterInterruption::repeat;
            driver.start(game ? std::set<int>{0, 1} : std::set<int>{});
            REQUIRE(driver.toAnswer());
            driver.wait(1.0);
            driver.step(pauseFor(PauseReason::tracking_lost));
            driver.wait(3.0);
            resume(driver);
            const double resumed_s = driver.time_s;
            CHECK(driver.count(NoteKind::trial_repeated) == 1);
            CHECK(driver.last(NoteKind::trial_repeated).trial_index == (game ? 2 : 0));
            CHECK(driver.state() == (game ? "waiting-across" : "waiting"));
            CHECK_FALSE(answersOpen(driver.frame));
            REQUIRE(driver.toAnswer());
            CHECK(driver.count(NoteKind::stimulus_onset) == 2);
            CHECK(driver.last(NoteKind::stimulus_onset).at.time_s >= resumed_s + 0.5);
            CHECK(driver.count(NoteKind::motion_end) == 2);
            driver.wait(0.4);
            driver.answerSomehow(1);
            REQUIRE(driver.responses.size() == 1);
            const Response& response = driver.responses[0];
            CHECK(response.pauses == 1);
            CHECK(response.paused_s == 0.0);
            CHECK(response.onset.time_s == driver.last(NoteKind::stimulus_onset).at.time_s);
            CHECK(response.motion_end.time_s == driver.last(NoteKind::motion_end).at.time_s);
            CHECK(response.response_time_s == doctest::Approx(driver.time_s - response.motion_end.time_s));
            CHECK(response.response_time_s < 0.6);
        }
    }

    TEST_CASE(
        "a clip interrupted half way is marked as repeated; before the clip there is nothing to repeat") {
        Driver driver(1, 1.0, false);
        driver.study.after_interruption = AfterInterruption::repeat;
        driver.start();
        REQUIRE(driver.waitUntil([&] {
            if (resting(driver.frame)) driver.leavePage();
            return driver.state() == "waiting";
        }));
        driver.step(pauseFor(PauseReason::headset_taken_off));
        resume(driver);
        CHECK(driver.count(NoteKind::trial_repeated) == 0);
        REQUIRE(driver.waitUntil([&] { return driver.state() == "pointing"; }));
        driver.step(pauseFor(PauseReason::headset_taken_off));
        resume(driver);
        CHECK(driver.count(NoteKind::trial_repeated) == 1);
        REQUIRE(driver.toAnswer());
        driver.digit(2);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].pauses == 1);
        CHECK(driver.count(NoteKind::stimulus_onset) == 2);
    }

    TEST_CASE("where a trial goes on instead, nothing is said of a repetition") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.step(pauseFor(PauseReason::tracking_lost));
        resume(driver);
        CHECK(hasButton(driver.frame, button_id::first_rating));
        CHECK(driver.count(NoteKind::trial_repeated) == 0);
        CHECK(driver.count(NoteKind::stimulus_onset) == 1);
    }

    TEST_CASE("the pause page says calmly why there is a pause, and always offers to go on or to end") {
        const struct {
            PauseReason reason;
            const char* recorded;
            std::vector<std::string> words;
        } pages[] = {
            {PauseReason::headset_taken_off,
             "headset taken off",
             {"Welcome back", "while the headset was off"}},
            {PauseReason::tracking_lost,
             "tracking lost",
             {"One moment", "The headset has lost track of where it is."}},
            {PauseReason::focus_lost, "focus lost", {"Paused", "Another window or menu was opened."}},
            {PauseReason::experimenter, "operator", {"Paused", "The experimenter has paused the session."}},
            {PauseReason::menu, "menu", {"Paused", "Continue when you are ready."}},
            {PauseReason::escape, "escape", {"Paused", "Continue when you are ready."}},
            {PauseReason::picture, "for a picture", {"Paused", "Continue when you are ready."}},
            {PauseReason::unsaid, "paused", {"Paused", "Continue when you are ready."}}};
        for (const auto& page : pages) {
            CAPTURE(page.recorded);
            Driver driver(1);
            driver.start();
            driver.step();
            driver.step(pauseFor(page.reason));
            REQUIRE(driver.frame.panel.has_value());
            const std::string text = textOf(*driver.frame.panel);
            for (const std::string& word : page.words) CHECK(text.find(word) != std::string::npos);
            CHECK(text.find("your answers so far are kept") != std::string::npos);
            CHECK(hasButton(driver.frame, button_id::resume));
            CHECK(hasButton(driver.frame, button_id::end_session));
            CHECK(driver.last(NoteKind::pause).detail == page.recorded);
        }
    }

    TEST_CASE("the next trial waits until the answer is on the disk; the answer stays in sight so long") {
        Driver driver(1, 0.5, false);
        driver.start(std::set<int>{0, 1});
        REQUIRE(driver.toAnswer());
        driver.kept = false;
        driver.choose(1);
        driver.wait(3.0);
        CHECK(driver.state() == "chosen-across");
        CHECK(driver.frame.balls[1].look == BallLook::chosen);
        CHECK(driver.session->trialUnderWay() == 2);
        CHECK(driver.frame.notice == "One moment, please: your answer is being saved.");
        CHECK(sessionStatusText(driver.frame.status) == "game 1/2, waiting for the disk");
        driver.choose(0);
        driver.digit(1);
        CHECK(driver.responses.size() == 1);
        driver.kept = true;
        driver.step();
        CHECK(driver.session->trialUnderWay() == 3);
        CHECK(driver.frame.notice.empty());
        CHECK(sessionStatusText(driver.frame.status) == "game 2/2");

        // The last answer, too, before the goodbye.
        REQUIRE(driver.toAnswer());
        driver.kept = false;
        driver.choose(1);
        driver.wait(1.0);
        CHECK(driver.state() == "chosen-side-by-side");
        driver.kept = true;
        driver.step();
        CHECK(driver.frame.stage == "goodbye");
        CHECK(driver.session->trialUnderWay() == -1);
        driver.kept = false;  // nothing more waits for it
        REQUIRE(driver.leavePage());
        CHECK(driver.finished());
    }

    TEST_CASE("an answer that is kept at once is shown as long as ever") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        driver.digit(3);
        const double answered_s = driver.time_s;
        REQUIRE(driver.waitUntil([&] { return driver.state() != "rated"; }));
        CHECK(driver.time_s - answered_s == doctest::Approx(0.35).epsilon(0.06));
    }

    TEST_CASE("a session that waits for the disk can be paused, resumed and ended") {
        Driver driver(1, 0.5, false);
        driver.start(std::set<int>{0, 1});
        REQUIRE(driver.toAnswer());
        driver.kept = false;
        driver.choose(1);
        driver.step(pauseFor(PauseReason::experimenter));
        CHECK(driver.state() == "paused");
        resume(driver);
        driver.wait(1.0);
        CHECK(driver.state() == "chosen-across");
        CHECK(driver.session->trialUnderWay() == 2);
        CHECK(driver.responses.size() == 1);
        InputFrame quit;
        quit.quit = true;
        driver.step(quit);
        CHECK(driver.hasQuit());
        CHECK(driver.state() == "over");
    }

    TEST_CASE("why a session was ended stands in its note") {
        for (const std::string reason : {"", "runtime lost"}) {
            Driver driver(1);
            driver.start();
            driver.step();
            InputFrame quit;
            quit.quit = true;
            quit.quit_reason = reason;
            driver.step(quit);
            CHECK(driver.last(NoteKind::quit).detail == (reason.empty() ? "quit" : reason));
        }
    }

    TEST_CASE("a trial is under way from its pause before the clip until its answer has been confirmed") {
        Driver driver(1, 0.5, false);
        driver.start();
        CHECK(driver.session->trialUnderWay() == -1);
        driver.step();
        CHECK(driver.session->trialUnderWay() == -1);
        std::vector<std::pair<std::string, int>> seen;
        while (!driver.finished()) {
            if (answersOpen(driver.frame))
                driver.answerSomehow(0);
            else if (resting(driver.frame))
                driver.leavePage();
            else
                driver.step();
            const std::pair<std::string, int> now{driver.state(), driver.session->trialUnderWay()};
            if (seen.empty() || seen.back() != now) seen.push_back(now);
        }
        const std::vector<std::pair<std::string, int>> rating{
            {"instructions", -1}, {"waiting", 0}, {"playing", 0}, {"pointing", 0},
            {"rating", 0},        {"rated", 0},   {"waiting", 1}};
        REQUIRE(seen.size() > rating.size());
        for (std::size_t i = 0; i < rating.size(); ++i) {
            CAPTURE(i);
            CHECK(seen[i] == rating[i]);
        }
        CHECK(seen.back() == std::pair<std::string, int>{"over", -1});
    }

    TEST_CASE(
        "over 50 seeds of somebody restless in a headset, every trial is answered once, in an open answer, "
        "and "
        "the session ends") {
        int repeated = 0;
        int early = 0;
        int lost = 0;
        int strayed = 0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            CAPTURE(seed);
            Driver driver(2, 0.4);
            driver.study.after_interruption =
                seed % 2 == 0 ? AfterInterruption::repeat : AfterInterruption::resume;
            driver.display_delay_s = seed % 3 == 0 ? 0.03 : 0.0;
            driver.frame_time_s = 1.0 / (20.0 + static_cast<double>(seed));
            Restless person(driver, seed);
            driver.start();
            std::set<int> answered;
            std::optional<double> open_since_s;  // as displayed
            for (int i = 0; i < 200000 && !driver.finished() && !driver.hasQuit(); ++i) {
                const std::size_t responses = driver.responses.size();
                const int onsets = driver.count(NoteKind::stimulus_onset);
                const InputFrame input = person.act();
                const bool was_shown = person.random.uniform() < 0.9;
                driver.step(input, was_shown);
                if (driver.responses.size() > responses) {
                    REQUIRE(driver.responses.size() == responses + 1);
                    const Response& given = driver.responses.back();
                    REQUIRE(open_since_s.has_value());
                    CHECK(given.answered.time_s >= *open_since_s);
                    CHECK(given.response_time_s > 0.0);
                    CHECK(answered.insert(given.trial_index).second);
                    CHECK(given.trial_index == driver.session->trialUnderWay());
                    if (given.input == "ray" && given.chosenPlace() >= 0) {
                        const auto place = static_cast<std::size_t>(given.chosenPlace());
                        const Vec3 looking = given.stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
                        const Vec3 towards =
                            driver.frame.balls[place].centre - given.stage_from_head.position;
                        CHECK(angleBetween(looking, towards) < radiansFromDegrees(64.0));
                    }
                    if (driver.study.after_interruption == AfterInterruption::repeat) {
                        CHECK(given.paused_s == 0.0);
                        for (const Note& note : driver.notes)
                            if (note.kind == NoteKind::trial_repeated &&
                                note.trial_index == given.trial_index)
                                CHECK(given.onset.time_s > note.at.time_s);
                    }
                    person.kept_at_s = driver.time_s + person.random.uniform(0.0, 1.5);
                }
                if (driver.time_s < person.kept_at_s) CHECK(driver.count(NoteKind::stimulus_onset) == onsets);
                if (!answersOpen(driver.frame))
                    open_since_s.reset();
                else if (was_shown && !open_since_s)
                    open_since_s = driver.time_s + driver.display_delay_s;
                if (driver.hasQuit()) {  // on the pause page: the rest in another session
                    driver.frame = {};
                    open_since_s.reset();
                    driver.start(answered);
                }
            }
            CHECK(driver.finished());
            CHECK(answered == std::set<int>{1, 2, 3, 4, 6, 7, 8, 9});
            CHECK(driver.responses.size() == answered.size());
            repeated += driver.count(NoteKind::trial_repeated);
            early += driver.count(NoteKind::early_select);
            lost += driver.count(NoteKind::pointer_lost);
            strayed += driver.count(NoteKind::off_place);
        }
        // All of it came about.
        CHECK(repeated > 5);
        CHECK(early > 50);
        CHECK(lost > 5);
        CHECK(strayed > 50);
    }

    TEST_CASE("where nothing more can be kept, a calm page ends the session, whatever was under way") {
        using enum PresentedState;
        int met = 0;
        for (const PresentedState state :
             {instructions, waiting, playing, rating, rated, choosing, chosen, rest, paused}) {
            INFO(presentedStateName(state));
            Driver driver;
            driver.start();
            driver.step();
            const bool pause = state == paused;
            const auto there = [&] { return driver.frame.state == (pause ? playing : state); };
            for (int i = 0; i < 20'000 && !there(); ++i) {
                if (resting(driver.frame))
                    driver.leavePage();
                else if (answersOpen(driver.frame))
                    driver.answerSomehow(i);
                else
                    driver.step();
            }
            if (!there()) continue;  // this study has no such moment
            ++met;
            if (pause) driver.step(pauseFor(PauseReason::experimenter));
            const auto answers = driver.responses.size() + driver.practised.size();
            driver.recording_failed = true;
            driver.step();
            CHECK(driver.frame.state == closing);
            REQUIRE(driver.frame.panel.has_value());
            CHECK(textOf(*driver.frame.panel).find("technical problem") != std::string::npos);
            CHECK(driver.frame.balls.empty());
            CHECK(driver.session->trialUnderWay() == -1);
            driver.wait(2.0);
            CHECK(driver.running());  // until it has been read
            driver.leavePage();
            CHECK(driver.hasQuit());
            CHECK(driver.responses.size() + driver.practised.size() == answers);
        }
        CHECK(met >= 7);
    }
}
