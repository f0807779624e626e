#include "studies/station/session_status.hpp"

#include <doctest/doctest.h>

using deixis::studies::SessionStatus;
using deixis::studies::sessionStatusText;

TEST_SUITE("studies/session_status") {
    TEST_CASE("a line names the part, the trial where there is one, and remarks in their order") {
        CHECK(sessionStatusText({}).empty());
        CHECK(sessionStatusText({"closing"}) == "closing");
        const SessionStatus trial{"naturalness practice", 2, 3};
        CHECK(sessionStatusText(trial) == "naturalness practice 2/3");
        CHECK(sessionStatusText(trial.with("paused: focus lost")) ==
              "naturalness practice 2/3, paused: focus lost");
        const SessionStatus page = SessionStatus{"game"}.with("break").with("").with("4 s");
        CHECK(sessionStatusText(page) == "game, break, 4 s");
    }
}
