#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/upper_body/upper_body.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "motion/upper_body/upper_body_style.hpp"
#include "upper_body_poses.hpp"

using namespace deixis;
using namespace deixis::motion;
using deixis::tests::randomPose;
using doctest::Approx;

namespace {

UpperBodyMotion randomMotion(std::size_t frames) {
    Random random(2);
    UpperBodyMotion motion;
    for (std::size_t f = 0; f < frames; ++f) motion.frames.push_back(upperBodyOf(randomPose(random)));
    return motion;
}

/// The relaxed pose with the right wrist carried about: the forearm turns by `step_deg` a frame, level.
UpperBodyMotion turningForearm(int frames, double step_deg) {
    UpperBodyMotion motion;
    for (int f = 0; f < frames; ++f) {
        motion.frames.push_back(relaxedUpperBody());
        const double angle = radiansFromDegrees(step_deg * f);
        motion.frames.back()[UpperBone::right_forearm] = Vec3(std::sin(angle), 0, std::cos(angle));
    }
    return motion;
}

}  // namespace

TEST_SUITE("motion/upper_body_pose") {
    TEST_CASE("A sound has as many frames as begin within it, at least one") {
        CHECK(frameCountOf(4.2) == 63);
        CHECK(frameCountOf(4.201) == 64);
        CHECK(frameCountOf(1.0) == 15);
        CHECK(frameCountOf(0.01) == 1);
        CHECK(frameCountOf(0.0) == 1);
        CHECK(frameCountOf(-3.0) == 1);
    }

    TEST_CASE("At ease one stands upright with hanging arms, the same on both sides") {
        const UpperBodyPose& pose = relaxedUpperBody();
        CHECK(pose == mirrored(pose));
        CHECK(pose[UpperBone::neck].y > 0.99);
        CHECK(pose[UpperBone::nose].z > 0.3);
        CHECK(pose[UpperBone::left_shoulder].x > 0.9);
        CHECK(pose[UpperBone::right_upper_arm].y < -0.9);
        CHECK(pose[UpperBone::right_forearm].z > 0.2);
    }

    TEST_CASE("Joints are as far from each other as the mean person's, and give the directions back") {
        for (const UpperBodyPose& pose : randomMotion(50).frames) {
            const UpperBodyJoints joints = jointsOf(pose);
            CHECK(joints[0] == Vec3(0.0));
            CHECK(glm::length(joints[5] - joints[4]) == Approx(0.36));
            CHECK(glm::length(joints[9] - joints[8]) == Approx(0.33));
            CHECK(glm::length(joints[3] - joints[2]) == Approx(0.14));
            const UpperBodyPose back = poseFromJoints(joints);
            for (std::size_t b = 0; b < upper_bone_count; ++b)
                CHECK(glm::length(back.directions[b] - pose.directions[b]) < 1e-12);
        }
        CHECK(poseFromJoints({}) == relaxedUpperBody());
    }

    TEST_CASE("27 numbers are a pose, of any lengths; others are refused") {
        const UpperBodyPose pose = randomMotion(1).frames[0];
        auto numbers = numbersOf(pose);
        CHECK(numbers[5 * 3 + 1] == pose[UpperBone::left_forearm].y);
        for (double& n : numbers) n *= 7.0;
        const auto read = poseFromNumbers(numbers);
        REQUIRE(read.has_value());
        for (std::size_t b = 0; b < upper_bone_count; ++b)
            CHECK(glm::length(read->directions[b] - pose.directions[b]) < 1e-12);
        CHECK(poseFromNumbers(std::span(numbers).first(26)).error().message.find("found 26 numbers") == 0);
        numbers[12] = numbers[13] = numbers[14] = 0.0;
        CHECK(poseFromNumbers(numbers).error().message == "found no direction for bone 4");
        numbers[12] = std::nan("");
        CHECK_FALSE(poseFromNumbers(numbers).has_value());
    }

    TEST_CASE("Between two poses every direction is of unit length and goes an even way") {
        const UpperBodyMotion motion = randomMotion(40);
        for (std::size_t f = 1; f < motion.frames.size(); ++f) {
            const UpperBodyPose &a = motion.frames[f - 1], &b = motion.frames[f];
            const UpperBodyPose quarter = interpolate(a, b, 0.25);
            for (std::size_t i = 0; i < upper_bone_count; ++i) {
                CHECK(glm::length(quarter.directions[i]) == Approx(1.0).epsilon(1e-12));
                const double whole = angleBetween(a.directions[i], b.directions[i]);
                CHECK(angleBetween(a.directions[i], quarter.directions[i]) == Approx(0.25 * whole));
                CHECK(angleBetween(quarter.directions[i], b.directions[i]) == Approx(0.75 * whole));
            }
            CHECK(interpolate(a, a, 0.3) == a);
        }
    }

    TEST_CASE("Sampling meets the frames and stays within the motion") {
        const UpperBodyMotion motion = randomMotion(5);
        CHECK(sample(motion, -1.0) == motion.frames.front());
        CHECK(sample(motion, 100.0) == motion.frames.back());
        CHECK(sample(motion, 2.0 / 15.0) == motion.frames[2]);
        CHECK(sample(motion, 2.5 / 15.0) == interpolate(motion.frames[2], motion.frames[3], 0.5));
    }

    TEST_CASE("A doubled speed takes half of the frames, between them, from the first pose to the last") {
        const UpperBodyMotion motion = turningForearm(31, 2.0);
        const UpperBodyMotion twice = atSpeed(motion, 2.0);
        REQUIRE(twice.frames.size() == 16);
        CHECK(twice.frames.front() == motion.frames.front());
        CHECK(twice.frames.back() == motion.frames.back());
        const UpperBodyMotion other = atSpeed(motion, 1.6);  // 18.75 steps: rounded to 19
        REQUIRE(other.frames.size() == 20);
        for (std::size_t f = 0; f < 20; ++f) {
            const double angle = radiansFromDegrees(60.0 * static_cast<double>(f) / 19.0);
            CHECK(glm::length(other.frames[f][UpperBone::right_forearm] -
                              Vec3(std::sin(angle), 0, std::cos(angle))) < 1e-12);
        }
        CHECK(atSpeed(motion, 1.0) == motion);
        CHECK(atSpeed(motion, 0.5).frames.size() == 61);
        CHECK(atSpeed(motion, 1000.0).frames.size() == 1);
    }

    TEST_CASE("The mirror changes sides and nothing else") {
        for (const UpperBodyPose& pose : randomMotion(20).frames) {
            const UpperBodyPose other = mirrored(pose);
            CHECK(mirrored(other) == pose);
            const Vec3 arm = pose[UpperBone::left_forearm];
            CHECK(other[UpperBone::right_forearm] == Vec3(-arm.x, arm.y, arm.z));
            CHECK(other[UpperBone::nose].y == pose[UpperBone::nose].y);
        }
    }

    TEST_CASE("Style is of all ten joints and of the wrists") {
        // Only one joint moves: the right wrist, by a chord of .33 m over 2 degrees, 61 steps a window of 30.
        const auto style = styleOf(turningForearm(61, 2.0));
        REQUIRE(style.has_value());
        REQUIRE(style->size() == 61);
        const double step_m = 2.0 * 0.33 * std::sin(radiansFromDegrees(1.0));
        CHECK((*style)[30].speed == Approx(31.0 * step_m / 30.0));
        CHECK((*style)[30].handedness == Approx(-1.0));
        CHECK((*style)[30].space > 0.3);
        CHECK_FALSE(styleOf(turningForearm(1, 2.0)).has_value());
        const auto left = styleOf(mirrored(turningForearm(61, 2.0)));
        CHECK((*left)[30].handedness == Approx(1.0));
        const StyleNorm norm{{0.0, 0.0, 0.0}, {1e-4, 1.0, 10.0}};
        CHECK(normalisedStyle((*style)[30], norm).speed == 3.0);
        CHECK(normalisedStyle((*style)[30], norm).handedness == Approx(-0.1));
    }
}
