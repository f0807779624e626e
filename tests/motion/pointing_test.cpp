#include "motion/pointing/rays.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using doctest::Approx;
using motion::PointingRay;
using motion::Side;

TEST_SUITE("motion/pointing") {
    TEST_CASE(
        "The reward of equation 2 is (e^theta - 1)/e with theta from 1 straight at it to 0 straight away") {
        const Vec3 elbow(0, 1, 0);
        const Vec3 hand(0, 1, 0.25);
        // By hand from the paper's equation: angle 0, 90 and 180 degrees.
        CHECK(motion::pointingReward(elbow, hand, {0, 1, 3}) == Approx((std::exp(1.0) - 1) / std::exp(1.0)));
        CHECK(motion::pointingReward(elbow, hand, {0, 4, 0.25}) ==
              Approx((std::exp(0.5) - 1) / std::exp(1.0)));
        CHECK(motion::pointingReward(elbow, hand, {0, 1, -3}) == Approx(0.0));
    }

    TEST_CASE("In the T pose every ray of an arm runs outwards from its far end") {
        const auto& avatar = motion::referenceHumanoid();
        const auto map = motion::mapByVrmNames(avatar);
        const auto world = motion::worldPose(avatar, motion::restPose(avatar));
        for (const auto kind : {PointingRay::forearm, PointingRay::shoulder_hand, PointingRay::index_finger,
                                PointingRay::shoulder_fingertip, PointingRay::elbow_fingertip}) {
            const Ray left = motion::pointingRay(avatar, map, world, Side::left, kind);
            const Ray right = motion::pointingRay(avatar, map, world, Side::right, kind);
            CHECK(glm::length(left.direction) == Approx(1.0));
            CHECK(left.direction.x > 0.99);
            CHECK(right.direction.x < -0.99);
            CHECK(left.origin.x == Approx(-right.origin.x));
        }
        const Vec3 tip = motion::fingertipPosition(avatar, map, world, Side::left);
        CHECK(tip.x == Approx(0.912));  // the end of the distal index bone, as the avatar's table says
        const Ray sight = motion::pointingRay(avatar, map, world, Side::left, PointingRay::eye_fingertip);
        const Vec3 eyes = motion::eyePosition(map, world);
        CHECK(eyes.x == Approx(0.0));
        CHECK(glm::length(sight.origin - tip) < 1e-12);
        CHECK(motion::angularError(sight, tip + 2.0 * (tip - eyes)) < 1e-9);
    }

    TEST_CASE("Without fingers the rays fall back to the hand") {
        const auto& avatar = motion::referenceHumanoid();
        auto map = motion::mapByVrmNames(avatar);
        for (const auto bone : {motion::Bone::leftIndexProximal, motion::Bone::leftIndexIntermediate,
                                motion::Bone::leftIndexDistal})
            map[bone] = -1;
        const auto world = motion::worldPose(avatar, motion::restPose(avatar));
        const Ray forearm = motion::pointingRay(avatar, map, world, Side::left, PointingRay::forearm);
        const Ray finger = motion::pointingRay(avatar, map, world, Side::left, PointingRay::index_finger);
        CHECK(glm::length(forearm.origin - finger.origin) < 1e-12);
        CHECK(glm::length(forearm.direction - finger.direction) < 1e-12);
    }

    TEST_CASE("The angular error is the angle between ray and target") {
        const Ray ray{{0, 1, 0}, {0, 0, 1}};
        CHECK(motion::angularError(ray, {0, 1, 5}) == Approx(0.0));
        CHECK(degreesFromRadians(motion::angularError(ray, {1, 1, 1})) == Approx(45.0));
        CHECK(degreesFromRadians(motion::angularError(ray, {0, 1, -1})) == Approx(180.0));
    }

    TEST_CASE("The head's ray starts between the eyes and goes where the face looks, turned as the head is") {
        const auto& avatar = motion::referenceHumanoid();
        const auto map = motion::mapByVrmNames(avatar);
        motion::LocalPose pose = motion::restPose(avatar);
        const auto ray = [&] {
            return motion::pointingRay(avatar, map, motion::worldPose(avatar, pose), Side::left,
                                       PointingRay::head);
        };
        CHECK(glm::length(ray().direction - Vec3(0, 0, 1)) < 0.02);
        const Vec3 before = ray().direction;
        const Quat turn = yawRotation(radiansFromDegrees(40.0));
        pose.joints[static_cast<std::size_t>(map[motion::Bone::head])].orientation = turn;
        CHECK(glm::length(ray().direction - turn * before) < 1e-12);
        const auto world = motion::worldPose(avatar, pose);
        CHECK(glm::length(ray().origin - motion::eyePosition(map, world)) < 1e-12);
    }

    TEST_CASE("A skeleton whose rest pose stands otherwise has the same head ray") {
        // The whole figure rests lying on its back (z up), and is stood up by its root in the pose.
        motion::Skeleton lying = motion::referenceHumanoid();
        const Quat down = glm::angleAxis(radiansFromDegrees(-90.0), Vec3(1, 0, 0));
        const auto map = motion::mapByVrmNames(lying);
        lying.joints[0].rest = Pose{Vec3(0.0), down};
        motion::LocalPose pose = motion::restPose(lying);
        pose.joints[0].orientation = no_rotation;
        const Vec3 face = motion::headDirection(lying, map, motion::worldPose(lying, pose));
        CHECK(glm::length(face - Vec3(0, 0, 1)) < 0.02);
    }

    TEST_CASE("Bones of no length give a ray without direction") {
        const auto& avatar = motion::referenceHumanoid();
        const auto map = motion::mapByVrmNames(avatar);
        auto world = motion::worldPose(avatar, motion::restPose(avatar));
        world[static_cast<std::size_t>(map[motion::Bone::leftHand])].position =
            world[static_cast<std::size_t>(map[motion::Bone::leftLowerArm])].position;
        CHECK(motion::pointingRay(avatar, map, world, Side::left, PointingRay::forearm).direction ==
              Vec3(0.0));
    }

    TEST_CASE("The distance to a ray is the perpendicular before it, and to its origin behind it") {
        const Ray ray{{0, 1, 0}, {0, 0, 1}};
        CHECK(motion::distanceToRay(ray, {3, 5, 7}).distance_m == Approx(5.0));
        CHECK_FALSE(motion::distanceToRay(ray, {3, 5, 7}).points_away);
        CHECK(motion::distanceToRay(ray, {0, 1, 2}).distance_m == 0.0);
        CHECK(motion::distanceToRay(ray, {2, 1, -2}).distance_m == Approx(std::sqrt(8.0)));
        CHECK(motion::distanceToRay(ray, {2, 1, -2}).points_away);
    }

    TEST_CASE(
        "The ball that is chosen is the one missed by the smallest angle, not by the smallest distance") {
        const Ray ray{{0, 0, 0}, {0, 0, 1}};
        // 0.3 m aside at 1 m is 16.7 degrees; 0.5 m aside at 3 m is 9.5 degrees; one behind.
        const std::vector<Vec3> balls{{0.3, 0, 1}, {0, 0.5, 3}, {0, 0, -1}};
        const auto choice = motion::chosenBall(ray, balls);
        REQUIRE(choice.has_value());
        CHECK(choice->ball == 1);
        CHECK(choice->error_rad == Approx(std::atan2(0.5, 3.0)));
        CHECK(choice->margin_rad.value() == Approx(std::atan2(0.3, 1.0) - std::atan2(0.5, 3.0)));
        // The best comes first: the margin is still to the second best.
        const auto first = motion::chosenBall(ray, {balls[1], balls[2], balls[0]});
        CHECK(first->ball == 0);
        CHECK(*first->margin_rad == Approx(*choice->margin_rad));
        CHECK_FALSE(motion::chosenBall(ray, {balls[0]})->margin_rad.has_value());
        CHECK_FALSE(motion::chosenBall(ray, {}).has_value());
    }

    TEST_CASE("Names of rays read back as the same ray, and other names are rejected") {
        for (const auto kind : motion::all_pointing_rays)
            CHECK(motion::pointingRayFromName(motion::pointingRayName(kind)).value() == kind);
        CHECK_FALSE(motion::pointingRayFromName("elbow").has_value());
    }
}
