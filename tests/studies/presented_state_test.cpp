#include "studies/station/presented_state.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "studies/station/station.hpp"

using namespace deixis::studies;

namespace {

std::set<std::string> names(bool full_pages_only) {
    std::set<std::string> out;
    for (int i = 1; i <= static_cast<int>(PresentedState::over); ++i) {
        const auto state = static_cast<PresentedState>(i);
        if (isFullPage(state) || !full_pages_only) out.insert(std::string(presentedStateName(state)));
    }
    return out;
}

}  // namespace

TEST_SUITE("studies/presented_state") {
    // Traces, --screenshot and labs' own scripts know these.
    TEST_CASE("each state keeps its name") {
        CHECK(names(false) == std::set<std::string>{
                                  "authoring",    "instructions",   "consent",   "questionnaire", "break",
                                  "welcome-back", "practice-again", "attention", "closing",       "paused",
                                  "waiting",      "playing",        "pointing",  "check",         "rating",
                                  "rated",        "watching",       "comparing", "reasons",       "choosing",
                                  "aiming",       "chosen",         "feedback",  "confidence",    "over"});
        CHECK(presentedStateName(PresentedState::starting).empty());
    }

    TEST_CASE("full pages are those that stand before the viewer in place of all else, the closing one too") {
        CHECK(names(true) == std::set<std::string>{"instructions", "consent", "questionnaire", "break",
                                                   "welcome-back", "practice-again", "attention", "closing",
                                                   "paused", "reasons"});
    }

    TEST_CASE("in the game the place is part of the name") {
        PresentedFrame frame;
        frame.state = PresentedState::aiming;
        frame.viewer_place = "side-by-side";
        CHECK(presentedStateName(frame) == "aiming");
        frame.in_game = true;
        CHECK(presentedStateName(frame) == "aiming-side-by-side");
    }
}
