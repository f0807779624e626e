#include "motion/pointing/two_bone_ik.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/random.hpp"

using namespace deixis;
using namespace deixis::motion;

namespace {

Vec3 randomDirection(Random& random) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return glm::normalize(Vec3(x, y, z));
}

TwoLinkArm armOf(Side side) {
    const double sign = side == Side::left ? 1.0 : -1.0;
    return {side, {sign * 0.295, 0.0, 0.0}, {sign * 0.44, -0.01, 0.03}};
}

}  // namespace

TEST_SUITE("motion/two_bone_ik") {
    TEST_CASE("two equal links reach the diagonal of their square with a right angle") {
        const TwoLinkArm arm{Side::left, {0.3, 0.0, 0.0}, {0.3, 0.0, 0.0}};
        CHECK(flexionForReach(arm, 0.3 * std::sqrt(2.0)) == doctest::Approx(pi / 2.0));
        CHECK(flexionForReach(arm, 0.3) == doctest::Approx(2.0 * pi / 3.0));  // an equilateral triangle
    }

    TEST_CASE("the tip comes to where it was asked, the elbow on its side, whichever the arm") {
        Random random(11);
        for (int i = 0; i < 500; ++i) {
            const TwoLinkArm arm = armOf(i % 2 == 0 ? Side::left : Side::right);
            const Vec3 tip = random.uniform(0.30, 0.72) * randomDirection(random);
            const Vec3 wish = randomDirection(random);
            const Vec3 elbow_direction = glm::normalize(glm::cross(glm::cross(tip, wish), tip));
            const ArmSolution solution = solveArm(arm, tip, elbow_direction);
            const Vec3 reached = solution.upper_arm * tipInUpperArm(arm, solution.flexion_rad);
            CHECK(glm::length(reached - tip) < 1e-9);
            CHECK(solution.flexion_rad >= min_flexion_rad);
            CHECK(solution.flexion_rad <= max_flexion_rad);
            // Bent clearly, the elbow stands out towards the wished side.
            if (solution.flexion_rad > 0.5)
                CHECK(glm::dot(solution.upper_arm * arm.elbow, elbow_direction) > 0.02);
        }
    }

    TEST_CASE("an elbow bends forward, never backward") {
        for (const Side side : {Side::left, Side::right}) {
            const double sign = side == Side::left ? 1.0 : -1.0;
            const Vec3 forearm = elbowRotation(side, 1.0) * Vec3(sign, 0.0, 0.0);
            CHECK(forearm.z == doctest::Approx(std::sin(1.0)));
            CHECK(forearm.x == doctest::Approx(sign * std::cos(1.0)));
        }
    }

    TEST_CASE("a tip out of reach is pointed at with a straight arm") {
        const TwoLinkArm arm = armOf(Side::right);
        const Vec3 tip(-1.0, 0.5, 2.0);
        const ArmSolution solution = solveArm(arm, tip, Vec3(0, -1, 0));
        CHECK(solution.flexion_rad == doctest::Approx(min_flexion_rad));
        const Vec3 reached = solution.upper_arm * tipInUpperArm(arm, solution.flexion_rad);
        CHECK(angleBetween(reached, tip) < 1e-9);
    }

    TEST_CASE("the left arm's solution is the right arm's in a mirror") {
        const Vec3 tip(-0.2, 0.1, 0.6);
        const Vec3 down(-0.3, -1.0, 0.0);
        const ArmSolution right = solveArm(armOf(Side::right), tip, down);
        const ArmSolution left = solveArm(armOf(Side::left), {0.2, 0.1, 0.6}, {0.3, -1.0, 0.0});
        CHECK(left.flexion_rad == doctest::Approx(right.flexion_rad));
        const Vec3 a = right.upper_arm * Vec3(0.1, 0.2, 0.3);
        const Vec3 b = left.upper_arm * Vec3(-0.1, 0.2, 0.3);
        CHECK(glm::length(Vec3(-a.x, a.y, a.z) - b) < 1e-9);
    }

    TEST_CASE("A leg reaches any goal within its length and bends to the side on which it bent") {
        Random random(8);
        const TwoBones leg{{0.02, -0.42, 0.01}, {0.0, -0.40, -0.03}, {1.0, 0.0, 0.0}};
        for (int i = 0; i < 200; ++i) {
            const Quat turned = rotationBetween(randomDirection(random), randomDirection(random));
            Quat upper = turned;
            Quat lower = turned * glm::angleAxis(0.3 + 2.0 * random.uniform(), leg.hinge);
            const Vec3 side = glm::conjugate(upper) * glm::cross(upper * leg.upper, lower * leg.lower);
            const Vec3 goal = (0.2 + 0.6 * random.uniform()) * randomDirection(random);
            reach(leg, goal, upper, lower);
            CHECK(glm::length(upper * leg.upper + lower * leg.lower - goal) < 1e-9);
            const Vec3 after = glm::conjugate(upper) * glm::cross(upper * leg.upper, lower * leg.lower);
            CHECK(angleBetween(side, after) < 1e-6);
        }
    }

    TEST_CASE("What is too far is pointed at with a straight leg") {
        const TwoBones leg{{0.0, -0.42, 0.0}, {0.0, -0.40, 0.0}, {1.0, 0.0, 0.0}};
        Quat upper = no_rotation;
        Quat lower = glm::angleAxis(0.5, Vec3(1.0, 0.0, 0.0));
        reach(leg, {0.0, -3.0, 4.0}, upper, lower);
        CHECK(glm::length(upper * leg.upper + lower * leg.lower - 0.82 * Vec3(0.0, -0.6, 0.8)) < 1e-9);
    }
}
