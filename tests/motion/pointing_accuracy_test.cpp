#include "motion/pointing/accuracy.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/pointing/placement.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "motion/synthesis/generator.hpp"

using namespace deixis;
using namespace deixis::motion;

namespace {

/// A forearm of 0.3 m whose hand runs along z, in a straight line to the target: the elbow lies so that the
/// forearm makes the angle (degrees) with the line to a target far ahead.
ArmTrack track(const std::vector<double>& hand_z, const std::vector<double>& degrees, double frame_time_s) {
    ArmTrack arm;
    arm.frame_time_s = frame_time_s;
    for (std::size_t f = 0; f < hand_z.size(); ++f) {
        const double angle = radiansFromDegrees(degrees[f]);
        const Vec3 hand(0.0, 1.0, hand_z[f]);
        arm.hand.push_back(hand);
        arm.elbow.push_back(hand - 0.3 * Vec3(std::sin(angle), 0.0, std::cos(angle)));
    }
    return arm;
}

const Vec3 far_ahead(0.0, 1.0, 5.0);

/// Equation 2 by hand: theta = 1 - angle/180.
double reward(double degrees) {
    return (std::exp(1.0 - degrees / 180.0) - 1.0) / std::exp(1.0);
}

GeneratedClip made(const char* system, const Vec3& target) {
    const auto generator = makeGenerator(system, referenceHumanoid(), DemonstrationParameters{});
    REQUIRE(generator);
    return (*generator)->generate({"T001", target, 5});
}

}  // namespace

