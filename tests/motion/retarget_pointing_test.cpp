// Pointing gestures on an avatar whose arms are not those of the source.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "avatar.hpp"
#include "motion/humanoid/hand_shapes.hpp"
#include "motion/retarget/retarget.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using motion::Bone;
using motion::Clip;
using motion::Keep;
using motion::Side;
using tests::avatar;
using tests::avatarMap;

namespace {

struct Recorded {
    Clip clip;
    motion::PointingGesture gesture;
};

/// A gesture of a built-in system at a target of its own.
Recorded recorded(std::uint64_t seed) {
    static const auto generator =
        motion::makeGenerator("direct", avatar(), motion::DemonstrationParameters{});
    REQUIRE(generator.has_value());
    const Vec3 target = tests::drawTargets(1, seed).front();
    auto made = (*generator)->generate({"T", target, seed});
    return {std::move(made.clip),
            {{made.hand, made.onset_frame, made.peak_frame, made.hold_frame, made.end_frame}, target}};
}

/// The same joint angles with arms (upper arm, forearm, hand) of another length.
Clip withArms(Clip clip, double factor) {
    const auto isArm = [](std::size_t joint) {
        const auto bone = static_cast<Bone>(joint);
        return bone == Bone::leftLowerArm || bone == Bone::leftHand || bone == Bone::rightLowerArm ||
               bone == Bone::rightHand || bone >= Bone::leftThumbMetacarpal;
    };
    for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j) {
        if (!isArm(j)) continue;
        auto& joint = clip.skeleton.joints[j];
        joint.rest.position *= factor;
        if (joint.end_site) *joint.end_site *= factor;
        for (auto& frame : clip.frames) frame.joints[j].position *= factor;
    }
    return clip;
}

motion::RetargetOptions keeping(Keep keep, const motion::PointingGesture& gesture) {
    motion::RetargetOptions options;
    options.keep = keep;
    options.gesture = gesture;
    return options;
}

Clip onAvatar(const Clip& source, const motion::RetargetOptions& options,
              motion::RetargetReport* report = nullptr) {
    auto clip = motion::retarget(source, avatarMap(), avatar(), avatarMap(), options, report);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return *clip;
}

Ray rayAt(const Clip& clip, const motion::PointingGesture& gesture, int frame) {
    return motion::pointingRay(clip.skeleton, avatarMap(), tests::worldAt(clip, frame), gesture.hand,
                               motion::PointingRay::eye_fingertip);
}

double errorAt(const Clip& clip, const motion::PointingGesture& gesture, int frame) {
    return degreesFromRadians(motion::angularError(rayAt(clip, gesture, frame), *gesture.target));
}

