// Motions that come to rest, and bodies that stand still, against what is worked out by hand.
#include "motion/speech_gestures/finishing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

using namespace deixis;
using namespace deixis::motion;

namespace {

/// The right forearm raised by this angle from hanging, in the plane to the side.
UpperBodyPose raisedBy(double angle_rad) {
    UpperBodyPose pose = relaxedUpperBody();
    pose[UpperBone::right_upper_arm] = {0.0, -1.0, 0.0};
    pose[UpperBone::right_forearm] = {-std::sin(angle_rad), -std::cos(angle_rad), 0.0};
    return pose;
}

double angleOf(const UpperBodyPose& pose) {
    const Vec3& direction = pose[UpperBone::right_forearm];
    return std::atan2(-direction.x, -direction.y);
}

}  // namespace

TEST_SUITE("motion/finishing") {
    TEST_CASE("a fade goes along a minimum-jerk course to the pose, and nothing before it changes") {
        UpperBodyMotion motion;
        for (int f = 0; f < 31; ++f) motion.frames.push_back(raisedBy(1.0));
        const UpperBodyMotion before = motion;
        fadeTo(motion, 20, raisedBy(0.0));
        for (std::size_t f = 0; f <= 20; ++f) CHECK(angleOf(motion.frames[f]) == doctest::Approx(1.0));
        CHECK(motion.frames[10] == before.frames[10]);
        CHECK(angleOf(motion.frames[25]) == doctest::Approx(0.5));  // half of the way at half of the time
        // 10 u^3 - 15 u^4 + 6 u^5 at u = 0.2
        CHECK(angleOf(motion.frames[22]) == doctest::Approx(1.0 - 0.05792));
        CHECK(angleOf(motion.frames[30]) == doctest::Approx(0.0));
        UpperBodyMotion late = before;
        fadeTo(late, 30, raisedBy(0.0));
        CHECK(late == before);
    }

    TEST_CASE("a body that sways a little stands still; one that gestures is left alone") {
        // 2 s of swaying by 1 degree, then a reach of 1 s, then 2 s of swaying again.
        UpperBodyMotion motion;
        for (int f = 0; f < 75; ++f) {
            const double sway = 0.017 * std::sin(0.5 * f);
            const double reach = f < 30 ? 0.0 : f < 45 ? (f - 30) / 15.0 : 1.0;
            motion.frames.push_back(raisedBy(1.5 * reach + sway));
        }
        UpperBodyMotion still = motion;
        holdStill(still);
        for (std::size_t f = 1; f < 25; ++f) CHECK(still.frames[f] == still.frames[0]);
        for (std::size_t f = 31; f < 45; ++f) CHECK(still.frames[f] == motion.frames[f]);
        for (std::size_t f = 52; f < 75; ++f) CHECK(still.frames[f] == still.frames[74]);
        // No jump where it begins and ends: at most as fast as a still wrist may be, and a little more.
        for (std::size_t f = 1; f < 75; ++f) {
            const double was = std::abs(angleOf(motion.frames[f]) - angleOf(motion.frames[f - 1]));
            CHECK(std::abs(angleOf(still.frames[f]) - angleOf(still.frames[f - 1])) < was + 0.02);
        }
    }

    TEST_CASE("short rests, and motions of no or one frame, are left as they are") {
        UpperBodyMotion motion;
        for (int f = 0; f < 40; ++f) motion.frames.push_back(raisedBy(f % 10 < 5 ? 0.0 : 0.2 * (f % 10 - 4)));
        UpperBodyMotion same = motion;
        holdStill(same);
        CHECK(same == motion);
        UpperBodyMotion none;
        holdStill(none);
        fadeTo(none, 0, raisedBy(0.0));
        CHECK(none.frames.empty());
    }
}
