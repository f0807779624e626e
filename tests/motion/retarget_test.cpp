#include "motion/retarget/retarget.hpp"
#include "avatar.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using motion::Bone;
using motion::Clip;
using tests::avatar;
using tests::avatarMap;
using tests::worldOf;

namespace {

Quat about(const Vec3& axis, double degrees) {
    return glm::angleAxis(radiansFromDegrees(degrees), axis);
}

/// The avatar stepping on the spot and swinging its arms, elbows and knees bent, trunk and head turning.
Clip exercise() {
    Clip clip;
    clip.skeleton = avatar();
    clip.frame_time_s = 1.0 / 30.0;
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (int f = 0; f < 60; ++f) {
        auto pose = motion::relaxedPose(avatar());
        const double s = std::sin(0.2 * f);
        const auto turn = [&](Bone bone, const Quat& by) {
            auto& q = pose.joints[static_cast<std::size_t>(bone)].orientation;
            q = by * q;
        };
        turn(Bone::hips, about(y, 10 * s));
        turn(Bone::chest, about(y, -20 * s) * about(x, 5));
        turn(Bone::head, about(y, 25 * s));
        for (const double side : {1.0, -1.0}) {
            const auto bone = [&](Bone b) { return side > 0 ? b : motion::mirroredBone(b); };
            turn(bone(Bone::leftUpperArm), about(x, -30 + 30 * side * s) * about(z, 20 * side));
            turn(bone(Bone::leftLowerArm), about(y, -side * (40 + 30 * s)));
            turn(bone(Bone::leftUpperLeg), about(x, -25 + 25 * side * s));
            turn(bone(Bone::leftLowerLeg), about(x, 40 - 25 * side * s));
        }
        pose.joints[0].position += Vec3(0.01 * f, 0.0, 0.0);
        clip.frames.push_back(pose);
    }
    return clip;
}

/// The same motion told by another rig: each joint's axes turned by a constant rotation, so that its rest
/// pose (OFFSETs alone) is another; in other units; turned as a whole.
Clip otherRig(const Clip& clip, const std::function<Quat(Bone)>& axes, double units_per_metre,
              const Quat& whole) {
    Clip out = clip;
    const auto axes_of = [&](int joint) { return joint < 0 ? no_rotation : axes(static_cast<Bone>(joint)); };
    for (std::size_t j = 0; j < out.skeleton.joints.size(); ++j) {
        auto& joint = out.skeleton.joints[j];
        const Quat parent_from_new = glm::conjugate(axes_of(joint.parent));
        joint.rest.position = parent_from_new * joint.rest.position * units_per_metre;
        if (joint.end_site)
            joint.end_site = glm::conjugate(axes_of(static_cast<int>(j))) * *joint.end_site * units_per_metre;
        for (auto& frame : out.frames) {
            Pose& pose = frame.joints[j];
            pose.orientation = parent_from_new * pose.orientation * axes_of(static_cast<int>(j));
            pose.position = parent_from_new * pose.position * units_per_metre;
            if (joint.parent < 0) pose = Pose{Vec3(0.0), whole} * pose;
        }
    }
    return out;
}

constexpr Bone limbs[] = {Bone::leftUpperArm,           Bone::leftLowerArm,  Bone::rightUpperArm,
                          Bone::rightLowerArm,          Bone::leftUpperLeg,  Bone::leftLowerLeg,
                          Bone::rightUpperLeg,          Bone::rightLowerLeg, Bone::leftIndexProximal,
                          Bone::rightLittleIntermediate};

Vec3 direction(const std::vector<Pose>& world, Bone bone) {
    const auto j = static_cast<std::size_t>(bone);  // in the avatar, the next bone of a limb comes next
    return glm::normalize(world[j + 1].position - world[j].position);
}

/// Largest angle between limbs of two clips of the avatar, degrees; both turned to face +z at the start.
double limbError(const Clip& a, const Clip& b) {
    const auto facing = [](const Clip& clip) {
        const Vec3 z = worldOf(clip, 0)[0].orientation * Vec3(0, 0, 1);
        return yawRotation(-std::atan2(z.x, z.z));
    };
    const Quat turn_a = facing(a);
    const Quat turn_b = facing(b);
    double worst = 0.0;
    for (std::size_t f = 0; f < a.frames.size(); ++f) {
        const auto world_a = worldOf(a, f);
        const auto world_b = worldOf(b, f);
        for (const Bone bone : limbs)
            worst = std::max(
                worst, angleBetween(turn_a * direction(world_a, bone), turn_b * direction(world_b, bone)));
    }
    return degreesFromRadians(worst);
}

/// Largest difference in a bone's whole rotation, degrees.
double turnError(const Clip& a, const Clip& b, Bone bone) {
    double worst = 0.0;
    for (std::size_t f = 0; f < a.frames.size(); ++f) {
        const auto j = static_cast<std::size_t>(bone);
        const Quat from_start_a = glm::conjugate(worldOf(a, 0)[0].orientation) * worldOf(a, f)[j].orientation;
        const Quat from_start_b = glm::conjugate(worldOf(b, 0)[0].orientation) * worldOf(b, f)[j].orientation;
        const double cosine = std::min(1.0, std::abs(glm::dot(from_start_a, from_start_b)));
        worst = std::max(worst, 2.0 * std::acos(cosine));
    }
    return degreesFromRadians(worst);
}

/// With legs that move as the source's: where feet are planted they do not quite.
Clip retargeted(const Clip& source, motion::RetargetReport* report = nullptr) {
    motion::RetargetOptions options;
    options.plant_feet = false;
    auto clip = motion::retarget(source, avatarMap(), avatar(), avatarMap(), options, report);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    REQUIRE(clip->frames.size() == source.frames.size());
    return *clip;
}

double lowestSole(const Clip& clip) {
    double lowest = 1e9;
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        const auto world = worldOf(clip, f);
        for (const Bone bone : {Bone::leftToes, Bone::rightToes})
            lowest = std::min(lowest, world[static_cast<std::size_t>(bone)].position.y - 0.025);
    }
    return lowest;
}

}  // namespace

