#include "motion/pointing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/reference_humanoid.hpp"

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
        for (const auto kind :
             {PointingRay::forearm, PointingRay::shoulder_hand, PointingRay::index_finger}) {
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

    TEST_CASE("Names of rays read back as the same ray, and other names are refused") {
        for (const auto kind : {PointingRay::eye_fingertip, PointingRay::index_finger, PointingRay::forearm,
                                PointingRay::shoulder_hand})
            CHECK(motion::pointingRayFromName(motion::pointingRayName(kind)).value() == kind);
        CHECK_FALSE(motion::pointingRayFromName("elbow").has_value());
    }
}
