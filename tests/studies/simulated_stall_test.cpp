// A simulated session that gets nowhere ends, and says where it was.
#include "simulated_room.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Shows a frame for so many seconds of virtual time.
void show(SimulatedStation& station, const PresentedFrame& frame, double seconds) {
    for (double passed = 0.0; passed < seconds; passed += 1.0) {
        (void)station.beginFrame();
        (void)station.present(frame);
    }
}

SimulatedParameters slowDisplay() {
    SimulatedParameters parameters;
    parameters.frame_rate_hz = 1.0;
    return parameters;
}

PresentedFrame frameOf(const SessionStatus& status) {
    PresentedFrame frame;
    frame.stage_from_viewer = {{0.0, 0.0, 3.4}, no_rotation};
    frame.avatar_joints = Room::idle();
    frame.stage = "choices";
    frame.status = status;
    return frame;
}

constexpr double minute_s = 60.0;

}  // namespace

TEST_SUITE("studies/simulated_stall") {
    TEST_CASE("a trial without an answer for half an hour ends the session, with what it waited for") {
        SimulatedStation station(slowDisplay(), motion::referenceHumanoid(), 1);
        PresentedFrame frame = frameOf({"game", 12, 40});
        for (const double x : {-0.3, 0.3})
            frame.balls.push_back({{x, 1.65, 0.4}, 0.05, BallLook::selectable});
        show(station, frame, 29.0 * minute_s);
        CHECK_FALSE(station.failure().has_value());
        CHECK_FALSE(station.beginFrame().quit);
        show(station, frame, 2.0 * minute_s);
        REQUIRE(station.failure().has_value());
        const std::string text = station.failure()->text();
        for (const char* part : {"choices", "game 12/40", "30 minutes", "one of 2 balls", "3.0"})
            CHECK_MESSAGE(text.find(part) != std::string::npos, text);
        CHECK(station.beginFrame().quit);
    }

    TEST_CASE("another trial, or a page that counts down, is progress") {
        SimulatedStation station(slowDisplay(), motion::referenceHumanoid(), 1);
        for (int trial = 1; trial <= 5; ++trial) show(station, frameOf({"game", trial, 5}), 20.0 * minute_s);
        for (int left = 3600; left > 0; --left)
            show(station, frameOf({"break", 0, 0, std::to_string(left)}), 1.0);
        CHECK_FALSE(station.failure().has_value());
    }

    TEST_CASE("a board is told by what it asks for") {
        const auto failureOf = [](const BoardByHand& board) {
            SimulatedStation station(slowDisplay(), motion::referenceHumanoid(), 1);
            PresentedFrame frame = frameOf({"rating", 1, 2});
            frame.panel = board.panel;
            show(station, frame, 31.0 * minute_s);
            REQUIRE(station.failure().has_value());
            return station.failure()->message;
        };
        BoardByHand rating;
        rating.steps(button_id::first_rating, 1, 5);
        CHECK(failureOf(rating).find("giving 1 answers") != std::string::npos);
        BoardByHand page;
        page.button(button_id::go_on, ButtonRole::go_on, "Continue");
        CHECK(failureOf(page).find("leaving a board") != std::string::npos);
        BoardByHand closed;
        closed.button(button_id::go_on, ButtonRole::go_on, "Continue", false);
        CHECK(failureOf(closed).find("cannot be pressed yet") != std::string::npos);
    }
}
