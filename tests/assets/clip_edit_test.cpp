// Mirroring and cutting of recordings made by others.
#include <doctest/doctest.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "assets/joints/bvh.hpp"
#include "motion/gestures/segmentation.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "shared_data.hpp"

using namespace deixis;

namespace {

/// Bit for bit, -0 and 0 apart.
bool sameBits(const std::vector<Pose>& a, const std::vector<Pose>& b) {
    static_assert(sizeof(Pose) == 7 * sizeof(double));
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Pose)) == 0;
}

bool sameBits(const motion::Clip& a, const motion::Clip& b) {
    if (a.frameCount() != b.frameCount() || a.skeleton.size() != b.skeleton.size()) return false;
    for (std::size_t j = 0; j < a.skeleton.joints.size(); ++j) {
        const motion::Joint& one = a.skeleton.joints[j];
        const motion::Joint& other = b.skeleton.joints[j];
        if (one.name != other.name || one.parent != other.parent || !sameBits({one.rest}, {other.rest}) ||
            one.end_site.has_value() != other.end_site.has_value() ||
            !sameBits({Pose{one.end_site.value_or(Vec3(0.0))}}, {Pose{other.end_site.value_or(Vec3(0.0))}}))
            return false;
    }
    for (std::size_t f = 0; f < a.frames.size(); ++f)
        if (!sameBits(a.frames[f].joints, b.frames[f].joints)) return false;
    return true;
}

const motion::Gesture* gestureHolding(const motion::Segmentation& made, motion::Side hand, int first,
                                      int last, int slack) {
    for (const motion::Gesture& g : made.gestures)
        if (g.phases.hand == hand && std::abs(g.phases.peak_frame - first) <= slack &&
            std::abs(g.phases.hold_frame - last) <= slack)
            return &g;
    return nullptr;
}

}  // namespace

TEST_SUITE("assets/mirror_recordings") {
    TEST_CASE("recordings of every rig, mirrored, are mirror images; mirrored twice, the same bit for bit") {
        for (const char* name :
             {"bvhpython_test_freebvh.bvh", "bvhtoolbox_walk01/walk01.bvh",
              "cmu_cgspeed_motionbuilder_02_01.bvh", "cmu_iclone_002_01.bvh", "dme_example.bvh",
              "dme_rest.bvh", "fairmotion_sinusoidal.bvh", "makehuman_tpose.bvh",
              "optitrack_arena_louise.bvh.gz", "pybvh_bvh_test1.bvh"}) {
            const auto path = tests::sharedData(std::string("bvh/") + name);
            DEIXIS_SKIP_WITHOUT(path);
            const auto file = assets::readBvh(path);
            REQUIRE_MESSAGE(file.has_value(), (file ? "" : file.error().text()));
            INFO(std::string(name));
            const motion::Clip& clip = file->clip;
            const motion::HumanoidMap map = motion::detectHumanoid(clip.skeleton);
            const motion::Clip image = motion::mirrored(clip, map);
            CHECK(sameBits(motion::mirrored(image, map), clip));

            const auto partners = motion::mirrorPartners(clip.skeleton, map);
            double worst = 0.0;
            double size = 0.0;
            std::vector<Pose> world;
            std::vector<Pose> seen;
            const std::size_t step = clip.frames.size() / 40 + 1;
            for (std::size_t f = 0; f < clip.frames.size(); f += step) {
                motion::worldPose(clip.skeleton, clip.frames[f], world);
                motion::worldPose(image.skeleton, image.frames[f], seen);
                for (std::size_t j = 0; j < world.size(); ++j) {
                    const auto partner = static_cast<std::size_t>(partners[j]);
                    const int there = image.skeleton.find(clip.skeleton.joints[partner].name);
                    REQUIRE(there >= 0);
                    const Vec3& p = world[j].position;
                    const Vec3& q = seen[static_cast<std::size_t>(there)].position;
                    worst = std::max(worst, glm::length(Vec3(-p.x, p.y, p.z) - q));
                    size = std::max(size, glm::length(p));
                }
            }
            CHECK(worst <= 1e-12 * size);
            // The humanoid's left arm shows what its right arm did.
            if (map.has(motion::Bone::rightHand)) {
                const motion::HumanoidMap image_map = motion::detectHumanoid(image.skeleton);
                motion::worldPose(clip.skeleton, clip.frames.back(), world);
                motion::worldPose(image.skeleton, image.frames.back(), seen);
                const Vec3 p = world[static_cast<std::size_t>(map[motion::Bone::rightHand])].position;
                const Vec3 q = seen[static_cast<std::size_t>(image_map[motion::Bone::leftHand])].position;
                CHECK(glm::length(Vec3(-p.x, p.y, p.z) - q) <= 1e-12 * size);
            }
        }
    }
}

TEST_SUITE("assets/segment_recordings") {
    TEST_CASE("a man directing traffic: every straight-arm hold is found, with its hand, and no other") {
        const auto path =
            tests::sharedData("pointing/cmu_directing_traffic/DERIVED_directing_traffic_4_30fps.bvh");
        DEIXIS_SKIP_WITHOUT(path);
        const auto file = assets::readBvh(path);
        REQUIRE(file.has_value());
        const auto map = motion::detectHumanoid(file->clip.skeleton);
        motion::SegmentationOptions options;
        options.by = motion::CutBy::holds;
        const auto made = motion::segment(file->clip, map, options);
        REQUIRE_MESSAGE(made.has_value(), (made ? "" : made.error().text()));
        using motion::Side;
        struct Hold {
            Side hand;
            int first, last;
        };
        const std::vector<Hold> known{
            {Side::left, 50, 64},    {Side::left, 236, 257},  {Side::left, 323, 339},
            {Side::left, 538, 560},  {Side::left, 686, 702},  {Side::left, 704, 726},
            {Side::right, 243, 256}, {Side::right, 323, 340}, {Side::right, 661, 670}};
        for (const Hold& hold : known) {
            CAPTURE(hold.first);
            CHECK(gestureHolding(*made, hold.hand, hold.first, hold.last, 2) != nullptr);
        }

        CHECK(made->gestures.size() == known.size());
    }

    TEST_CASE("people who walk do not point") {
        for (const char* name : {"bvh/bvhtoolbox_walk01/walk01.bvh", "bvh/cmu_iclone_002_01.bvh",
                                 "bvh/cmu_cgspeed_motionbuilder_02_01.bvh"}) {
            const auto path = tests::sharedData(name);
            DEIXIS_SKIP_WITHOUT(path);
            const auto file = assets::readBvh(path);
            REQUIRE(file.has_value());
            INFO(std::string(name));
            motion::SegmentationOptions options;
            options.by = motion::CutBy::holds;
            const auto made =
                motion::segment(file->clip, motion::detectHumanoid(file->clip.skeleton), options);
            REQUIRE_MESSAGE(made.has_value(), (made ? "" : made.error().text()));
            CHECK(made->gestures.empty());
        }
    }
}
