// What the operator's panel says, and the question asked twice.
#include "operator_words.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

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
        // The list of PresentedFrame::state.
        const std::vector<std::string> states{
            "welcome",         "welcome-back",  "instructions",   "practice",       "begin",
            "break",           "goodbye",       "waiting",        "playing",        "pointing",
            "rating",          "rated",         "waiting-across", "playing-across", "pointing-across",
            "choosing-across", "aiming-across", "chosen-across",  "paused",         "over"};
        std::set<std::string> words;
        for (const std::string& state : states) {
            CAPTURE(state);
            CHECK(stateInWords(state) != state);
            CHECK(words.insert(stateInWords(state)).second);
        }
    }

    TEST_CASE("the game's states name the layout, hyphens and all") {
        CHECK(stateInWords("aiming-side-by-side") == "Aims at a ball (side-by-side)");
        CHECK(stateInWords("playing-across") == "Watches the clip (across)");
        CHECK(stateInWords("playing") == "Watches the clip");
    }

    TEST_CASE("an unknown state comes back as it is") {
        CHECK(stateInWords("playingcards") == "playingcards");
        CHECK(stateInWords("levitating") == "levitating");
        CHECK(stateInWords("").empty());
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

    TEST_CASE("ending takes two askings within four seconds") {
        AskTwice end;
        CHECK_FALSE(end.left(99.0));
        CHECK_FALSE(end.ask(100.0));
        REQUIRE(end.left(101.0));
        CHECK(*end.left(101.0) == doctest::Approx(0.75));
        CHECK(end.ask(103.9));
        CHECK_FALSE(end.left(103.9));
        CHECK_FALSE(end.ask(104.9));
    }

    TEST_CASE("an asking after four seconds is a first one again") {
        AskTwice end;
        CHECK_FALSE(end.ask(10.0));
        CHECK_FALSE(end.left(14.1));
        CHECK_FALSE(end.ask(14.1));
        CHECK(end.ask(16.0));
    }

    TEST_CASE("a double click asks once, and does not lengthen the time for the second asking") {
        AskTwice end;
        CHECK_FALSE(end.ask(10.0));
        CHECK_FALSE(end.ask(10.1));
        CHECK_FALSE(end.ask(10.39));
        CHECK_FALSE(end.left(14.05));
        CHECK_FALSE(end.ask(20.0));
        CHECK_FALSE(end.ask(20.2));
        CHECK(end.ask(20.5));
    }
}
