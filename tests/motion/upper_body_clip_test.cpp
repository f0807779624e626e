#include "motion/upper_body/upper_body_clip.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "avatar.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "upper_body_poses.hpp"

using namespace deixis;
using namespace deixis::motion;
using deixis::tests::avatar;
using deixis::tests::avatarMap;
using deixis::tests::randomPose;
using doctest::Approx;

namespace {

double farthestDegrees(const UpperBodyPose& a, const UpperBodyPose& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < upper_bone_count; ++i)
        most = std::max(most, degreesFromRadians(angleBetween(a.directions[i], b.directions[i])));
    return most;
}

double turnDegrees(const Quat& a, const Quat& b) {
    const Quat between = glm::conjugate(a) * b;
    return degreesFromRadians(
        2.0 * std::atan2(glm::length(Vec3(between.x, between.y, between.z)), std::abs(between.w)));
}

double largestTurn(const LocalPose& a, const LocalPose& b) {
    double most = 0.0;
    for (std::size_t j = 0; j < a.joints.size(); ++j)
        most = std::max(most, turnDegrees(a.joints[j].orientation, b.joints[j].orientation));
    return most;
}

Vec3 anyDirection(Random& random) {
    for (;;) {
        const Vec3 v(random.normal(), random.normal(), random.normal());
        if (glm::length(v) > 0.1) return glm::normalize(v);
    }
}

/// Every direction turned by `degrees` about an axis of its own.
UpperBodyPose shaken(const UpperBodyPose& pose, double degrees, Random& random) {
    UpperBodyPose out = pose;
    for (Vec3& d : out.directions) {
        const Vec3 axis = glm::normalize(glm::cross(d, anyDirection(random)));
        d = glm::normalize(glm::angleAxis(radiansFromDegrees(degrees), axis) * d);
    }
    return out;
}

UpperBodyPose withArm(const Vec3& upper_arm, const Vec3& forearm) {
    UpperBodyPose pose = relaxedUpperBody();
    pose[UpperBone::right_upper_arm] = glm::normalize(upper_arm);
    pose[UpperBone::right_forearm] = glm::normalize(forearm);
    return pose;
}

/// The way that the right palm faces; it looks down in the T pose.
Vec3 palmOf(const UpperBodyPose& pose) {
    return worldPose(avatar(), avatarPose(pose))[indexOf(Bone::rightHand)].orientation * Vec3(0, -1, 0);
}

}  // namespace

