#include "motion/pointing/phases.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

/// Where along a way of `way_m` the hand is at times that are given as seconds of rest, move, rest, move,
/// ...; each move goes to the next place.
struct Trajectory {
    std::vector<double> seconds;
    std::vector<double> places;  ///< share of the way after each move; it starts at 0
};

std::vector<Vec3> sampled(const Trajectory& trajectory, double fps, double noise_m = 0.0,
                          double way_m = 0.7) {
    double whole = 0.0;
    for (const double s : trajectory.seconds) whole += s;
    Random random(11);
    std::vector<Vec3> out;
    for (int i = 0; i / fps <= whole + 1e-9; ++i) {
        double t = i / fps;
        double place = 0.0;
        for (std::size_t k = 0; k < trajectory.seconds.size() && t > 0.0; ++k) {
            const double part = std::min(1.0, t / trajectory.seconds[k]);
            if (k % 2 == 1) {
                const double from = k == 1 ? 0.0 : trajectory.places[k / 2 - 1];
                place = from + (trajectory.places[k / 2] - from) * minimumJerk(part);
            }
            t -= trajectory.seconds[k];
        }
        out.push_back(way_m * place * Vec3(0.6, 0.8, 0.0) +
                      noise_m * Vec3(random.normal(), random.normal(), random.normal()));
    }
    return out;
}

DetectedGesture found(const std::vector<Vec3>& positions, double fps) {
    const auto phases = detectPhases(positions, Side::right, 1.0 / fps);
    REQUIRE_MESSAGE(phases.has_value(), (phases ? "" : phases.error().text()));
    return *phases;
}

void checkNear(int frame, double seconds, double fps, double slack_s = 2.0 / 30.0) {
    CHECK(std::abs(frame / fps - seconds) <= std::max(slack_s, 2.0 / fps) + 1e-9);
}

const Trajectory one_gesture{{0.5, 0.8, 1.0, 0.9, 0.4}, {1.0, 0.0}};

}  // namespace

