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
