// What the session tells a participant who has strayed or holds no pointer, and what it keeps of it.
#include <doctest/doctest.h>

#include "session_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

const std::string step_back = LanguageTable::english()("notice_place");
const std::string pick_up = LanguageTable::english()("notice_pointer");

InputFrame withNote(NoteKind kind, const char* detail, double time_s) {
    InputFrame input;
    input.notes.push_back({kind, detail, time_s});
    return input;
}

std::vector<std::string> pages_read(const Driver& driver, const std::set<NoteKind>& kinds) {
    std::vector<std::string> lines;
    for (const Note& note : driver.notes)
        if (kinds.count(note.kind) > 0)
            lines.push_back(std::string(noteKindName(note.kind)) +
                            (note.detail.empty() ? "" : " " + note.detail) + " in " +
                            std::to_string(note.trial_index));
    return lines;
}

bool reaches(Driver& driver, const std::string& state) {
    return driver.waitUntil([&] {
        if (resting(driver.frame)) driver.leavePage();
        return driver.state() == state;
    });
}

}  // namespace

TEST_SUITE("studies/session_guards") {
    TEST_CASE("a station's notes are kept at their own times, with the trial under way") {
        Driver driver(1, 0.5, false);
        driver.start();
        driver.step(withNote(NoteKind::xr_state, "focused", 99.5));
        CHECK(driver.last(NoteKind::xr_state).trial_index == -1);
        CHECK(driver.last(NoteKind::xr_state).at.time_s == 99.5);
        CHECK(driver.last(NoteKind::xr_state).at.utc_s == doctest::Approx(99.5 + 1.0e9).epsilon(1e-13));
        REQUIRE(reaches(driver, "playing"));
        InputFrame two = withNote(NoteKind::recentre, "runtime", driver.time_s);
        two.notes.push_back({NoteKind::input_profile, "simple", driver.time_s + 0.001});
        driver.step(two);
        CHECK(driver.last(NoteKind::recentre).trial_index == 0);
        CHECK(driver.last(NoteKind::recentre).detail == "runtime");
        CHECK(driver.last(NoteKind::input_profile).trial_index == 0);
        InputFrame quit = withNote(NoteKind::xr_state, "exiting", driver.time_s);
        quit.quit = true;
        driver.step(quit);
        CHECK(driver.count(NoteKind::xr_state) == 2);
        CHECK(driver.last(NoteKind::xr_state).trial_index == 0);
    }

    TEST_CASE("beyond the tolerance the participant is asked back, until 5 cm inside of it") {
        Driver driver(1);
        driver.study.headset.place_tolerance_m = 0.3;
        driver.start();
        const auto noticeAt = [&](double off_m) {
            driver.place_offset_m = off_m;
            driver.step();
            return driver.frame.notice;
        };
        CHECK(noticeAt(0.0).empty());
        CHECK(noticeAt(0.29).empty());
        CHECK(noticeAt(0.31) == step_back);
        CHECK(noticeAt(0.27) == step_back);
        CHECK(noticeAt(0.31) == step_back);
        CHECK(noticeAt(0.24).empty());
        CHECK(noticeAt(0.29).empty());
        CHECK_MESSAGE(driver.count(NoteKind::off_place) == 0, "no trial was under way");
        CHECK(driver.count(NoteKind::back_on_place) == 0);
    }

    TEST_CASE(
        "a trial is marked once for being off the place, once more when it gets worse, and when it ends") {
        Driver driver(1, 1.0, false);
        driver.study.headset.place_tolerance_m = 0.3;
        driver.start();
        REQUIRE(reaches(driver, "playing"));
        for (const double off_m : {0.2, 0.35, 0.40, 0.36, 0.46, 0.9, 0.2, 0.4, 0.1}) {
            driver.place_offset_m = off_m;
            driver.wait(0.05);
        }
        const std::set<NoteKind> kinds{NoteKind::off_place, NoteKind::back_on_place};
        const std::vector<std::string> marked{"off_place 0.35 m in 0", "off_place 0.46 m in 0",
                                              "back_on_place in 0"};
        CHECK(pages_read(driver, kinds) == marked);

        // Off from one trial into the next: each is marked.
        driver.place_offset_m = 0.5;
        REQUIRE(driver.toAnswer());
        CHECK(driver.frame.notice == step_back);
        driver.digit(1);
        REQUIRE(driver.toAnswer());
        driver.place_offset_m = 0.0;
        driver.step();
        CHECK(driver.frame.notice.empty());
        const std::vector<std::string> both{"off_place 0.35 m in 0", "off_place 0.46 m in 0",
                                            "back_on_place in 0", "off_place 0.50 m in 1",
                                            "back_on_place in 1"};
        CHECK(pages_read(driver, kinds) == both);
    }

    TEST_CASE("a paused session marks no trial for a participant who has walked away") {
        Driver driver(1, 1.0, false);
        driver.start();
        REQUIRE(reaches(driver, "playing"));
        InputFrame pause;
        pause.pause = true;
        pause.pause_reason = PauseReason::headset_taken_off;
        driver.step(pause);
        driver.place_offset_m = 2.0;
        driver.wait(1.0);
        CHECK(driver.frame.notice == step_back);
        CHECK(driver.count(NoteKind::off_place) == 0);
        driver.place_offset_m = 0.1;
        driver.step();
        CHECK(driver.frame.notice.empty());
        CHECK(driver.count(NoteKind::back_on_place) == 0);
    }

    TEST_CASE("nobody is asked for a controller while the station itself says that nobody is there") {
        Driver driver(1);
        driver.start();
        driver.wait(1.0);
        driver.holds_pointer = false;
        for (int i = 0; i < 300; ++i) {
            driver.step(pauseFor(PauseReason::headset_taken_off));
            REQUIRE(driver.frame.notice.empty());
        }
        driver.wait(2.2);
        CHECK_MESSAGE(driver.frame.notice == pick_up, "back in the headset, still paused");
    }

    TEST_CASE("without a pointer for 2 s on a page the participant is asked to pick one up") {
        Driver driver(1);
        driver.start();
        driver.wait(1.0);
        driver.holds_pointer = false;
        driver.wait(1.9);
        CHECK(driver.frame.notice.empty());
        driver.wait(0.2);
        CHECK(driver.frame.notice == pick_up);
        CHECK(driver.frame.ray == std::nullopt);
        driver.holds_pointer = true;
        driver.step();
        CHECK(driver.frame.notice.empty());
        CHECK_MESSAGE(driver.count(NoteKind::pointer_lost) == 0, "no trial was under way");
        CHECK(driver.count(NoteKind::pointer_found) == 0);
    }

    TEST_CASE(
        "a pointer that is gone while the clip plays disturbs nobody; while the answer is open it is noted") {
        Driver driver(1, 4.0, false);
        driver.start();
        REQUIRE(reaches(driver, "playing"));
        driver.holds_pointer = false;
        while (!answersOpen(driver.frame)) {
            driver.step();
            CHECK(driver.frame.notice.empty());
        }
        CHECK(driver.count(NoteKind::pointer_lost) == 0);
        driver.wait(1.9);
        CHECK(driver.frame.notice.empty());
        driver.wait(2.0);
        CHECK(driver.frame.notice == pick_up);
        REQUIRE(driver.count(NoteKind::pointer_lost) == 1);
        CHECK(driver.last(NoteKind::pointer_lost).trial_index == 0);
        driver.place_offset_m = 1.0;  // first things first
        driver.step();
        CHECK(driver.frame.notice == pick_up);
        driver.holds_pointer = true;
        driver.step();
        CHECK(driver.frame.notice == step_back);
        REQUIRE(driver.count(NoteKind::pointer_found) == 1);
        CHECK(driver.last(NoteKind::pointer_found).trial_index == 0);
        driver.press(button_id::first_rating);
        CHECK(driver.responses.size() == 1);
    }

    TEST_CASE("each loss is noted, and each trial that it falls into") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(driver.toAnswer());
        for (int losses = 1; losses <= 2; ++losses) {
            driver.holds_pointer = false;
            driver.wait(2.5);
            CHECK(driver.count(NoteKind::pointer_lost) == losses);
            driver.holds_pointer = true;
            driver.step();
            CHECK(driver.count(NoteKind::pointer_found) == losses);
        }
        driver.holds_pointer = false;
        driver.wait(2.5);
        driver.digit(2);
        REQUIRE(driver.toAnswer());
        driver.wait(2.5);
        CHECK(driver.count(NoteKind::pointer_lost) == 4);
        CHECK(driver.last(NoteKind::pointer_lost).trial_index == 1);
    }

    TEST_CASE(
        "on the pause page, too, a pointer is asked for, and the end of the session clears every notice") {
        Driver driver(1, 0.5, false);
        driver.start();
        REQUIRE(reaches(driver, "playing"));
        InputFrame pause;
        pause.pause = true;
        driver.step(pause);
        driver.holds_pointer = false;
        driver.wait(2.5);
        CHECK(driver.frame.notice == pick_up);
        CHECK(driver.count(NoteKind::pointer_lost) == 0);
        InputFrame quit;
        quit.quit = true;
        driver.step(quit);
        CHECK(driver.frame.notice.empty());
    }
}
