#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "assets/joints/clip_import.hpp"
#include "motion/pointing/pointing_phases.hpp"
#include "motion/retarget/retarget.hpp"
#include "shared_data.hpp"

using namespace deixis;

TEST_SUITE("assets/recorded_pointing") {
    TEST_CASE("In the gesture recorded by Kinect the right hand points, and holds about 3.6 s") {
        const auto path = tests::sharedData("pointing/labanotation_kinect/Ges05_demopoint.csv");
        DEIXIS_SKIP_WITHOUT(path);
        const auto imported = assets::importClip(path);
        REQUIRE(imported.has_value());
        const motion::Clip& clip = imported->clip;
        const auto map = motion::detectHumanoid(clip.skeleton);
        const auto world = motion::worldPoses(clip);
        const auto hand = motion::recognisedHand(world, map);
        CHECK(hand.hand == motion::Side::right);
        const auto found = motion::detectPhases(motion::jointCourse(world, map[motion::Bone::rightHand]),
                                                hand.hand, clip.frame_time_s);
        REQUIRE_MESSAGE(found.has_value(), (found ? "" : found.error().text()));
        // The arm is straight at 3.6 s; the hand comes to stand just after.
        CHECK(found->onset_frame / 30.0 < 3.0);
        CHECK(std::abs(found->peak_frame / 30.0 - 3.6) < 0.25);
        CHECK(found->hold_frame / 30.0 > 3.6);
        CHECK(found->clear_hold);
    }

    TEST_CASE("Two holds of the traffic take that stand alone are found in their pieces") {
        // Its other straight-arm holds run into one another; the hands hardly rest between them.
        const auto path =
            tests::sharedData("pointing/cmu_directing_traffic/DERIVED_directing_traffic_4_30fps.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const auto file = assets::readBvh(path, {});
        REQUIRE(file.has_value());
        const motion::Clip& clip = file->clip;
        const auto map = motion::detectHumanoid(clip.skeleton);
        const struct {
            motion::Side side;
            int first, last;
        } holds[] = {{motion::Side::left, 50, 64}, {motion::Side::right, 243, 256}};
        for (const auto& hold : holds) {
            CAPTURE(hold.first);
            constexpr int around = 30;
            motion::Clip piece = clip;
            const int from = hold.first - around;
            piece.frames.assign(clip.frames.begin() + from, clip.frames.begin() + hold.last + around);
            const auto course =
                motion::jointCourse(motion::worldPoses(piece), map[motion::armBones(hold.side).hand]);
            const auto found = motion::detectPhases(course, hold.side, clip.frame_time_s);
            REQUIRE(found.has_value());
            const int middle = (found->peak_frame + found->hold_frame) / 2 + from;
            CHECK(middle >= hold.first);
            CHECK(middle <= hold.last);
        }
    }
}