TEST_SUITE("motion/pointing_phases") {
    TEST_CASE("raise, hold and retraction are found at any frame rate, with and without noise") {
        for (const double fps : {24.0, 30.0, 60.0, 120.0})
            for (const double noise : {0.0, 0.0005}) {
                CAPTURE(fps);
                CAPTURE(noise);
                const DetectedGesture p = found(sampled(one_gesture, fps, noise), fps);
                checkNear(p.phases.onset_frame, 0.5, fps);
                checkNear(p.phases.peak_frame, 1.3, fps);
                checkNear(p.phases.hold_frame, 2.3, fps);
                checkNear(p.phases.end_frame, 3.2, fps);
                CHECK(p.clear_hold);
                CHECK(p.returns);
                CHECK(p.strokes == 2);
            }
    }

    TEST_CASE("a correction on the way belongs to the raise; of several pauses the longest is the hold") {
        const Trajectory trajectory{{0.4, 0.7, 0.25, 0.4, 0.9, 0.8, 0.5}, {1.0, 1.4, 0.0}};
        const DetectedGesture p = found(sampled(trajectory, 30.0), 30.0);
        checkNear(p.phases.onset_frame, 0.4, 30.0);
        checkNear(p.phases.peak_frame, 1.75, 30.0);
        checkNear(p.phases.hold_frame, 2.65, 30.0);
        checkNear(p.phases.end_frame, 3.45, 30.0);
        CHECK(p.strokes == 3);
        CHECK(p.clear_hold);
    }

    TEST_CASE("of two gestures the one that is held longer is found, between its own rests") {
        const Trajectory trajectory{{0.3, 0.6, 0.3, 0.6, 0.6, 0.6, 1.0, 0.6, 0.4}, {1.0, 0.0, 1.0, 0.0}};
        const DetectedGesture p = found(sampled(trajectory, 30.0), 30.0);
        checkNear(p.phases.onset_frame, 2.4, 30.0);
        checkNear(p.phases.peak_frame, 3.0, 30.0);
        checkNear(p.phases.hold_frame, 4.0, 30.0);
        checkNear(p.phases.end_frame, 4.6, 30.0);
        CHECK(p.strokes == 2);
    }

    TEST_CASE("a hand that turns back at once has no clear hold, and says so") {
        const Trajectory trajectory{{0.4, 0.8, 0.001, 0.8, 0.4}, {1.0, 0.0}};
        const DetectedGesture p = found(sampled(trajectory, 30.0), 30.0);
        CHECK_FALSE(p.clear_hold);
        checkNear(p.phases.onset_frame, 0.4, 30.0);
        checkNear(p.phases.peak_frame, 1.2, 30.0, 0.15);
        checkNear(p.phases.hold_frame, 1.2, 30.0, 0.15);
        checkNear(p.phases.end_frame, 2.0, 30.0);
    }

    TEST_CASE("a hand that goes on moving while raised has no clear hold either") {
        std::vector<Vec3> positions = sampled(one_gesture, 30.0);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double presence = glm::length(positions[i]) / 0.7;
            positions[i].z += presence * 0.06 * std::sin(2.0 * pi * 1.2 * static_cast<double>(i) / 30.0);
        }
        const DetectedGesture p = found(positions, 30.0);
        CHECK_FALSE(p.clear_hold);
        checkNear(p.phases.peak_frame, 1.3, 30.0, 0.2);
        checkNear(p.phases.hold_frame, 2.3, 30.0, 0.2);
    }

    TEST_CASE("a clip that ends in the hold tells that the hand never returns") {
        const Trajectory trajectory{{0.4, 0.8, 1.0}, {1.0}};
        const DetectedGesture p = found(sampled(trajectory, 30.0), 30.0);
        CHECK_FALSE(p.returns);
        checkNear(p.phases.peak_frame, 1.2, 30.0);
        CHECK(p.phases.hold_frame == 65);
        CHECK(p.phases.end_frame == 66);  // the last frame
        CHECK(p.clear_hold);
    }

    TEST_CASE("a hand at rest, a position that is no number and a clip of two frames are rejected") {
        const auto rejection = [](const std::vector<Vec3>& positions) {
            const auto phases = detectPhases(positions, Side::left, 1.0 / 30.0);
            REQUIRE_FALSE(phases.has_value());
            return phases.error().text();
        };
        CHECK(rejection(sampled(one_gesture, 30.0, 0.0, 0.05)).find("left hand stays within 0.050 m") !=
              std::string::npos);
        auto broken = sampled(one_gesture, 30.0);
        broken[7].y = std::nan("");
        CHECK(rejection(broken).find("frame 7") != std::string::npos);
        CHECK(rejection({Vec3(0.0), Vec3(1.0)}).find("2 frames") != std::string::npos);
    }

    TEST_CASE("the built-in systems' phases are found within three frames, over many seeds") {
        for (const char* name : {"demonstration-nn", "direct", "stiff"}) {
            const auto generator = makeGenerator(name, referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            int clear = 0;
            const auto targets = drawTargets(60, 77);
            for (std::size_t i = 0; i < targets.size(); ++i) {
                CAPTURE(name);
                CAPTURE(i);
                const GeneratedClip made = (*generator)->generate({"T", targets[i], 900 + i});
                const auto world = worldPoses(made.clip);
                const PointingHand hand = recognisedHand(world, referenceMap());
                CHECK(hand.hand == made.hand);
                CHECK(hand.displacement_m > 3.0 * hand.other_displacement_m);
                const auto p = detectPhases(jointTrajectory(world, referenceMap()[armBones(made.hand).hand]),
                                            made.hand, made.clip.frame_time_s);
                REQUIRE(p.has_value());
                CHECK(std::abs(p->phases.onset_frame - made.onset_frame) <= 2);
                CHECK(std::abs(p->phases.peak_frame - made.peak_frame) <= 2);
                CHECK(std::abs(p->phases.hold_frame - made.hold_frame) <= 2);
                CHECK(std::abs(p->phases.end_frame - made.end_frame) <= 3);
                CHECK(p->returns);
                clear += p->clear_hold ? 1 : 0;
            }
            CHECK(clear == static_cast<int>(targets.size()));
        }
    }

    TEST_CASE("of the drifting system onset and end are found, and most of its holds are called unclear") {
        const auto generator = makeGenerator("drifting", referenceHumanoid(), {});
        REQUIRE(generator.has_value());
        const auto targets = drawTargets(40, 78);
        std::vector<double> peak_off, hold_off;
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const GeneratedClip made = (*generator)->generate({"T", targets[i], 300 + i});
            const auto world = worldPoses(made.clip);
            const auto p = detectPhases(jointTrajectory(world, referenceMap()[armBones(made.hand).hand]),
                                        made.hand, made.clip.frame_time_s);
            REQUIRE(p.has_value());
            CHECK(std::abs(p->phases.onset_frame - made.onset_frame) <= 4);
            CHECK(std::abs(p->phases.end_frame - made.end_frame) <= 4);
            peak_off.push_back(std::abs(p->phases.peak_frame - made.peak_frame));
            hold_off.push_back(std::abs(p->phases.hold_frame - made.hold_frame));
        }
        CHECK(median(peak_off) <= 4.0);
        CHECK(median(hold_off) <= 4.0);
    }
}
