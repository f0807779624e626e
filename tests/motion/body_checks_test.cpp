#include "motion/pointing/body_checks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/pointing/phases.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

using World = std::vector<Pose>;

World standing() {
    return worldPose(referenceHumanoid(), relaxedPose(referenceHumanoid()));
}

Vec3& place(World& world, Bone bone) {
    return world[static_cast<std::size_t>(referenceMap()[bone])].position;
}

const LimitViolation* find(const std::vector<LimitViolation>& all, JointLimit limit) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const LimitViolation& v) { return v.limit == limit; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

TEST_SUITE("motion/body_checks") {
    TEST_CASE("a foot that slides on the floor skates at its speed, one that is lifted does not") {
        // The left foot slides at 0.3 m/s; the right one stands. Their mean is 0.15 m/s.
        std::vector<World> world(31, standing());
        for (std::size_t f = 0; f < world.size(); ++f)
            place(world[f], Bone::leftToes).z += 0.3 * static_cast<double>(f) / 30.0;
        const auto sliding = footSkate(world, referenceMap(), 1.0 / 30.0);
        REQUIRE(sliding.has_value());
        CHECK(sliding->speed_m_s == Approx(0.15));
        CHECK(sliding->contact_share == Approx(1.0));

        // The same slide 1.25 cm above the floor counts by 2 - 2^0.5; at 3 cm it counts no more.
        for (const double height : {0.0125, 0.03}) {
            auto lifted = world;
            for (std::size_t f = 1; f < lifted.size(); ++f) place(lifted[f], Bone::leftToes).y += height;
            const auto skate = footSkate(lifted, referenceMap(), 1.0 / 30.0);
            const double weight = height < 0.025 ? 30.0 * (2.0 - std::sqrt(2.0)) : 0.0;
            CHECK(skate->speed_m_s == Approx(0.15 * (1.0 + weight) / 31.0));
        }
        CHECK(footSkate(std::vector<World>(5, standing()), referenceMap(), 0.1)->speed_m_s == 0.0);
        CHECK_FALSE(footSkate({standing()}, referenceMap(), 0.1).has_value());
    }

    TEST_CASE("a standing figure exceeds no limit and does not touch itself") {
        const std::vector<World> world(3, standing());
        CHECK(jointLimitViolations(referenceHumanoid(), referenceMap(), world).empty());
        CHECK(selfIntersections(referenceHumanoid(), referenceMap(), world).empty());
    }

    TEST_CASE("each limit is exceeded by the degrees that the pose was made with") {
        const Skeleton& avatar = referenceHumanoid();
        const auto violations = [&](Bone bone, double degrees, const Vec3& axis, bool from_rest) {
            LocalPose pose = from_rest ? restPose(avatar) : relaxedPose(avatar);
            pose.joints[static_cast<std::size_t>(referenceMap()[bone])].orientation =
                glm::angleAxis(radiansFromDegrees(degrees), axis);
            // Four frames, of which one is bent.
            std::vector<World> world(4, worldPose(avatar, restPose(avatar)));
            world[2] = worldPose(avatar, pose);
            return jointLimitViolations(avatar, referenceMap(), world);
        };
        const Vec3 x(1, 0, 0), y(0, 1, 0);
        // In the T pose the left arm points along +x: about y it bends forward or back.
        const struct {
            JointLimit limit;
            Bone bone;
            double degrees;
            Vec3 axis;
            double excess;
        } cases[] = {{JointLimit::elbow_flexion, Bone::leftLowerArm, -160.0, y, 10.0},
                     {JointLimit::wrist_bend, Bone::leftHand, -95.0, y, 15.0},
                     {JointLimit::knee_flexion, Bone::leftLowerLeg, 150.0, x, 15.0},
                     {JointLimit::hip_flexion, Bone::leftUpperLeg, -130.0, x, 10.0},
                     {JointLimit::trunk_rotation, Bone::spine, 60.0, y, 15.0},
                     {JointLimit::head_rotation, Bone::head, 75.0, y, 15.0},
                     {JointLimit::head_tilt, Bone::head, 60.0, x, 15.0},
                     {JointLimit::shoulder_extension, Bone::leftUpperArm, 75.0, y, 15.0}};
        for (const auto& c : cases) {
            INFO(std::string(jointLimitName(c.limit)));
            const auto found = violations(c.bone, c.degrees, c.axis, true);
            const LimitViolation* violation = find(found, c.limit);
            REQUIRE(violation != nullptr);
            // Trunk and thighs are not exactly vertical, nor bones quite straight, in the avatar's rest.
            CHECK(std::abs(violation->max_deg - c.excess) < 6.0);
            CHECK(violation->share == 0.25);
            CHECK(violation->frame == 2);
            CHECK(find(violations(c.bone, 0.3 * c.degrees, c.axis, true), c.limit) == nullptr);
        }
    }

    TEST_CASE("capsules are as far apart as their segments less both radii") {
        const Capsule upright{{0, 0, 0}, {0, 1, 0}, 0.1};
        CHECK(capsuleDistance(upright, {{1, 0, 0}, {1, 1, 0}, 0.2}) == Approx(0.7));           // parallel
        CHECK(capsuleDistance(upright, {{0.5, 0.5, -1}, {0.5, 0.5, 1}, 0.1}) == Approx(0.3));  // crossing
        CHECK(capsuleDistance(upright, {{0, 3, 0}, {0, 5, 0}, 0.1}) == Approx(1.8));           // end to end
        CHECK(capsuleDistance(upright, {{3, 5, 0}, {6, 5, 0}, 0.0}) == Approx(4.9));  // corner to corner
        CHECK(capsuleDistance(upright, {{0, 0.5, 0}, {0, 0.5, 0}, 0.05}) == Approx(-0.15));  // a ball inside
        const Capsule across{{-1, 0.5, 0}, {1, 0.5, 0}, 0.1};
        CHECK(capsuleDistance(upright, across) == Approx(-0.2));
        CHECK(capsuleDistance(across, upright) == capsuleDistance(upright, across));
    }

    TEST_CASE("a hand in the chest and one in the head are found with their depth") {
        World inside = standing();
        const Vec3 chest = 0.5 * (place(inside, Bone::rightUpperLeg) +
                                  0.5 * (place(inside, Bone::neck) + place(inside, Bone::rightUpperArm)));
        place(inside, Bone::rightHand) = chest;
        const auto found = selfIntersections(referenceHumanoid(), referenceMap(), {standing(), inside});
        REQUIRE(found.size() == 1);
        CHECK(found[0].side == Side::right);
        CHECK_FALSE(found[0].with_head);
        CHECK(found[0].depth_m == Approx(0.10 + 0.04));  // the axes meet: both radii
        CHECK(found[0].share == 0.5);
        CHECK(found[0].frame == 1);

        World touched = standing();
        place(touched, Bone::leftHand) = place(touched, Bone::head) + Vec3(0.0, 0.07, 0.10);
        place(touched, Bone::leftLowerArm) = place(touched, Bone::head) + Vec3(0.0, 0.07, 0.40);
        place(touched, Bone::leftMiddleProximal) = place(touched, Bone::leftHand);
        const auto head = selfIntersections(referenceHumanoid(), referenceMap(), {touched});
        REQUIRE(head.size() == 1);
        CHECK(head[0].with_head);
        CHECK(head[0].depth_m ==
              Approx(0.03).epsilon(0.1));  // 9 + 4 cm less 10, the neck being a little aslant
    }

    TEST_CASE("the built-in systems keep their feet, their joints' limits and themselves") {
        for (const std::string& name : generatorNames()) {
            CAPTURE(name);
            const auto generator = makeGenerator(name, referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            for (const Vec3& target : drawTargets(12, 5)) {
                const auto world = worldPoses((*generator)->generate({"T", target, 4}).clip);
                CHECK(footSkate(world, referenceMap(), 1.0 / 30.0)->speed_m_s < 0.01);
                CHECK(jointLimitViolations(referenceHumanoid(), referenceMap(), world).empty());
                CHECK(selfIntersections(referenceHumanoid(), referenceMap(), world).empty());
            }
        }
    }
}
