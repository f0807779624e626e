// Feet of recordings in which they slide and sink.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "avatar.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"

using namespace deixis;
using motion::Bone;
using motion::Clip;
using tests::avatar;
using tests::avatarMap;

namespace {

/// Somebody who stands with bent knees and sways; the recording lets the whole body slide and bob by this
/// much.
Clip sliding(double slide_m, double bob_m, double fps) {
    Clip clip;
    clip.skeleton = avatar();
    clip.frame_time_s = 1.0 / fps;
    for (int f = 0; f < static_cast<int>(4 * fps); ++f) {
        auto pose = motion::relaxedPose(avatar());
        const double t = f / fps;
        const auto bend = [&](Bone bone, double degrees) {
            pose.joints[static_cast<std::size_t>(bone)].orientation =
                glm::angleAxis(radiansFromDegrees(degrees), Vec3(1, 0, 0));
        };
        const double sway = 4.0 * std::sin(2.0 * t);
        for (const bool left : {true, false}) {
            bend(left ? Bone::leftUpperLeg : Bone::rightUpperLeg, -20 + sway);
            bend(left ? Bone::leftLowerLeg : Bone::rightLowerLeg, 40);
            bend(left ? Bone::leftFoot : Bone::rightFoot, -20 - sway + 3.0 * std::sin(5.0 * t));
        }
        pose.joints[0].position +=
            Vec3(slide_m * std::sin(1.5 * t), -0.1 + bob_m * std::sin(2.5 * t), slide_m * std::cos(1.5 * t));
        clip.frames.push_back(pose);
    }
    return clip;
}

std::vector<Vec3> pathOf(const Clip& clip, Bone bone) {
    std::vector<Vec3> path;
    for (const auto& frame : clip.frames)
        path.push_back(motion::worldPose(clip.skeleton, frame)[static_cast<std::size_t>(bone)].position);
    return path;
}

/// How far the points lie from the first, along the floor and up.
std::pair<double, double> wandering(const std::vector<Vec3>& path) {
    double along = 0.0;
    double height = 0.0;
    for (const Vec3& p : path) {
        along = std::max(along, std::hypot(p.x - path[0].x, p.z - path[0].z));
        height = std::max(height, std::abs(p.y - path[0].y));
    }
    return {along, height};
}

}  // namespace

TEST_SUITE("motion/retarget_feet") {
    TEST_CASE("Feet that stand stay within 5 mm, and on the floor") {
        for (const double fps : {24.0, 30.0, 120.0}) {
            CAPTURE(fps);
            motion::RetargetReport report;
            const Clip source = sliding(0.03, 0.015, fps);
            const auto clip = motion::retarget(source, avatarMap(), avatar(), avatarMap(), {}, &report);
            REQUIRE(clip.has_value());
            REQUIRE(wandering(pathOf(source, Bone::leftToes)).first > 0.03);
            for (const Bone toes : {Bone::leftToes, Bone::rightToes}) {
                const auto [along, height] = wandering(pathOf(*clip, toes));
                CHECK(along < 0.005);
                CHECK(height < 0.005);
            }
            CHECK(report.feet.standing_share > 0.99);
            CHECK(report.feet.before_m_s > 0.02);
            CHECK(report.feet.after_m_s < 0.002);
            CHECK(report.feet.lowest_before_m < -0.005);
            CHECK(report.feet.lowest_after_m > -0.001);
            // The body goes its own way still.
            CHECK(wandering(pathOf(*clip, Bone::head)).first > 0.03);
        }
    }

    TEST_CASE("Planted legs keep their bones' lengths and their knees in front") {
        const auto clip = motion::retarget(sliding(0.04, 0.02, 30.0), avatarMap(), avatar(), avatarMap());
        REQUIRE(clip.has_value());
        for (const auto& frame : clip->frames) {
            const auto world = motion::worldPose(avatar(), frame);
            const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(bone)].position; };
            const double thigh =
                glm::length(avatar().joints[static_cast<std::size_t>(Bone::leftLowerLeg)].rest.position);
            CHECK(glm::length(at(Bone::leftLowerLeg) - at(Bone::leftUpperLeg)) == doctest::Approx(thigh));
            const Vec3 middle = 0.5 * (at(Bone::leftUpperLeg) + at(Bone::leftFoot));
            CHECK(at(Bone::leftLowerLeg).z > middle.z);
        }
    }

    TEST_CASE("A person who floats or lies down is not pulled to the floor") {
        Clip clip = sliding(0.0, 0.0, 30.0);
        for (std::size_t f = 60; f < clip.frames.size(); ++f)  // a jump that stays up
            clip.frames[f].joints[0].position.y += 0.5;
        const auto back = motion::retarget(clip, avatarMap(), avatar(), avatarMap());
        REQUIRE(back.has_value());
        CHECK(pathOf(*back, Bone::leftFoot).back().y > 0.5);
    }

    TEST_CASE("A foot that slides on and on is let go, not dragged along") {
        Clip clip = sliding(0.0, 0.0, 30.0);
        for (std::size_t f = 0; f < clip.frames.size(); ++f)
            clip.frames[f].joints[0].position.x += 0.006 * static_cast<double>(f);  // 0.18 m/s
        const auto back = motion::retarget(clip, avatarMap(), avatar(), avatarMap());
        REQUIRE(back.has_value());
        const auto feet = pathOf(*back, Bone::leftFoot);
        const auto hips = pathOf(*back, Bone::hips);
        for (std::size_t f = 0; f < feet.size(); ++f)
            CHECK(std::abs((feet[f].x - feet[0].x) - (hips[f].x - hips[0].x)) < 0.13);
    }

    TEST_CASE("Every correction is smooth: no joint jumps that did not jump before") {
        const Clip source = sliding(0.03, 0.02, 60.0);
        const auto clip = motion::retarget(source, avatarMap(), avatar(), avatarMap());
        REQUIRE(clip.has_value());
        for (const Bone bone : {Bone::leftLowerLeg, Bone::rightFoot, Bone::head}) {
            const auto path = pathOf(*clip, bone);
            for (std::size_t f = 1; f < path.size(); ++f)
                CHECK(glm::length(path[f] - path[f - 1]) < 0.008);  // 0.5 m/s
        }
    }
}
