// What the operator's panel says.
#include "app/operator/operator_words.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace studies = deixis::studies;
using namespace deixis::app;

TEST_SUITE("operator/operator_words") {
    TEST_CASE("a trial's status gives stage, place and how much lies behind") {
        const StudyProgress progress = studyProgress("game 12/40");
        CHECK(progress.stage == "Game");
        CHECK(progress.trial == 12);
        CHECK(progress.trials == 40);
        CHECK(progress.remark.empty());
        REQUIRE(progress.done());
        CHECK(*progress.done() == doctest::Approx(11.0 / 40.0));
        CHECK(*studyProgress("naturalness 1/1").done() == 0.0);
    }

    TEST_CASE("practice keeps its name, and a pause its reason") {
        const StudyProgress progress = studyProgress("naturalness practice 2/3, paused: headset taken off");
        CHECK(progress.stage == "Naturalness practice");
        CHECK(progress.trial == 2);
        CHECK(progress.trials == 3);
        CHECK(progress.remark == "Paused: headset taken off");
    }

    TEST_CASE("a status without a count is shown as it is, without a bar") {
        for (const char* status : {"Time for a break", "Part 1", "game", "game 0/40", "game 41/40", "game 4/",
                                   "game /4", "game 4/x", "game 4/40a", "12/40"}) {
            CAPTURE(status);
            const StudyProgress progress = studyProgress(status);
            CHECK_FALSE(progress.done());
            CHECK(progress.trials == 0);
            CHECK(progress.stage.substr(1) == std::string(status).substr(1));
        }
        CHECK(studyProgress("").stage.empty());
        CHECK(studyProgress("finished").stage == "Finished");
        CHECK(studyProgress("Welcome, paused: escape").remark == "Paused: escape");
    }

    TEST_CASE("every state that a session presents has words of its own") {
        studies::PresentedFrame frame;
        CHECK(stateInWords(frame).empty());
        std::set<std::string> words;
        for (int i = 1; i <= static_cast<int>(studies::PresentedState::over); ++i) {
            frame.state = static_cast<studies::PresentedState>(i);
            CAPTURE(studies::presentedStateName(frame));
            CHECK(stateInWords(frame) != studies::presentedStateName(frame));
            CHECK(words.insert(stateInWords(frame)).second);
        }
    }

    TEST_CASE("the game's states name the layout, hyphens and all") {
        studies::PresentedFrame frame;
        frame.viewer_place = "side-by-side";
        frame.state = studies::PresentedState::aiming;
        frame.in_game = true;
        CHECK(stateInWords(frame) == "Aims at a ball (side-by-side)");
        frame.state = studies::PresentedState::playing;
        CHECK(stateInWords(frame) == "Watches the clip (side-by-side)");
        frame.in_game = false;
        CHECK(stateInWords(frame) == "Watches the clip");
    }

    TEST_CASE("the headset is in use only when it has focus") {
        for (const char* state : {"unknown", "idle", "ready", "synchronized", "visible", "stopping",
                                  "loss pending", "exiting", "taken off"}) {
            CAPTURE(state);
            CHECK_FALSE(headsetInWords(state).in_use);
        }
        CHECK(headsetInWords("focused").in_use);
        CHECK(headsetInWords("taken off").words == "Taken off");
    }

    TEST_CASE("distances are whole centimetres below a metre, metres from there") {
        CHECK(distanceInWords(0.0) == "0 cm");
        CHECK(distanceInWords(0.124) == "12 cm");
        CHECK(distanceInWords(0.994) == "99 cm");
        CHECK(distanceInWords(0.996) == "1.00 m");
        CHECK(distanceInWords(2.4) == "2.40 m");
    }

    TEST_CASE("elapsed time shows hours only where there are some") {
        CHECK(elapsedInWords(0.0) == "0:00");
        CHECK(elapsedInWords(59.99) == "0:59");
        CHECK(elapsedInWords(247.0) == "4:07");
        CHECK(elapsedInWords(3750.0) == "1:02:30");
        CHECK(elapsedInWords(-1.0) == "0:00");
    }

    TEST_CASE("the time left is told in minutes, hours where there are some, and as unknown where it is") {
        CHECK(timeLeftInWords(std::nullopt) == "not known yet");
        CHECK(timeLeftInWords(0.0) == "less than a minute");
        CHECK(timeLeftInWords(59.0) == "less than a minute");
        CHECK(timeLeftInWords(60.0) == "about 1 min");
        CHECK(timeLeftInWords(754.0) == "about 13 min");
        CHECK(timeLeftInWords(3599.0) == "about 1 h 00 min");
        CHECK(timeLeftInWords(3900.0) == "about 1 h 05 min");
    }

    TEST_CASE("free space is told in whole units, never more than there is") {
        CHECK(bytesInWords(0) == "0 MB");
        CHECK(bytesInWords(999'999'999) == "999 MB");
        CHECK(bytesInWords(1'000'000'000) == "1.0 GB");
        CHECK(bytesInWords(9'990'000'000) == "9.9 GB");
        CHECK(bytesInWords(118'900'000'000) == "118 GB");
    }

    TEST_CASE("what happened is told with the operator's own words, and what came to nothing as such") {
        CHECK(eventInWords({0.0, studies::NoteKind::operator_skip, "the clip did not move"}) ==
              "Skipped: the clip did not move");
        CHECK(eventInWords({0.0, studies::NoteKind::operator_skip, "nothing to skip"}) == "Nothing to skip");
        CHECK(eventInWords({0.0, studies::NoteKind::operator_repeat, "nothing to repeat"}) ==
              "Nothing to repeat");
        CHECK(eventInWords({0.0, studies::NoteKind::operator_repeat, ""}) == "Last trial is repeated");
        CHECK(eventInWords({0.0, studies::NoteKind::pause, "focus lost"}) == "Paused: focus lost");
        CHECK(eventInWords({0.0, studies::NoteKind::resume, "after 3.200 s"}) == "Resumed");
        CHECK(eventInWords({0.0, studies::NoteKind::ipd, "0.0630 m"}) == "ipd: 0.0630 m");
    }
}
