// Rigs whose toes begin straight below the ankle.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "avatar.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"

using namespace deixis;
using motion::Bone;
using tests::avatar;
using tests::avatarMap;

namespace {

/// The reference humanoid with other feet: the toes' joint so far from the ankle, their tip so far from
/// there.
motion::Clip standing(const Vec3& toes, const Vec3& tip, const Quat& way) {
    motion::Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    for (const Bone bone : {Bone::leftToes, Bone::rightToes}) {
        auto& joint = clip.skeleton.joints[static_cast<std::size_t>(bone)];
        joint.rest.position = toes;
        joint.end_site = tip;
    }
    auto pose = motion::restPose(clip.skeleton);
    for (const Bone bone : {Bone::leftFoot, Bone::rightFoot})
        pose.joints[static_cast<std::size_t>(bone)].orientation = way;
    clip.frames.assign(3, pose);
    return clip;
}

Vec3 ankleToToes(const motion::Clip& clip, Bone foot, Bone toes) {
    const auto world = motion::worldPose(clip.skeleton, clip.frames[1]);
    return glm::normalize(world[static_cast<std::size_t>(avatarMap()[toes])].position -
                          world[static_cast<std::size_t>(avatarMap()[foot])].position);
}

}  // namespace

TEST_SUITE("motion/foot_alignment") {
    TEST_CASE("A foot whose toes begin straight below the ankle points where their tip lies") {
        const motion::HumanoidMap map = motion::mapByVrmNames(motion::referenceHumanoid());
        const auto rest = motion::worldPose(avatar(), motion::restPose(avatar()));
        for (const double turn_deg : {0.0, 25.0}) {
            const Quat out = yawRotation(radiansFromDegrees(turn_deg));
            for (const Vec3& toes : {Vec3(0, -0.07, 0), Vec3(0.001, -0.07, -0.004), Vec3(0, -0.07, 0.02)}) {
                CAPTURE(turn_deg);
                CAPTURE(toes.z);
                motion::RetargetOptions options;
                options.plant_feet = false;
                const auto made =
                    motion::retarget(standing(toes, {0, 0, 0.15}, out), map, avatar(), avatarMap(), options);
                REQUIRE(made.has_value());
                for (const bool left : {true, false}) {
                    const Bone foot = left ? Bone::leftFoot : Bone::rightFoot;
                    const Bone end = left ? Bone::leftToes : Bone::rightToes;
                    const Vec3 found = ankleToToes(*made, foot, end);
                    const Vec3 flat = rest[static_cast<std::size_t>(avatarMap()[end])].position -
                                      rest[static_cast<std::size_t>(avatarMap()[foot])].position;
                    // As the avatar stands, turned as the source's foot is.
                    CHECK(angleBetween(found, out * flat) < radiansFromDegrees(4.0));
                }
            }
        }
    }

    TEST_CASE("Where no tip tells either, the foot goes on as the shin faces") {
        const motion::HumanoidMap map = motion::mapByVrmNames(motion::referenceHumanoid());
        const auto made =
            motion::retarget(standing({0, -0.07, 0}, {0, -0.03, 0}, no_rotation), map, avatar(), avatarMap());
        REQUIRE(made.has_value());
        CHECK(ankleToToes(*made, Bone::leftFoot, Bone::leftToes).z > 0.8);
        CHECK(ankleToToes(*made, Bone::rightFoot, Bone::rightToes).z > 0.8);
    }
}
