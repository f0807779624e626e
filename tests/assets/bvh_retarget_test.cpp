// Real recordings by other tools, played on the avatar.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"
#include "shared_data.hpp"

using namespace deixis;
using motion::Bone;
using motion::Clip;
using motion::Side;

namespace {

const char* const humanoid_files[] = {"bvh/bvhpython_test_freebvh.bvh",
                                      "bvh/bvhtoolbox_walk01/walk01.bvh",
                                      "bvh/cmu_cgspeed_motionbuilder_02_01.bvh",
                                      "bvh/cmu_iclone_002_01.bvh",
                                      "bvh/dme_example.bvh",
                                      "bvh/dme_rest.bvh",
                                      "bvh/makehuman_tpose.bvh",
                                      "bvh/optitrack_arena_louise.bvh.gz",
                                      "bvh/pybvh_bvh_test1.bvh"};

const char* const traffic_file = "pointing/cmu_directing_traffic/DERIVED_directing_traffic_4_30fps.bvh";

Clip onAvatar(const Clip& source) {
    const auto& avatar = motion::referenceHumanoid();
    const auto clip = motion::retarget(source, motion::detectHumanoid(source.skeleton), avatar,
                                       motion::mapByVrmNames(avatar));
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    REQUIRE(clip->frames.size() == source.frames.size());
    return *clip;
}

Clip load(const std::filesystem::path& path) {
    const auto file = assets::readBvh(path);
    REQUIRE_MESSAGE(file.has_value(), (file ? "" : file.error().text()));
    return file->clip;
}

/// Joint positions of a frame, by bone.
class Body {
  public:
    Body(const Clip& clip, const motion::HumanoidMap& map, std::size_t frame)
        : map_(map), world_(motion::worldPose(clip.skeleton, clip.frames[frame])) {}
    explicit Body(const Clip& clip, std::size_t frame)
        : Body(clip, motion::mapByVrmNames(motion::referenceHumanoid()), frame) {}

    [[nodiscard]] const Pose& pose(Bone bone) const { return world_[static_cast<std::size_t>(map_[bone])]; }
    [[nodiscard]] Vec3 at(Bone bone) const { return pose(bone).position; }
    [[nodiscard]] double elbowDegrees(Side side) const {
        const auto arm = motion::armBones(side);
        return degreesFromRadians(
            angleBetween(at(arm.upper_arm) - at(arm.lower_arm), at(arm.hand) - at(arm.lower_arm)));
    }
    [[nodiscard]] double lowestFoot() const {
        return std::min(
            {at(Bone::leftFoot).y, at(Bone::rightFoot).y, at(Bone::leftToes).y, at(Bone::rightToes).y});
    }

  private:
    motion::HumanoidMap map_;
    std::vector<Pose> world_;
};

}  // namespace