TEST_SUITE("motion/pointing_accuracy") {
    TEST_CASE("The accuracy is the highest reward among slow frames of the window, worked by hand") {
        // 20 frames a second: the window of 0.15 s about frame 3 holds frames 2 to 4 (0.05 s either way).
        // Speeds: frame 2 (0.06 - 0)/0.1 = 0.6, frame 3 (0.07 - 0.05)/0.1 = 0.2, frame 4 (0.08 - 0.06)/0.1.
        const ArmTrack arm = track({0.0, 0.0, 0.05, 0.06, 0.07, 0.08, 0.08}, {90, 1, 2, 30, 10, 0, 0}, 0.05);
        const auto speed = speeds(arm.hand, arm.frame_time_s);
        CHECK(speed[0] == 0.0);
        CHECK(speed[2] == doctest::Approx(0.6));
        CHECK(speed[3] == doctest::Approx(0.2));
        CHECK(speed[6] == doctest::Approx(0.0));
        const auto accuracy = pointingAccuracy(arm, far_ahead, 3, {});
        REQUIRE(accuracy);
        CHECK(accuracy->frame == 4);  // frame 2 points better but is too fast, frame 5 lies outside
        CHECK(accuracy->reward == doctest::Approx(reward(10.0)).epsilon(1e-12));
        CHECK(degreesFromRadians(accuracy->error_rad) == doctest::Approx(10.0).epsilon(1e-12));
        const auto allowing_all = pointingAccuracy(arm, far_ahead, 3, {0.15, 10.0});
        REQUIRE(allowing_all);
        CHECK(allowing_all->frame == 2);
        const auto wide = pointingAccuracy(arm, far_ahead, 3, {0.20, 0.5});
        REQUIRE(wide);
        CHECK(wide->frame == 5);
    }

    TEST_CASE("A window at 30 frames a second holds two frames on either side, and ends with the clip") {
        std::vector<double> degrees(9, 40.0);
        const std::vector<double> still(9, 0.0);
        const auto best = [&](std::size_t better, int pointing) {
            auto angles = degrees;
            angles[better] = 3.0;
            return pointingAccuracy(track(still, angles, 1.0 / 30.0), far_ahead, pointing, {})->frame;
        };
        CHECK(best(2, 4) == 2);
        CHECK(best(6, 4) == 6);
        CHECK(best(1, 4) == 2);  // outside: the first of equal frames
        CHECK(best(7, 4) == 2);
        CHECK(best(0, 0) == 0);
        CHECK(best(8, 8) == 8);
    }

    TEST_CASE("There is no accuracy where the hand is fast in the whole window; exactly the limit is fast") {
        const ArmTrack fast = track({0.0, 0.05, 0.1, 0.15, 0.2}, {0, 0, 0, 0, 0}, 0.05);
        CHECK_FALSE(pointingAccuracy(fast, far_ahead, 2, {}));
        const ArmTrack at_limit = track({0.0, 0.25, 0.5, 0.75, 1.0}, {0, 0, 0, 0, 0}, 0.5);
        CHECK_FALSE(pointingAccuracy(at_limit, far_ahead, 2, {}));
        CHECK(pointingAccuracy(at_limit, far_ahead, 2, {0.15, 0.5000001}));
    }

    TEST_CASE("The reward runs from 0 behind to (e - 1)/e ahead, as the paper's Equation 2") {
        for (const double degrees : {0.0, 2.2, 7.8, 13.5, 34.0, 90.0, 180.0}) {
            const auto found = pointingRewards(track({0.0}, {degrees}, 0.1), far_ahead);
            CHECK(found.front() == doctest::Approx(reward(degrees)).epsilon(1e-9));
        }
        CHECK(reward(0.0) == doctest::Approx(1.0 - 1.0 / std::exp(1.0)));
        CHECK(reward(180.0) == 0.0);
        CHECK(reward(2.2) == doctest::Approx(0.62).epsilon(0.001));
        CHECK(reward(34.0) == doctest::Approx(0.46).epsilon(0.002));
    }

    TEST_CASE("A profile steps through time around the pointing frame, within the clip only") {
        const ArmTrack arm = track({0.0, 0.1, 0.3, 0.3}, {0, 10, 20, 20}, 0.1);
        const auto profile = pointingProfile(arm, far_ahead, 1, -0.3, 1.0, 0.05);
        CHECK(profile.first_step == -2);
        REQUIRE(profile.reward.size() == 7);
        CHECK(profile.reward[0] == doctest::Approx(reward(0)));
        CHECK(profile.reward[1] == doctest::Approx(0.5 * (reward(0) + reward(10))));
        CHECK(profile.reward[2] == doctest::Approx(reward(10)));
        CHECK(profile.speed_m_s[2] == doctest::Approx(1.5));
        CHECK(profile.speed_m_s[3] == doctest::Approx(0.5 * (1.5 + 1.0)));
        CHECK(profile.speed_m_s[6] == doctest::Approx(0.0));
    }

    TEST_CASE("The built-in `direct` points within a few degrees of the forearm's offset, and slowly") {
        for (const Vec3& target : {Vec3(0.9, 1.2, 1.8), Vec3(-1.4, 0.5, 1.3), Vec3(0.0, 2.0, 2.0)}) {
            const auto clip = made("direct", target);
            const HumanoidMap map = detectHumanoid(clip.clip.skeleton);
            CHECK_FALSE(standsAway(clip.clip, map));
            const auto poses = worldPoses(clip.clip);
            const auto arm = armTrack(poses, map, clip.hand, clip.clip.frame_time_s);
            REQUIRE(arm);
            const auto accuracy = pointingAccuracy(*arm, target, clip.peak_frame, {});
            REQUIRE(accuracy);
            // The same by whole poses.
            const auto world =
                worldPose(clip.clip.skeleton, clip.clip.frames[static_cast<std::size_t>(accuracy->frame)]);
            const Ray forearm = pointingRay(clip.clip.skeleton, map, world, clip.hand, PointingRay::forearm);
            CHECK(accuracy->error_rad == doctest::Approx(angularError(forearm, target)).epsilon(1e-9));
            CHECK(accuracy->reward > 0.45);
        }
    }

    TEST_CASE("A figure and its target moved together measure the same, wherever they stand") {
        const Vec3 target(1.0, 1.2, 1.7);
        const auto here = made("direct", target);
        const HumanoidMap map = detectHumanoid(here.clip.skeleton);
        const auto measured = [&](const Clip& clip, const Vec3& at) {
            const auto arm = armTrack(worldPoses(clip), map, here.hand, clip.frame_time_s);
            REQUIRE(arm);
            return pointingAccuracy(*arm, at, here.peak_frame, {})->reward;
        };
        const double expected = measured(here.clip, target);
        for (const Pose& elsewhere :
             {Pose{{0.02, 0.0, 0.0}, no_rotation}, Pose{{0.26, 0.0, 0.0}, no_rotation},
              Pose{{0.0, 0.0, 0.0}, yawRotation(0.36)}, Pose{{3.0, -0.95, -1.0}, yawRotation(2.0)}})
            CHECK(measured(moved(here.clip, elsewhere), transformPoint(elsewhere, target)) ==
                  doctest::Approx(expected).epsilon(1e-9));
    }

    TEST_CASE("A figure's own coordinates begin on the floor below its hips, wherever it stands and faces") {
        const auto here = made("direct", {1.0, 1.2, 1.7});
        const HumanoidMap map = detectHumanoid(here.clip.skeleton);
        const Clip stood = moved(here.clip, figureOnFloorFromClip(here.clip, map));
        const auto at = [&](const Clip& clip, Bone bone) {
            return worldPose(clip.skeleton, clip.frames.front())[static_cast<std::size_t>(map[bone])]
                .position;
        };
        CHECK(std::hypot(at(stood, Bone::hips).x, at(stood, Bone::hips).z) < 1e-9);
        CHECK(std::abs(at(stood, Bone::leftUpperLeg).z - at(stood, Bone::rightUpperLeg).z) < 1e-9);
        CHECK(at(stood, Bone::leftUpperLeg).x > at(stood, Bone::rightUpperLeg).x);
        // This avatar stands on the floor already.
        CHECK(std::abs(at(stood, Bone::leftFoot).y - at(here.clip, Bone::leftFoot).y) < 0.01);
        for (const Pose& elsewhere :
             {Pose{{3.0, 0.0, -1.0}, yawRotation(2.0)}, Pose{{0.3, -0.95, 0.0}, yawRotation(-0.1)}}) {
            const Clip there = moved(here.clip, elsewhere);
            CHECK(standsAway(there, map) == (elsewhere.position.x > 0.5));
            const Clip back = moved(there, figureOnFloorFromClip(there, map));
            for (const Bone bone : {Bone::hips, Bone::head, Bone::leftHand, Bone::rightFoot})
                CHECK(glm::length(at(back, bone) - at(stood, bone)) < 1e-9);
        }
    }

    TEST_CASE("A forearm of no length is rejected") {
        auto clip = made("direct", {1.0, 1.2, 1.7}).clip;
        const HumanoidMap map = detectHumanoid(clip.skeleton);
        for (LocalPose& frame : clip.frames)
            frame.joints[static_cast<std::size_t>(map[Bone::rightHand])].position = Vec3(0.0);
        const auto pointless = armTrack(worldPoses(clip), map, Side::right, clip.frame_time_s);
        REQUIRE_FALSE(pointless);
        CHECK(pointless.error().text().find("right forearm has no length in frame 0") != std::string::npos);
    }
}
