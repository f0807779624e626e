#include "head_watch.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace deixis;
using namespace deixis::app;

namespace {

studies::TrackedPose head(bool position, bool orientation, bool tracked) {
    studies::TrackedPose pose;
    pose.position_valid = position;
    pose.orientation_valid = orientation;
    pose.tracked = tracked;
    return pose;
}

const studies::TrackedPose measured = head(true, true, true);
const studies::TrackedPose guessed = head(true, true, false);
const studies::TrackedPose turning = head(false, true, false);
const studies::TrackedPose gone = head(false, false, false);

// From one time to another at 90 Hz: in how many frames the head is lost.
int lostFrames(HeadWatch& watch, const studies::TrackedPose& pose, double from_s, double to_s) {
    int lost = 0;
    const long frames = std::lround((to_s - from_s) * 90.0);
    for (long i = 0; i < frames; ++i) lost += watch.lost(pose, from_s + static_cast<double>(i) / 90.0);
    return lost;
}

}  // namespace

TEST_SUITE("headset/head_watch") {
    TEST_CASE("a head without a pose is lost after a quarter of a second, and stays so until it is back") {
        for (const auto& pose : {gone, turning}) {
            HeadWatch watch;
            CHECK(lostFrames(watch, measured, 0.0, 1.0) == 0);
            CHECK(lostFrames(watch, pose, 1.0, 1.24) == 0);
            CHECK(lostFrames(watch, measured, 1.24, 1.3) == 0);
            CHECK(lostFrames(watch, pose, 1.3, 1.54) == 0);
            CHECK(lostFrames(watch, pose, 1.57, 2.57) == 90);
            CHECK(lostFrames(watch, measured, 2.57, 3.0) == 0);
        }
    }

    TEST_CASE(
        "a position that was measured and is guessed for a second is lost, once until it is measured again") {
        HeadWatch watch;
        CHECK(lostFrames(watch, measured, 0.0, 1.0) == 0);
        CHECK(lostFrames(watch, guessed, 1.0, 1.9) == 0);
        CHECK(lostFrames(watch, measured, 1.9, 2.0) == 0);
        CHECK(lostFrames(watch, guessed, 2.0, 2.98) == 0);
        CHECK(lostFrames(watch, guessed, 2.98, 5.0) == 1);
        CHECK(lostFrames(watch, measured, 5.0, 5.1) == 0);
        CHECK(lostFrames(watch, guessed, 5.1, 8.0) == 1);
    }

    TEST_CASE("a headset that never measures its position is not lost") {
        HeadWatch watch;
        CHECK(lostFrames(watch, guessed, 0.0, 60.0) == 0);
    }
}