TEST_SUITE("assets/bvh_retarget") {
    TEST_CASE("Every recording of a person plays upright, the right way round, with the feet on the floor") {
        for (const char* name : humanoid_files) {
            const auto path = tests::sharedData(name);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(std::string(name));
            const Clip clip = onAvatar(load(path));
            const Body first(clip, 0);
            CHECK(first.at(Bone::hips).x == doctest::Approx(0.0));
            CHECK(first.at(Bone::hips).z == doctest::Approx(0.0));
            CHECK(first.at(Bone::leftUpperLeg).x > 0.05);  // its left is +x: it faces +z
            CHECK(first.at(Bone::leftUpperArm).x > first.at(Bone::rightUpperArm).x);
            CHECK(first.at(Bone::head).y > 1.3);
            CHECK((first.pose(Bone::head).orientation * Vec3(0, 0, 1)).z > 0.7);
            double lowest = 1e9;
            double min_rise = 1e9;
            int upright = 0;
            int knees_forward = 0;
            int knees_bent = 0;
            for (std::size_t f = 0; f < clip.frames.size(); ++f) {
                const Body body(clip, f);
                lowest = std::min(lowest, body.lowestFoot());
                const double rise = body.at(Bone::head).y - body.at(Bone::hips).y;
                min_rise = std::min(min_rise, rise);
                upright += rise > 0.4 ? 1 : 0;
                for (const bool left : {true, false}) {
                    const Bone thigh = left ? Bone::leftUpperLeg : Bone::rightUpperLeg;
                    const Bone shin = left ? Bone::leftLowerLeg : Bone::rightLowerLeg;
                    const Bone foot = left ? Bone::leftFoot : Bone::rightFoot;
                    const Vec3 upper = body.at(shin) - body.at(thigh);
                    const Vec3 lower = body.at(foot) - body.at(shin);
                    if (angleBetween(upper, lower) < 0.5) continue;
                    ++knees_bent;
                    const Vec3 bend = glm::normalize(upper) - glm::normalize(lower);
                    const bool forward = glm::dot(bend, body.pose(thigh).orientation * Vec3(0, 0, 1)) > 0.0;
                    knees_forward += forward ? 1 : 0;
                }
            }
            CHECK(lowest > -0.03);
            CHECK(lowest < 0.06);
            CHECK(knees_forward >= knees_bent * 0.99);
            if (std::string(name).find("optitrack") == std::string::npos)
                CHECK(min_rise > 0.4);
            else
                CHECK(upright > 500);  // later she rides a bicycle, bent over
        }
    }

    TEST_CASE("Each recording's naming scheme is recognised") {
        const std::pair<const char*, const char*> schemes[] = {
            {"bvh/bvhpython_test_freebvh.bvh", "Mixamo"},
            {"bvh/bvhtoolbox_walk01/walk01.bvh", "Mixamo"},
            {"bvh/cmu_cgspeed_motionbuilder_02_01.bvh", "CMU/cgspeed"},
            {"bvh/cmu_iclone_002_01.bvh", "iClone"},
            {"bvh/dme_example.bvh", "CMU/cgspeed"},
            {"bvh/makehuman_tpose.bvh", "MakeHuman"},
            {"bvh/optitrack_arena_louise.bvh.gz", "OptiTrack"},
            {"bvh/pybvh_bvh_test1.bvh", "Mixamo"}};
        for (const auto& row : schemes) {
            const std::string name(row.first);
            const auto& scheme = row.second;
            const auto path = tests::sharedData(name);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(name);
            const auto mapping = motion::mapHumanoid(load(path).skeleton);
            CHECK(mapping.scheme == scheme);
            CHECK(mapping.remarks.empty());
            for (const Bone bone : motion::requiredBones()) CHECK(mapping.map.has(bone));
        }
    }

    TEST_CASE("Walkers' feet neither slide nor sink on the avatar") {
        for (const char* name :
             {"bvh/bvhtoolbox_walk01/walk01.bvh", "bvh/cmu_cgspeed_motionbuilder_02_01.bvh",
              "bvh/cmu_iclone_002_01.bvh", "bvh/dme_example.bvh", "bvh/optitrack_arena_louise.bvh.gz"}) {
            const auto path = tests::sharedData(name);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(std::string(name));
            const auto& avatar = motion::referenceHumanoid();
            const Clip source = load(path);
            const auto map = motion::detectHumanoid(source.skeleton);
            motion::RetargetReport report;
            const auto clip =
                motion::retarget(source, map, avatar, motion::mapByVrmNames(avatar), {}, &report);
            REQUIRE(clip.has_value());
            motion::RetargetOptions free;
            free.plant_feet = false;
            const auto before = motion::retarget(source, map, avatar, motion::mapByVrmNames(avatar), free);
            REQUIRE(before.has_value());
            MESSAGE(std::string(name), ": standing ", report.feet.standing_share, ", slides ",
                    1000.0 * report.feet.before_m_s, " -> ", 1000.0 * report.feet.after_m_s, " mm/s, lowest ",
                    1000.0 * report.feet.lowest_before_m, " -> ", 1000.0 * report.feet.lowest_after_m, " mm");
            CHECK(report.feet.standing_share > 0.2);
            CHECK(report.feet.after_m_s < 0.02);
            CHECK(report.feet.after_m_s < report.feet.before_m_s);
            CHECK(report.feet.lowest_after_m > -0.005);
            // Measured again: the ball of a foot that touches the floor, and that rested as recorded, does
            // not move on the avatar.
            const auto rest = motion::worldPose(avatar, motion::restPose(avatar));
            const auto fps = clip->framesPerSecond();
            for (const bool left : {true, false}) {
                const Bone foot = left ? Bone::leftFoot : Bone::rightFoot;
                const Bone toes = left ? Bone::leftToes : Bone::rightToes;
                Vec3 ball = rest[static_cast<std::size_t>(toes)].position;
                ball.y = 0.0;
                ball -= rest[static_cast<std::size_t>(foot)].position;
                const auto ballAt = [&](const Clip& c, std::size_t f) {
                    return transformPoint(Body(c, f).pose(foot), ball);
                };
                double worst = 0.0;
                int touches = 0;
                for (std::size_t f = 1; f < clip->frames.size(); ++f) {
                    const double recorded_m_s =
                        glm::length(ballAt(*before, f) - ballAt(*before, f - 1)) * fps;
                    const Vec3 now = ballAt(*clip, f);
                    const Vec3 last = ballAt(*clip, f - 1);
                    if (recorded_m_s > 0.15 || std::max(now.y, last.y) > 0.003) continue;
                    ++touches;
                    worst = std::max(worst, std::hypot(now.x - last.x, now.z - last.z) * fps);
                    CHECK(now.y > -0.005);
                }
                MESSAGE(touches, " frames on the floor, fastest ", 1000.0 * worst, " mm/s");
                CHECK(touches > 0);
                CHECK(worst < 0.06);
            }
        }
    }

    TEST_CASE("Walkers walk the way they face") {
        for (const char* name :
             {"bvh/bvhtoolbox_walk01/walk01.bvh", "bvh/cmu_cgspeed_motionbuilder_02_01.bvh",
              "bvh/cmu_iclone_002_01.bvh", "bvh/dme_example.bvh"}) {
            const auto path = tests::sharedData(name);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(std::string(name));
            const Clip clip = onAvatar(load(path));
            const Body last(clip, clip.frames.size() - 1);
            CHECK(last.at(Bone::hips).z > 2.0);
            CHECK(std::abs(last.at(Bone::hips).x) < 0.25 * last.at(Bone::hips).z);
        }
    }

    TEST_CASE("One trial read from two tools' conversions is one walk") {
        // CMU subject 2 trial 1, by cgspeed at 120 fps (frame 0 added) and by iClone at 60 fps.
        const auto path = tests::sharedData("bvh/cmu_cgspeed_motionbuilder_02_01.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const Clip a = onAvatar(load(path));
        const Clip b = onAvatar(load(tests::sharedData("bvh/cmu_iclone_002_01.bvh")));
        double sum_deg = 0.0;
        int count = 0;
        for (std::size_t f = 0; f + 1 < b.frames.size() && 2 * f + 1 < a.frames.size(); f += 5) {
            const Body body_a(a, 2 * f + 1);
            const Body body_b(b, f);
            const std::pair<Bone, Bone> limbs[] = {{Bone::leftUpperArm, Bone::leftLowerArm},
                                                   {Bone::rightLowerArm, Bone::rightHand},
                                                   {Bone::leftUpperLeg, Bone::leftLowerLeg},
                                                   {Bone::rightLowerLeg, Bone::rightFoot}};
            for (const auto& [from, to] : limbs) {
                sum_deg += degreesFromRadians(
                    angleBetween(body_a.at(to) - body_a.at(from), body_b.at(to) - body_b.at(from)));
                ++count;
            }
        }
        REQUIRE(count > 100);
        CHECK(sum_deg / count < 8.0);
    }

    TEST_CASE("What is no person is rejected, naming the bones that lack") {
        const auto path = tests::sharedData("bvh/fairmotion_sinusoidal.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const Clip source = load(path);
        CHECK(source.frameCount() == 120);
        CHECK_FALSE(source.skeleton.joints.back().end_site.has_value());
        const auto& avatar = motion::referenceHumanoid();
        const auto clip = motion::retarget(source, motion::detectHumanoid(source.skeleton), avatar,
                                           motion::mapByVrmNames(avatar));
        REQUIRE_FALSE(clip.has_value());
        CHECK(clip.error().text().find("hips, head, leftUpperArm") != std::string::npos);
    }

    TEST_CASE("Directing traffic: arms that are held out stay as straight and as high on the avatar") {
        const auto path = tests::sharedData(traffic_file);
        DEIXIS_SKIP_WITHOUT(path);
        const Clip source = load(path);
        const auto source_map = motion::detectHumanoid(source.skeleton);
        const Clip clip = onAvatar(source);
        struct Hold {
            Side side;
            std::size_t first, last;
        };
        // As the data's README lists them. The source's own elbows are between 131 and 168 degrees in them.
        for (const Hold& hold :
             {Hold{Side::left, 50, 64}, Hold{Side::left, 236, 257}, Hold{Side::left, 323, 339},
              Hold{Side::left, 538, 560}, Hold{Side::left, 686, 702}, Hold{Side::left, 704, 726},
              Hold{Side::right, 243, 256}, Hold{Side::right, 323, 340}, Hold{Side::right, 661, 670}}) {
            double straightest = 0.0;
            for (std::size_t f = hold.first; f <= hold.last; ++f) {
                INFO("frame " << f);
                const Body before(source, source_map, f);
                const Body after(clip, f);
                const auto arm = motion::armBones(hold.side);
                CHECK(after.elbowDegrees(hold.side) ==
                      doctest::Approx(before.elbowDegrees(hold.side)).epsilon(0.005));
                CHECK(after.at(arm.hand).y > after.at(arm.upper_arm).y - 0.2);
                const auto rise = [&](const Body& body) {
                    const Vec3 reach = body.at(arm.hand) - body.at(arm.upper_arm);
                    return degreesFromRadians(std::asin(reach.y / glm::length(reach)));
                };
                CHECK(std::abs(rise(after) - rise(before)) < 4.0);
                straightest = std::max(straightest, after.elbowDegrees(hold.side));
            }
            CHECK(straightest > 137.0);
        }
    }

    TEST_CASE("A retargeted clip survives being written and read") {
        const auto path = tests::sharedData(traffic_file);
        DEIXIS_SKIP_WITHOUT(path);
        const Clip clip = onAvatar(load(path));
        const auto again = assets::parseBvh(assets::writeBvh(clip), "again.bvh");
        REQUIRE(again.has_value());
        CHECK(again->unit.metres == 1.0);
        const auto map = motion::detectHumanoid(again->clip.skeleton);
        double worst = 0.0;
        for (std::size_t f = 0; f < clip.frames.size(); f += 13) {
            const Body before(clip, f);
            const Body after(again->clip, map, f);
            for (const Bone bone : {Bone::head, Bone::leftIndexDistal, Bone::rightHand, Bone::leftToes})
                worst = std::max(worst, glm::length(before.at(bone) - after.at(bone)));
        }
        CHECK(worst < 1e-5);
    }
}
