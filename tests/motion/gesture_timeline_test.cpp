#include "motion/unit_gestures/gesture_timeline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

using namespace deixis;
using namespace deixis::motion;
using doctest::Approx;

namespace {

/// The hand goes to `from` and strikes to `to`, and rests again.
UnitGesture strike(const ChannelValues& from, const ChannelValues& to,
                   Channel channel = Channel::right_hand) {
    UnitGesture gesture;
    gesture.id = "strike";
    gesture.keys.resize(4);
    gesture.keys[1] = {0.5, GesturePhase::preparation, false, {}};
    gesture.keys[2] = {0.8, GesturePhase::stroke, false, {}};
    gesture.keys[3] = {1.6, GesturePhase::retraction, false, {}};
    gesture.keys[1].channels[indexOf(channel)] = from;
    gesture.keys[2].channels[indexOf(channel)] = to;
    return gesture;
}

const ChannelValues high{0.0, -0.2, 0.5, 10.0}, low{0.1, -0.5, 0.5, 10.0}, far_out{0.8, 0.3, 0.4, 10.0};

ChannelValues rightAt(const GestureTimeline& timeline, double time_s) {
    return targetAt(timeline.track, time_s)[indexOf(Channel::right_hand)];
}

double apart(const ChannelValues& a, const ChannelValues& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

const ChannelValues& rest() {
    return relaxedTarget()[indexOf(Channel::right_hand)];
}

}  // namespace

TEST_SUITE("motion/gesture_timeline") {
    TEST_CASE("A gesture's apex is at its time, its preparation before, and then it rests") {
        const auto timeline = timelineOf({{strike(high, low), 3.0, 1.0, 0.3}}, 8.0);
        REQUIRE(timeline.made.size() == 1);
        CHECK(timeline.made[0].begin_s < 2.2);  // half a second is short for the way
        CHECK(timeline.made[0].begin_s > 2.0);
        CHECK(timeline.made[0].stroke_s == Approx(2.7));
        CHECK(rightAt(timeline, 2.0) == rest());
        CHECK(apart(rightAt(timeline, 2.7), high) < 1e-9);
        CHECK(apart(rightAt(timeline, 3.0), low) < 1e-9);
        CHECK(apart(rightAt(timeline, 3.29), low) < 1e-9);
        CHECK(apart(rightAt(timeline, 4.3), rest()) < 1e-9);
        const auto quick = timelineOf({{strike(high, low), 3.0, 2.0, 0.0}}, 8.0);
        CHECK(quick.made[0].stroke_s == Approx(2.85));
    }

    TEST_CASE("A gesture soon after another goes on from there, the hand held between") {
        const auto timeline =
            timelineOf({{strike(high, low), 2.0, 1.0, 0.1}, {strike(high, low), 3.4, 1.0, 0.0}}, 8.0);
        REQUIRE(timeline.made.size() == 2);
        for (double t = 2.0; t < 2.6; t += 0.05) CHECK(apart(rightAt(timeline, t), low) < 1e-9);
        for (double t = 2.0; t < 3.4; t += 0.02) CHECK(apart(rightAt(timeline, t), rest()) > 0.3);
    }

    TEST_CASE("With time between, the hand rests") {
        const auto timeline =
            timelineOf({{strike(high, low), 2.0, 1.0, 0.1}, {strike(high, low), 5.0, 1.0, 0.0}}, 8.0);
        CHECK(apart(rightAt(timeline, 3.5), rest()) < 1e-9);
        CHECK(apart(rightAt(timeline, 4.15), rest()) < 1e-9);
    }

    TEST_CASE("What there is no time for is left out: too early, too late, too soon after another") {
        const std::vector<PlacedGesture> gestures{{strike(high, low), 0.3, 1.0, 0.0},
                                                  {strike(high, low), 2.0, 1.0, 0.0},
                                                  {strike(high, low), 2.3, 1.0, 0.0},
                                                  {strike(high, low), 3.5, 1.0, 0.0}};
        const auto timeline = timelineOf(gestures, 4.0);
        REQUIRE(timeline.made.size() == 1);
        CHECK(timeline.made[0].index == 1);
        CHECK(timelineOf(gestures, 0.1).made.empty());
        CHECK(timelineOf({}, 4.0).track == BodyTrack{});
    }

    TEST_CASE("The other hand is free while one is busy; a busy head leaves the hand to its gesture") {
        UnitGesture with_head = strike(high, low, Channel::left_hand);
        with_head.keys[2].channels[indexOf(Channel::head)] = ChannelValues{0.0, 10.0, 0.0, 0.0};
        UnitGesture right = strike(high, low);
        right.keys[2].channels[indexOf(Channel::head)] = ChannelValues{20.0, 0.0, 0.0, 0.0};
        const auto timeline = timelineOf({{right, 2.0, 1.0, 0.0}, {with_head, 2.1, 1.0, 0.0}}, 6.0);
        REQUIRE(timeline.made.size() == 2);
        CHECK(apart(targetAt(timeline.track, 2.1)[indexOf(Channel::left_hand)], low) < 1e-9);
        CHECK(targetAt(timeline.track, 2.0)[indexOf(Channel::head)][0] == Approx(20.0));
        CHECK(targetAt(timeline.track, 2.1)[indexOf(Channel::head)][1] < 1e-9);
    }

    TEST_CASE("Ways are cut short where a hand would be too fast, and back at rest before the end") {
        TimelineOptions options;
        options.max_hand_speed_m_s = 1.0;
        const auto timeline = timelineOf({{strike(low, far_out), 2.0, 2.0, 5.0}}, 5.0, options);
        REQUIRE(timeline.made.size() == 1);
        double fastest = 0.0;
        for (double t = 0.0; t < 5.0; t += 0.002)
            fastest =
                std::max(fastest, 0.69 * apart(rightAt(timeline, t), rightAt(timeline, t + 0.002)) / 0.002);
        CHECK(fastest < 1.001);
        CHECK(fastest > 0.95);
        CHECK(apart(rightAt(timeline, 5.0 - 1.0 / 15.0), rest()) < 1e-9);
    }

    TEST_CASE("Idle, a body sways by centimetres at most, smoothly, from the relaxed pose to it") {
        const UpperBodyMotion motion = motionOf(BodyTrack{}, 20.0, 7);
        REQUIRE(motion.frames.size() == 300);
        const auto relaxed = jointsOf(relaxedUpperBody());
        double farthest = 0.0, fastest = 0.0;
        int still = 0;
        for (std::size_t f = 1; f < 300; ++f) {
            const auto before = jointsOf(motion.frames[f - 1]), joints = jointsOf(motion.frames[f]);
            double moved = 0.0;
            for (std::size_t j = 0; j < upper_joint_count; ++j) {
                farthest = std::max(farthest, glm::length(joints[j] - relaxed[j]));
                moved = std::max(moved, glm::length(joints[j] - before[j]));
            }
            fastest = std::max(fastest, 15.0 * moved);
            if (moved < 1e-6) ++still;
        }
        CHECK(farthest > 0.005);
        CHECK(farthest < 0.04);
        CHECK(fastest < 0.1);
        CHECK(still == 0);
        for (std::size_t j = 0; j < upper_joint_count; ++j) {
            CHECK(glm::length(jointsOf(motion.frames.front())[j] - relaxed[j]) < 1e-4);
            CHECK(glm::length(jointsOf(motion.frames.back())[j] - relaxed[j]) < 1e-4);
        }
        CHECK(motionOf(BodyTrack{}, 20.0, 7) == motion);
        CHECK_FALSE(motionOf(BodyTrack{}, 20.0, 8) == motion);
        CHECK(motionOf(BodyTrack{}, 0.01, 8).frames.size() == 1);
    }
}