double turnBetween(const Quat& a, const Quat& b) {
    return degreesFromRadians(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

}  // namespace

TEST_SUITE("motion/retarget_pointing") {
    TEST_CASE("With the pointing ray kept, the avatar misses the target by as much as the source") {
        for (std::uint64_t seed = 1; seed <= 12; ++seed)
            for (const double factor : {0.8, 0.9, 1.1, 1.25}) {
                CAPTURE(seed);
                CAPTURE(factor);
                const Recorded made = recorded(seed);
                const Clip source = withArms(made.clip, factor);
                motion::RetargetReport report;
                const Clip clip = onAvatar(source, keeping(Keep::pointing_ray, made.gesture), &report);
                double source_worst = 0.0;
                double worst = 0.0;
                for (int f = made.gesture.peak_frame; f <= made.gesture.hold_frame; ++f) {
                    source_worst = std::max(source_worst, errorAt(source, made.gesture, f));
                    worst = std::max(
                        worst, std::abs(errorAt(clip, made.gesture, f) - errorAt(source, made.gesture, f)));
                }
                CHECK(worst < 0.5);
                REQUIRE(report.source_error.has_value());
                REQUIRE(report.avatar_error.has_value());
                CHECK(report.source_error->max_deg == doctest::Approx(source_worst).epsilon(0.001));
                CHECK(std::abs(report.avatar_error->median_deg - report.source_error->median_deg) < 0.5);
            }
    }

    TEST_CASE("With joint angles kept, arms point as in the source and the ray goes astray") {
        double astray = 0.0;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const Recorded made = recorded(seed);
            const Clip source = withArms(made.clip, 1.25);
            const Clip clip = onAvatar(source, keeping(Keep::joint_angles, made.gesture));
            for (int f = 0; f < clip.frameCount(); f += 7)
                for (const Bone bone : {Bone::leftUpperArm, Bone::leftLowerArm, Bone::rightUpperArm,
                                        Bone::rightLowerArm, Bone::rightIndexProximal}) {
                    const auto next = static_cast<Bone>(static_cast<int>(bone) + 1);
                    const auto before = tests::worldAt(source, f);
                    const auto after = tests::worldAt(clip, f);
                    CHECK(degreesFromRadians(
                              angleBetween(tests::joint(before, next) - tests::joint(before, bone),
                                           tests::joint(after, next) - tests::joint(after, bone))) < 0.01);
                }
            const int middle = (made.gesture.peak_frame + made.gesture.hold_frame) / 2;
            astray = std::max(astray, std::abs(errorAt(clip, made.gesture, middle) -
                                               errorAt(source, made.gesture, middle)));
        }
        CHECK(astray > 2.0);  // what keeping the ray mends
    }

    TEST_CASE("Without a target the ray keeps its direction") {
        Recorded made = recorded(5);
        made.gesture.target.reset();
        const Clip source = withArms(made.clip, 0.8);
        motion::RetargetReport report;
        const Clip clip = onAvatar(source, keeping(Keep::pointing_ray, made.gesture), &report);
        CHECK_FALSE(report.source_error.has_value());
        // The clip is turned to face +z, so that the direction is told from the head's.
        for (int f = made.gesture.peak_frame; f <= made.gesture.hold_frame; ++f) {
            const auto seenFromHips = [&](const Clip& c) {
                return glm::conjugate(tests::worldAt(c, f)[0].orientation) *
                       rayAt(c, made.gesture, f).direction;
            };
            CHECK(degreesFromRadians(angleBetween(seenFromHips(source), seenFromHips(clip))) < 0.05);
        }
    }

    TEST_CASE("The correction comes and goes smoothly, and leaves the rest of the clip alone") {
        for (std::uint64_t seed = 20; seed < 26; ++seed) {
            const Recorded made = recorded(seed);
            const Clip source = withArms(made.clip, 1.25);
            const Clip plain = onAvatar(source, keeping(Keep::joint_angles, made.gesture));
            const Clip clip = onAvatar(source, keeping(Keep::pointing_ray, made.gesture));
            const auto arm = motion::armBones(made.gesture.hand);
            const auto upper = static_cast<std::size_t>(arm.upper_arm);
            double largest_step = 0.0;
            Quat last = no_rotation;
            for (int f = 0; f < clip.frameCount(); ++f) {
                const auto& before = plain.frames[static_cast<std::size_t>(f)].joints;
                const auto& after = clip.frames[static_cast<std::size_t>(f)].joints;
                const Quat change = after[upper].orientation * glm::conjugate(before[upper].orientation);
                if (f <= made.gesture.onset_frame || f >= made.gesture.end_frame)
                    CHECK(turnBetween(change, no_rotation) < 1e-5);
                largest_step = std::max(largest_step, turnBetween(change, last));
                last = change;
                const auto other = static_cast<std::size_t>(motion::mirroredBone(arm.upper_arm));
                CHECK(turnBetween(before[other].orientation, after[other].orientation) < 1e-5);
                // The elbow bends as before, unless the ray is out of the fingertip's reach.
                CHECK(turnBetween(before[upper + 1].orientation, after[upper + 1].orientation) < 30.0);
            }
            CHECK(largest_step < 3.0);
        }
    }

    TEST_CASE("A clip that is on the avatar stays as it is, ray kept or not") {
        const Recorded made = recorded(3);
        for (const Keep keep : {Keep::joint_angles, Keep::pointing_ray}) {
            auto options = keeping(keep, made.gesture);
            options.plant_feet = false;
            const Clip clip = onAvatar(made.clip, options);
            Vec3 shift(0.0);  // the soles are set on the floor
            double worst = 0.0;
            for (int f = 0; f < clip.frameCount(); ++f) {
                const auto before = tests::worldAt(made.clip, f);
                const auto after = tests::worldAt(clip, f);
                if (f == 0) shift = after[0].position - before[0].position;
                for (std::size_t j = 0; j < before.size(); ++j)
                    worst = std::max(worst, glm::length(after[j].position - before[j].position - shift));
            }
            // Where the body is set on the floor and the target stays, the arm follows by less than 1 mm.
            CHECK(worst < (keep == Keep::joint_angles ? 1e-6 : 1e-3));
            CHECK(std::abs(shift.x) < 1e-9);
            CHECK(std::abs(shift.z) < 1e-9);
            CHECK(std::abs(shift.y) < 0.005);
        }
    }

    TEST_CASE("A clip with a target stays where it stands; without one it starts at the origin, facing +z") {
        Recorded made = recorded(8);
        const Quat turn = yawRotation(0.2);
        for (auto& frame : made.clip.frames) {
            frame.joints[0].position = turn * frame.joints[0].position + Vec3(0.1, 0.0, -0.05);
            frame.joints[0].orientation = turn * frame.joints[0].orientation;
        }
        const auto start = [&](const motion::RetargetOptions& options) {
            return tests::worldAt(onAvatar(withArms(made.clip, 1.1), options), 0)[0];
        };
        const Pose stays = start(keeping(Keep::joint_angles, made.gesture));
        CHECK(stays.position.x == doctest::Approx(made.clip.frames[0].joints[0].position.x));
        CHECK((stays.orientation * Vec3(0, 0, 1)).x > 0.15);
        const Pose placed = start({});
        CHECK(std::abs(placed.position.x) < 1e-9);
        CHECK(std::abs((placed.orientation * Vec3(0, 0, 1)).x) < 1e-9);
    }

    TEST_CASE("Where the source has no fingers, the hand closes while it points if that is asked for") {
        const Recorded made = recorded(4);
        auto map = avatarMap();
        for (auto b = static_cast<std::size_t>(Bone::leftThumbMetacarpal); b < motion::bone_count; ++b)
            map.joint[b] = -1;
        for (const bool close : {false, true}) {
            motion::RetargetOptions options;
            options.gesture = made.gesture;
            options.close_hand = close;
            const auto clip = motion::retarget(made.clip, map, avatar(), avatarMap(), options);
            REQUIRE(clip.has_value());
            const auto relaxed = motion::relaxedPose(avatar());
            auto pointing = relaxed;
            motion::applyPointingHand(pointing, made.gesture.hand, 1.0);
            for (std::size_t b = static_cast<std::size_t>(Bone::leftThumbMetacarpal); b < motion::bone_count;
                 ++b) {
                const auto at = [&](int frame) {
                    return clip->frames[static_cast<std::size_t>(frame)].joints[b].orientation;
                };
                CHECK(turnBetween(at(0), relaxed.joints[b].orientation) < 1e-4);
                CHECK(turnBetween(at(made.gesture.hold_frame),
                                  (close ? pointing : relaxed).joints[b].orientation) < 1e-4);
            }
        }
    }

    TEST_CASE("A source without eyes and fingers points as one with them, its hand being straight") {
        // Its sight line is made up from the avatar's head and its own hand.
        const Recorded made = recorded(9);
        auto map = avatarMap();
        map[Bone::leftEye] = map[Bone::rightEye] = -1;
        motion::RetargetReport report;
        const auto clip = motion::retarget(made.clip, map, avatar(), avatarMap(),
                                           keeping(Keep::pointing_ray, made.gesture), &report);
        REQUIRE(clip.has_value());
        const double own = motion::pointingError(made.clip, avatarMap(), made.gesture)->median_deg;
        CHECK(report.source_error->median_deg == doctest::Approx(own).epsilon(0.02));
        CHECK(std::abs(report.avatar_error->median_deg - report.source_error->median_deg) < 0.5);
    }

    TEST_CASE("A target within the arm's reach is pointed at as the source does, short of it or beyond") {
        static const auto generator =
            motion::makeGenerator("direct", avatar(), motion::DemonstrationParameters{});
        REQUIRE(generator.has_value());
        int beyond = 0;
        for (const Vec3& target : {Vec3(-0.3, 1.3, 0.6), Vec3(-0.6, 0.9, 0.35), Vec3(0.5, 1.7, 0.5),
                                   Vec3(-0.5, 1.4, 0.8), Vec3(0.1, 1.2, 0.9), Vec3(-0.2, 1.9, 0.4)})
            for (const double factor : {0.6, 0.8, 1.25, 1.6}) {
                CAPTURE(target);
                CAPTURE(factor);
                auto made = (*generator)->generate({"T", target, 3});
                const motion::PointingGesture gesture{made, target};
                const Clip source = withArms(std::move(made.clip), factor);
                motion::RetargetReport report;
                const Clip clip = onAvatar(source, keeping(Keep::pointing_ray, gesture), &report);
                const bool passes = report.source_error->median_deg > 90.0;
                beyond += passes ? 1 : 0;
                // Shorter arms may not come past a target.
                if (!passes || factor < 1.0)
                    CHECK(std::abs(report.avatar_error->median_deg - report.source_error->median_deg) < 0.5);
            }
        CHECK(beyond > 0);
    }

    TEST_CASE("How a source misses its target does not hang on the avatar's legs and soles") {
        // Half as long legs on soles of 0.15 m: at the source's size that is 0.25 m of floor.
        motion::Skeleton other = avatar();
        const auto at = [&](Bone bone) -> Vec3& {
            return other.joints[static_cast<std::size_t>(bone)].rest.position;
        };
        for (const Bone bone : {Bone::leftLowerLeg, Bone::leftFoot, Bone::rightLowerLeg, Bone::rightFoot})
            at(bone) *= 0.45;
        at(Bone::leftToes) = Vec3(0.0, 0.0, 0.13);
        at(Bone::rightToes) = Vec3(0.0, 0.0, 0.13);
        const auto world = motion::worldPose(other, motion::restPose(other));
        at(Bone::hips).y += 0.15 - world[static_cast<std::size_t>(Bone::leftFoot)].position.y;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const Recorded made = recorded(seed);
            motion::RetargetReport report;
            const auto clip = motion::retarget(made.clip, avatarMap(), other, avatarMap(),
                                               keeping(Keep::pointing_ray, made.gesture), &report);
            REQUIRE(clip.has_value());
            CHECK(report.source_error->median_deg ==
                  doctest::Approx(motion::pointingError(made.clip, avatarMap(), made.gesture)->median_deg)
                      .epsilon(1e-6));
            CHECK(std::abs(report.avatar_error->median_deg - report.source_error->median_deg) < 0.1);
            // The avatar stands on the floor and the target where it was given.
            CHECK(report.avatar_error->median_deg ==
                  doctest::Approx(motion::pointingError(*clip, avatarMap(), made.gesture)->median_deg));
        }
    }

    TEST_CASE("A gesture that does not fit the clip is rejected") {
        const Recorded made = recorded(2);
        auto gesture = made.gesture;
        gesture.end_frame = made.clip.frameCount();
        const auto late = motion::retarget(made.clip, avatarMap(), avatar(), avatarMap(),
                                           keeping(Keep::joint_angles, gesture));
        REQUIRE_FALSE(late.has_value());
        CHECK(late.error().message.find("in a clip of") != std::string::npos);
        gesture = made.gesture;
        gesture.peak_frame = gesture.onset_frame;
        CHECK_FALSE(motion::retarget(made.clip, avatarMap(), avatar(), avatarMap(),
                                     keeping(Keep::joint_angles, gesture))
                        .has_value());
        CHECK_FALSE(motion::pointingError(made.clip, avatarMap(), gesture).has_value());
    }
}