TEST_SUITE("motion/retarget") {
    TEST_CASE("The avatar's own motion comes back as it was") {
        const Clip clip = exercise();
        motion::RetargetReport report;
        const Clip back = retargeted(clip, &report);
        CHECK(report.scale == doctest::Approx(1.0));
        CHECK(limbError(clip, back) < 0.01);
        for (const Bone bone : {Bone::chest, Bone::head, Bone::leftFoot, Bone::rightHand})
            CHECK(turnError(clip, back, bone) < 0.1);
        // Elbows and knees are hinges here, so the twist found from their planes is none.
        for (const Bone bone : {Bone::leftUpperArm, Bone::rightUpperLeg, Bone::leftLowerLeg})
            CHECK(turnError(clip, back, bone) < 1.0);
    }

    TEST_CASE("A long clip, worked on in parts at the same time, has the frames of a short one") {
        const Clip once = exercise();
        Clip often = once;
        constexpr std::size_t times = 120;
        for (std::size_t i = 1; i < times; ++i)
            often.frames.insert(often.frames.end(), once.frames.begin(), once.frames.end());
        const Clip expected = retargeted(once);
        const Clip found = retargeted(often);
        std::size_t different = 0;
        for (std::size_t f = 0; f < found.frames.size(); ++f)
            for (std::size_t j = 0; j < found.skeleton.joints.size(); ++j) {
                const Pose& a = found.frames[f].joints[j];
                const Pose& b = expected.frames[f % once.frames.size()].joints[j];
                different += a.position != b.position || a.orientation != b.orientation ? 1 : 0;
            }
        CHECK(different == 0);
    }

    TEST_CASE("A rig that is z up, in centimetres and faces elsewhere plays the same motion upright") {
        const Clip clip = exercise();
        const Quat z_up = about(Vec3(1, 0, 0), 90);
        // Every joint's axes turned alike: a rest pose that is z up too.
        const Clip source = otherRig(
            clip, [&](Bone) { return glm::conjugate(z_up); }, 100.0, about(Vec3(0, 0, 1), 70) * z_up);
        motion::RetargetReport report;
        const Clip back = retargeted(source, &report);
        CHECK(report.scale == doctest::Approx(0.01));
        CHECK(limbError(clip, back) < 0.01);
        CHECK(turnError(clip, back, Bone::head) < 0.1);
        const auto world = worldOf(back, 0);
        CHECK(world[static_cast<std::size_t>(Bone::head)].position.y > 1.4);
        CHECK(world[0].position.x == doctest::Approx(0.0));
        CHECK(world[0].position.z == doctest::Approx(0.0));
        CHECK((world[0].orientation * Vec3(0, 0, 1)).x == doctest::Approx(0.0));
    }

    TEST_CASE("Rest poses with the arms down or in an A are corrected") {
        const Clip clip = exercise();
        for (const double degrees : {45.0, 85.0}) {
            const Clip source = otherRig(
                clip,
                [&](Bone bone) {
                    const auto name = motion::boneName(bone);
                    const bool arm = (bone >= Bone::leftUpperArm && bone <= Bone::leftHand) ||
                                     (bone >= Bone::rightUpperArm && bone <= Bone::rightHand) ||
                                     bone >= Bone::leftThumbMetacarpal;
                    // Axes turned up by so much make a rest that hangs down by as much.
                    if (!arm) return no_rotation;
                    return about(Vec3(0, 0, 1), name.starts_with("left") ? degrees : -degrees);
                },
                1.0, no_rotation);
            const auto rest = motion::worldPose(source.skeleton, motion::restPose(source.skeleton));
            REQUIRE(direction(rest, Bone::leftUpperArm).y ==
                    doctest::Approx(-std::sin(radiansFromDegrees(degrees))));
            const Clip back = retargeted(source);
            CHECK(limbError(clip, back) < 0.01);
            CHECK(turnError(clip, back, Bone::rightHand) < 0.1);
        }
    }

    TEST_CASE("A rig that rests lying on its side, or on its face, moves upright") {
        const Clip clip = exercise();
        for (const Quat& lying :
             {about(Vec3(0, 0, 1), 90), about(Vec3(1, 0, 0), 90), about(Vec3(0, 1, 0), 90)}) {
            const Clip source = otherRig(
                clip, [&](Bone) { return lying; }, 100.0, no_rotation);
            const Clip back = retargeted(source);
            CHECK(limbError(clip, back) < 0.01);
            CHECK(turnError(clip, back, Bone::head) < 0.1);
            CHECK(worldOf(back, 0)[static_cast<std::size_t>(Bone::head)].position.y > 1.4);
        }
    }

    TEST_CASE("A rig whose rest pose is a heap of bones is aligned to a frame of the motion") {
        const Clip clip = exercise();
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
            Random random(seed);
            std::vector<Quat> axes;
            for (std::size_t j = 0; j < avatar().joints.size(); ++j)
                axes.push_back(
                    glm::normalize(Quat(random.normal(), random.normal(), random.normal(), random.normal())));
            const Clip source = otherRig(
                clip, [&](Bone bone) { return axes[static_cast<std::size_t>(bone)]; }, 39.37, no_rotation);
            motion::RetargetReport report;
            const Clip back = retargeted(source, &report);
            CHECK(limbError(clip, back) < 0.01);
            CHECK(turnError(clip, back, Bone::head) < 10.0);  // the frame taken as neutral swings a little
            CHECK(worldOf(back, 0)[static_cast<std::size_t>(Bone::head)].position.y > 1.4);
            REQUIRE_FALSE(report.remarks.empty());
            CHECK(report.remarks[0].find("rest pose") != std::string::npos);
        }
    }

    TEST_CASE("The feet of every rig come to the floor") {
        const Clip clip = exercise();
        for (const double height : {-3.0, 0.0, 0.7}) {
            Clip moved = clip;
            for (auto& frame : moved.frames) frame.joints[0].position.y += height;
            const double lowest = lowestSole(retargeted(moved));
            CHECK(lowest > -0.03);
            CHECK(lowest < 0.03);
        }
    }

    TEST_CASE("An added pose in front of the motion is replaced, and the number of frames stays") {
        Clip clip = exercise();
        clip.frames[0] = motion::restPose(avatar());  // the T pose that CMU conversions carry
        motion::RetargetReport report;
        const Clip back = retargeted(clip, &report);
        CHECK(direction(worldOf(back, 0), Bone::leftUpperArm).y < -0.5);
        REQUIRE(report.remarks.size() == 1);
        CHECK(report.remarks[0].find("frame 0") != std::string::npos);
        // The same pose slowly left is part of the motion.
        for (auto& frame : clip.frames) frame = motion::restPose(avatar());
        CHECK(direction(worldOf(retargeted(clip), 0), Bone::leftUpperArm).x > 0.99);
    }

    TEST_CASE("A source without fingers leaves the avatar's hands relaxed") {
        auto map = avatarMap();
        for (auto b = static_cast<std::size_t>(Bone::leftThumbMetacarpal); b < motion::bone_count; ++b)
            map.joint[b] = -1;
        map[Bone::leftIndexProximal] = avatarMap()[Bone::leftIndexProximal];  // CMU's stand-in for all
        const auto clip = motion::retarget(exercise(), map, avatar(), avatarMap());
        REQUIRE(clip.has_value());
        const auto relaxed = motion::relaxedPose(avatar());
        for (const Bone bone : {Bone::leftIndexProximal, Bone::rightLittleDistal}) {
            const auto j = static_cast<std::size_t>(bone);
            CHECK(std::abs(glm::dot(clip->frames[5].joints[j].orientation, relaxed.joints[j].orientation)) >
                  1.0 - 1e-12);
        }
    }

    TEST_CASE("A source with one bone between hips and neck bends the whole spine evenly") {
        auto map = avatarMap();
        map[Bone::spine] = map[Bone::upperChest];
        map[Bone::chest] = map[Bone::upperChest] = -1;
        const auto clip = motion::retarget(exercise(), map, avatar(), avatarMap());
        REQUIRE(clip.has_value());
        const auto turn = [&](Bone bone) {
            return degreesFromRadians(
                glm::angle(clip->frames[8].joints[static_cast<std::size_t>(bone)].orientation));
        };
        CHECK(turn(Bone::upperChest) > 3.0);
        CHECK(turn(Bone::spine) == doctest::Approx(turn(Bone::chest)).epsilon(1e-6));
        CHECK(turn(Bone::chest) == doctest::Approx(turn(Bone::upperChest)).epsilon(1e-6));
    }

    TEST_CASE("What is no humanoid is rejected with the names of the missing bones") {
        auto map = avatarMap();
        map[Bone::leftHand] = -1;
        map[Bone::rightFoot] = -1;
        const auto clip = motion::retarget(exercise(), map, avatar(), avatarMap());
        REQUIRE_FALSE(clip.has_value());
        CHECK(clip.error().message.find("leftHand, rightFoot") != std::string::npos);

        Clip flat = exercise();  // all joints in one place
        for (auto& joint : flat.skeleton.joints) joint.rest.position = Vec3(0.0);
        for (auto& frame : flat.frames)
            for (auto& pose : frame.joints) pose.position = Vec3(0.0);
        CHECK_FALSE(motion::retarget(flat, avatarMap(), avatar(), avatarMap()).has_value());
    }
}