TEST_SUITE("motion/upper_body_clip") {
    TEST_CASE(
        "Directions of 2000 poses come back from the avatar that takes them; its bones keep their length") {
        Random random(3);
        const LocalPose rest = restPose(avatar());
        for (int i = 0; i < 2000; ++i) {
            const UpperBodyPose asked = upperBodyOf(randomPose(random, 0.0));
            const LocalPose pose = avatarPose(asked);
            REQUIRE(pose.joints.size() == 55);
            CHECK(farthestDegrees(upperBodyOf(pose), asked) < 0.01);
            for (std::size_t j = 0; j < pose.joints.size(); ++j) {
                CHECK(pose.joints[j].position == rest.joints[j].position);
                CHECK(std::abs(glm::length(pose.joints[j].orientation) - 1.0) < 1e-9);
            }
        }
    }

    TEST_CASE("Hips and legs stand at rest, fingers as in the relaxed hand") {
        Random random(5);
        const LocalPose pose = avatarPose(upperBodyOf(randomPose(random)));
        const LocalPose relaxed = relaxedPose(avatar());
        for (const Bone bone : {Bone::hips, Bone::leftUpperLeg, Bone::rightFoot, Bone::leftIndexProximal,
                                Bone::rightThumbDistal})
            CHECK(pose.joints[indexOf(bone)].orientation == relaxed.joints[indexOf(bone)].orientation);
    }

    TEST_CASE("Elbows bend about their hinge, to the front and not over") {
        Random random(6);
        for (int i = 0; i < 1000; ++i) {
            const LocalPose made = randomPose(random, 45.0);
            const LocalPose pose = avatarPose(upperBodyOf(made));
            for (const Bone lower : {Bone::leftLowerArm, Bone::rightLowerArm}) {
                // The T pose's arm lies along x and bends about y; the forearm may roll about itself.
                const double side = lower == Bone::leftLowerArm ? 1.0 : -1.0;
                const Vec3 forearm = pose.joints[indexOf(lower)].orientation * Vec3(side, 0, 0);
                CHECK(std::abs(forearm.y) < 0.001);
                CHECK(forearm.z > 0.5);
            }
            for (const Bone upper : {Bone::leftUpperArm, Bone::rightUpperArm})
                CHECK(turnDegrees(worldPose(avatar(), made)[indexOf(upper)].orientation,
                                  worldPose(avatar(), pose)[indexOf(upper)].orientation) < 0.1);
        }
    }

    TEST_CASE("A small change of directions makes a small change of every joint") {
        Random random(7);
        for (int i = 0; i < 2000; ++i) {
            const UpperBodyPose pose = upperBodyOf(randomPose(random, 2.0));
            const double turn = largestTurn(avatarPose(pose), avatarPose(shaken(pose, 0.1, random)));
            CHECK(turn < 3.0);
        }
    }

    TEST_CASE("An arm that sways about being straight does not spin") {
        Random random(8);
        for (const Vec3& along : {Vec3(-0.1, -1, 0.1), Vec3(-1, 0, 0), Vec3(-0.2, 0, 1), Vec3(-0.5, 0.6, 0.6),
                                  Vec3(-0.2, 1, 0.1), Vec3(-0.7, -0.5, 0.5)}) {
            const LocalPose straight = avatarPose(withArm(along, along));
            for (int i = 0; i < 200; ++i) {
                const UpperBodyPose swayed = shaken(withArm(along, along), random.uniform(0.0, 2.0), random);
                CHECK(largestTurn(straight, avatarPose(swayed)) < 35.0);
            }
        }
    }

    TEST_CASE("Any nine directions make finite poses, each direction of trunk and arms as asked") {
        Random random(9);
        for (int i = 0; i < 2000; ++i) {
            UpperBodyPose pose;
            for (Vec3& d : pose.directions) d = anyDirection(random);
            if (i % 3 == 0) pose.directions[3] = pose.directions[6];
            if (i % 4 == 0) pose.directions[2] = pose.directions[1];
            if (i % 5 == 0) pose.directions[5] = -pose.directions[4];
            if (i % 7 == 0) pose.directions[0] = Vec3(0, -1, 0);
            const LocalPose made = avatarPose(pose);
            for (const Pose& joint : made.joints) REQUIRE(std::isfinite(glm::length(joint.orientation)));
            const UpperBodyPose back = upperBodyOf(made);
            for (std::size_t b = 0; b < upper_bone_count; ++b)
                if (b != 1)  // a neck is too short for any nose
                    CHECK(degreesFromRadians(angleBetween(back.directions[b], pose.directions[b])) < 0.01);
        }
    }

    TEST_CASE("Palms look inward before the body, up from an open arm, ahead from a raised forearm") {
        CHECK(palmOf(withArm({-0.1, -1, 0.1}, {0, 0, 1})).x > 0.5);
        CHECK(palmOf(withArm({-0.1, -1, 0.1}, {-0.7, 0, 0.7})).y > 0.5);
        CHECK(palmOf(withArm({-0.2, -0.8, 0.5}, {-0.1, 0.95, 0.3})).z > 0.5);
        CHECK(palmOf(relaxedUpperBody()).x > 0.7);
    }

    TEST_CASE("A mirrored pose is the avatar's mirror image") {
        Random random(10);
        const auto partners = mirrorPartners(avatar());
        for (int i = 0; i < 100; ++i) {
            const UpperBodyPose pose = upperBodyOf(randomPose(random));
            CHECK(largestTurn(avatarPose(mirrored(pose)), mirrored(avatar(), partners, avatarPose(pose))) <
                  1e-4);
        }
    }

    TEST_CASE("A clip's motion is the same by another skeleton's axes and rate, its hips turned away") {
        Clip clip;
        clip.skeleton = avatar();
        clip.frame_time_s = 1.0 / 60.0;
        Random random(11);
        const LocalPose from = randomPose(random), to = randomPose(random);
        for (int f = 0; f <= 60; ++f) {
            LocalPose pose = from;
            for (std::size_t j = 0; j < pose.joints.size(); ++j)
                pose.joints[j] = interpolate(from.joints[j], to.joints[j], f / 60.0);
            clip.frames.push_back(pose);
        }
        const Clip away = moved(clip, {{3, 0, 1}, yawRotation(2.0)});
        const auto motion = upperBodyOf(away, avatarMap());
        REQUIRE_MESSAGE(motion.has_value(), (motion ? "" : motion.error().text()));
        REQUIRE(motion->frames.size() == 16);
        for (std::size_t f = 0; f < 16; ++f)
            CHECK(farthestDegrees(motion->frames[f], upperBodyOf(clip.frames[4 * f])) < 0.01);
        const auto again = upperBodyOf(avatarClip(*motion), avatarMap());
        REQUIRE(again.has_value());
        REQUIRE(again->frames.size() == 16);
        for (std::size_t f = 0; f < 16; ++f)
            CHECK(farthestDegrees(again->frames[f], motion->frames[f]) < 0.01);
    }

    TEST_CASE("Directions are of a body whose hips face ahead, wherever it turns") {
        Random random(12);
        const LocalPose pose = randomPose(random);
        LocalPose turned_away = pose;
        turned_away.joints[indexOf(Bone::hips)].orientation = yawRotation(1.2);
        CHECK(farthestDegrees(upperBodyOf(turned_away), upperBodyOf(pose)) < 1e-6);
    }

    TEST_CASE("A clip without arms is refused, the bones named") {
        Clip clip;
        clip.skeleton = avatar();
        clip.frames.push_back(restPose(avatar()));
        HumanoidMap map = avatarMap();
        map[Bone::leftLowerArm] = -1;
        const auto motion = upperBodyOf(clip, map);
        REQUIRE_FALSE(motion.has_value());
        CHECK(motion.error().text().find("leftLowerArm") != std::string::npos);
    }
}
