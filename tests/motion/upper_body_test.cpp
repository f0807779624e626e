#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "avatar.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"

using namespace deixis;
using motion::Bone;
using motion::BonePositions;
using tests::avatar;
using tests::worldOf;

namespace {

/// The avatar with its arms moved, frame by frame, and the chest leaning.
motion::Clip armsMoving() {
    motion::Clip clip;
    clip.skeleton = avatar();
    for (int f = 0; f < 10; ++f) {
        auto pose = motion::relaxedPose(clip.skeleton);
        const auto turn = [&](Bone bone, const Vec3& axis, double degrees) {
            auto& joint = pose.joints[static_cast<std::size_t>(bone)];
            joint.orientation = joint.orientation * glm::angleAxis(radiansFromDegrees(degrees), axis);
        };
        turn(Bone::rightUpperArm, Vec3(0, 1, 0), 8.0 * f);
        turn(Bone::rightLowerArm, Vec3(0, 1, 0), 60.0);
        turn(Bone::upperChest, Vec3(1, 0, 0), 1.5 * f);
        clip.frames.push_back(pose);
    }
    return clip;
}

/// Only what such recordings know: trunk, head and arms; half as large and turned.
std::vector<BonePositions> upperBody(const motion::Clip& clip) {
    std::vector<BonePositions> out;
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        const auto world = worldOf(clip, f);
        out.emplace_back();
        for (const Bone bone : {Bone::spine, Bone::neck, Bone::head, Bone::leftUpperArm, Bone::leftLowerArm,
                                Bone::leftHand, Bone::rightUpperArm, Bone::rightLowerArm, Bone::rightHand})
            out.back()[bone] =
                yawRotation(2.0) * (0.5 * world[static_cast<std::size_t>(bone)].position) + Vec3(3, 1, 2);
    }
    return out;
}

}  // namespace

TEST_SUITE("motion/upper_body") {
    TEST_CASE("Arms of an upper body point as its positions say; hips and legs stand as at rest") {
        const motion::Clip clip = armsMoving();
        const auto back = motion::clipFromPositions(upperBody(clip), clip.frame_time_s, avatar(),
                                                    motion::mapByVrmNames(avatar()));
        REQUIRE_MESSAGE(back.has_value(), (back ? "" : back.error().text()));
        const auto rest = motion::worldPose(avatar(), motion::restPose(avatar()));
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            const auto expected = worldOf(clip, f);
            const auto found = worldOf(*back, f);
            const auto along = [](const std::vector<Pose>& world, Bone from, Bone to) {
                return world[static_cast<std::size_t>(to)].position -
                       world[static_cast<std::size_t>(from)].position;
            };
            for (const auto& [from, to] : {std::pair{Bone::rightUpperArm, Bone::rightLowerArm},
                                           {Bone::rightLowerArm, Bone::rightHand},
                                           {Bone::leftUpperArm, Bone::leftLowerArm},
                                           {Bone::leftLowerArm, Bone::leftHand}})
                CHECK(degreesFromRadians(angleBetween(along(expected, from, to), along(found, from, to))) <
                      0.01);
            for (const Bone bone : {Bone::hips, Bone::leftUpperLeg, Bone::rightFoot, Bone::leftToes})
                CHECK(glm::length(found[static_cast<std::size_t>(bone)].position -
                                  rest[static_cast<std::size_t>(bone)].position) < 1e-9);
            // The chest leans on as the positions do.
            const double lean = angleBetween(along(found, Bone::spine, Bone::neck), Vec3(0, 1, 0));
            const double expected_lean =
                angleBetween(along(expected, Bone::spine, Bone::neck), Vec3(0, 1, 0));
            CHECK(degreesFromRadians(std::abs(lean - expected_lean)) < 5.0);
        }
    }

    TEST_CASE("One leg joint anywhere makes it a whole person, whose other joints are asked for") {
        auto positions = upperBody(armsMoving());
        positions[3][Bone::leftFoot] = Vec3(3, 0, 2);
        const auto clip =
            motion::clipFromPositions(positions, 0.1, avatar(), motion::mapByVrmNames(avatar()));
        REQUIRE_FALSE(clip.has_value());
        CHECK(clip.error().message.find("frame 0 has no position for hips, leftUpperLeg") !=
              std::string::npos);
    }

    TEST_CASE("An upper body without spine and hips, or with a joint on another, is rejected") {
        auto positions = upperBody(armsMoving());
        positions[2][Bone::spine].reset();
        const auto missing =
            motion::clipFromPositions(positions, 0.1, avatar(), motion::mapByVrmNames(avatar()));
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().message.find("frame 2 has no position for hips") != std::string::npos);
        positions = upperBody(armsMoving());
        positions[1][Bone::leftUpperArm] = positions[1][Bone::rightUpperArm];
        const auto flat =
            motion::clipFromPositions(positions, 0.1, avatar(), motion::mapByVrmNames(avatar()));
        REQUIRE_FALSE(flat.has_value());
        CHECK(flat.error().message.find("in one place") != std::string::npos);
    }
}