TEST_SUITE("motion/positions") {
    TEST_CASE("The avatar's joint positions give back its limbs") {
        const Clip clip = exercise();
        std::vector<motion::BonePositions> positions;
        const Quat camera = about(Vec3(0, 1, 0), 180) * about(Vec3(1, 0, 0), 6);  // faces -z, camera tilted
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            const auto world = worldOf(clip, f);
            positions.emplace_back();
            for (std::size_t b = 0; b < motion::bone_count; ++b)
                positions.back().at[b] = camera * (0.9 * world[b].position) + Vec3(0.3, -0.5, 2.0);
        }
        motion::RetargetReport report;
        const auto back =
            motion::clipFromPositions(positions, clip.frame_time_s, avatar(), avatarMap(), &report);
        REQUIRE(back.has_value());
        CHECK(report.scale == doctest::Approx(1.0 / 0.9));
        const Bone arms_and_legs[] = {Bone::leftUpperArm, Bone::rightLowerArm, Bone::leftLowerLeg};
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            const auto expected = worldOf(clip, f);
            const auto found = worldOf(*back, f);
            for (const Bone bone : arms_and_legs)  // levelled by the mean pose, which leans a little
                CHECK(degreesFromRadians(angleBetween(direction(expected, bone), direction(found, bone))) <
                      8.0);
            CHECK(found[static_cast<std::size_t>(Bone::head)].position.y > 1.35);
            const double lowest = std::min(found[static_cast<std::size_t>(Bone::leftToes)].position.y,
                                           found[static_cast<std::size_t>(Bone::rightToes)].position.y);
            CHECK(lowest == doctest::Approx(0.025).epsilon(0.02));
        }
    }

    TEST_CASE("A frame that lacks joints is rejected by number and names") {
        std::vector<motion::BonePositions> positions(2);
        const auto world = motion::worldPose(avatar(), motion::restPose(avatar()));
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            positions[0].at[b] = positions[1].at[b] = world[b].position;
        positions[1][Bone::rightHand].reset();
        positions[1][Bone::neck].reset();
        const auto clip = motion::clipFromPositions(positions, 0.1, avatar(), avatarMap());
        REQUIRE_FALSE(clip.has_value());
        CHECK(clip.error().message.find("frame 1 has no position for rightHand, neck") != std::string::npos);
        CHECK_FALSE(motion::clipFromPositions({}, 0.1, avatar(), avatarMap()).has_value());
    }
}
