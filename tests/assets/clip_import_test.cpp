#include "assets/joints/clip_import.hpp"

#include <doctest/doctest.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "assets/joints/joint_positions.hpp"
#include "core/files.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"
#include "shared_data.hpp"
#include "text.hpp"

using namespace deixis;
using assets::ImportedClip;
using assets::ImportOptions;
using assets::Origin;
using assets::UpAxis;
using deixis::tests::contains;
using doctest::Approx;

namespace {

ImportedClip imported(const std::string& bytes, const std::string& name, const ImportOptions& options = {}) {
    auto clip = assets::importClipBytes(bytes, name, options);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return std::move(*clip);
}

std::string errorOf(const std::string& bytes, const std::string& name, const ImportOptions& options = {}) {
    const auto clip = assets::importClipBytes(bytes, name, options);
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

motion::Clip standing() {
    motion::Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    clip.frames.assign(3, motion::relaxedPose(clip.skeleton));
    return clip;
}

/// The avatar as BVH, laid so that `up` of its own coordinates becomes the file's axis.
std::string lyingBvh(const Quat& file_from_avatar) {
    motion::Clip clip = standing();
    for (auto& frame : clip.frames) {
        frame.joints[0].position = file_from_avatar * frame.joints[0].position;
        frame.joints[0].orientation = file_from_avatar * frame.joints[0].orientation;
    }
    return assets::writeBvh(clip);
}

Vec3 worldOf(const motion::Clip& clip, std::size_t frame, motion::Bone bone) {
    const auto map = motion::detectHumanoid(clip.skeleton);
    REQUIRE(map.has(bone));
    return motion::worldPose(clip.skeleton, clip.frames[frame])[static_cast<std::size_t>(map[bone])].position;
}

}  // namespace

TEST_SUITE("assets/clip_import") {
    TEST_CASE("Every dialect that others made is read with its unit, up axis and rate") {
        struct Case {
            const char* file;
            int joints, frames;
            double fps, metres;
            UpAxis up;
            Origin up_origin;
        };
        const double cgspeed = 0.0254 / 0.45;
        // Joints, frames and times are those that the files' own lines declare; units and axes as
        // ../shared/data/README.md has them.
        for (const Case& c : {
                 Case{"bvh/bvhpython_test_freebvh.bvh", 0, 69, 30.0, 0.01, UpAxis::y, Origin::detected},
                 Case{"bvh/bvhtoolbox_walk01/walk01.bvh", 0, 101, 24.0, 0.01, UpAxis::y, Origin::detected},
                 Case{"bvh/cmu_cgspeed_motionbuilder_02_01.bvh", 31, 344, 120.0, cgspeed, UpAxis::y,
                      Origin::detected},
                 Case{"bvh/cmu_iclone_002_01.bvh", 101, 171, 60.0, 0.01, UpAxis::y, Origin::detected},
                 Case{"bvh/optitrack_arena_louise.bvh.gz", 0, 2998, 100.0, 0.01, UpAxis::y, Origin::detected},
                 Case{"bvh/makehuman_tpose.bvh", 173, 1, 24.0, 0.1, UpAxis::z, Origin::detected},
                 Case{"bvh/dme_example.bvh", 0, 278, 120.0, cgspeed, UpAxis::y, Origin::detected},
                 Case{"bvh/dme_rest.bvh", 0, 1, 24.0, cgspeed, UpAxis::y, Origin::detected},
                 Case{"bvh/pybvh_bvh_test1.bvh", 0, 75, 30.0, 0.0254, UpAxis::z, Origin::detected},
                 Case{"bvh/fairmotion_sinusoidal.bvh", 0, 120, 60.0, 0.0, UpAxis::y, Origin::assumed},
             }) {
            const auto path = tests::sharedData(c.file);
            DEIXIS_SKIP_WITHOUT(path);
            INFO(std::string(c.file));
            const auto clip = assets::importClip(path);
            REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
            CHECK(clip->format == "BVH");
            if (c.joints > 0) CHECK(clip->clip.skeleton.size() == c.joints);
            CHECK(clip->clip.frameCount() == c.frames);
            CHECK(clip->rate.fps == Approx(c.fps).epsilon(1e-4));
            CHECK(clip->rate.origin == Origin::declared);
            if (c.metres > 0.0) CHECK(clip->unit.metres == Approx(c.metres));
            CHECK(clip->up.axis == c.up);
            CHECK(clip->up.origin == c.up_origin);
            if (c.up_origin != Origin::detected) continue;
            const double rise =
                worldOf(clip->clip, 0, motion::Bone::head).y - worldOf(clip->clip, 0, motion::Bone::hips).y;
            CHECK(rise > 0.4);
            CHECK(rise < 0.9);
        }
    }

    TEST_CASE("A figure that stands along any axis is found and stands upright afterwards") {
        const motion::Clip clip = standing();
        const double head = worldOf(clip, 0, motion::Bone::head).y - worldOf(clip, 0, motion::Bone::hips).y;
        struct Case {
            UpAxis axis;
            Vec3 up;
        };
        for (const Case& c : {Case{UpAxis::x, {1, 0, 0}}, Case{UpAxis::y, {0, 1, 0}},
                              Case{UpAxis::z, {0, 0, 1}}, Case{UpAxis::minus_x, {-1, 0, 0}},
                              Case{UpAxis::minus_y, {0, -1, 0}}, Case{UpAxis::minus_z, {0, 0, -1}}}) {
            const Quat turn = c.axis == UpAxis::y ? no_rotation : rotationBetween(Vec3(0, 1, 0), c.up);
            const ImportedClip found = imported(lyingBvh(turn), "f.bvh");
            CHECK(found.up.axis == c.axis);
            CHECK(found.up.origin == Origin::detected);
            CHECK(worldOf(found.clip, 1, motion::Bone::head).y -
                      worldOf(found.clip, 1, motion::Bone::hips).y ==
                  Approx(head).epsilon(1e-5));
        }
    }

    TEST_CASE("What is given overrides what the file says") {
        ImportOptions options;
        options.up_axis = UpAxis::minus_y;
        options.fps = 24.0;
        options.metres_per_unit = 0.5;
        const ImportedClip found = imported(assets::writeBvh(standing()), "f.bvh", options);
        CHECK(found.up.origin == Origin::given);
        CHECK(found.rate.fps == 24.0);
        CHECK(found.rate.origin == Origin::given);
        CHECK(found.clip.frame_time_s == Approx(1.0 / 24.0));
        CHECK(found.clip.frameCount() == 3);
        CHECK(found.unit.metres == 0.5);
        CHECK(found.unit.origin == Origin::given);
        CHECK(worldOf(found.clip, 0, motion::Bone::head).y < worldOf(found.clip, 0, motion::Bone::hips).y);
        CHECK(contains(assets::describe(found), "at 24 fps (given)"));
    }

    TEST_CASE("The content tells the kind, not the name; packed or not") {
        const std::string bvh = assets::writeBvh(standing());
        CHECK(imported(bvh, "clip.csv").format == "BVH");
        CHECK(imported("\xEF\xBB\xBF\r\n " + bvh, "clip").format == "BVH");
        CHECK(imported(assets::writeJointCsv(standing()), "clip.txt").format == "CSV of joint positions");
        const auto folder = std::filesystem::temp_directory_path() / "deixis_clip_import_test";
        std::filesystem::create_directories(folder);
        const auto packed = folder / "clip.bvh.gz";
        gzFile file = gzopen(packed.c_str(), "wb");
        REQUIRE(file != nullptr);
        gzwrite(file, bvh.data(), static_cast<unsigned>(bvh.size()));
        gzclose(file);
        const auto read = assets::importClip(packed);
        REQUIRE(read.has_value());
        CHECK(read->clip.frameCount() == 3);
        const auto bytes = readFile(packed);
        REQUIRE(writeFile(packed, bytes->substr(0, bytes->size() / 2)).has_value());
        const auto cut = assets::importClip(packed);
        REQUIRE_FALSE(cut.has_value());
        CHECK(contains(cut.error().text(), "damaged gzip"));
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("What is of no known kind, or no clip, is rejected in one sentence") {
        CHECK(contains(errorOf("", "clip"), "clip: is empty"));
        CHECK(contains(errorOf("dear diary", "clip.txt"), "clip.txt: has no known format: expected BVH"));
        CHECK(contains(errorOf("1 2 3\n", "clip.txt"), "no known format"));
        CHECK(contains(errorOf("dear diary", "clip.bvh"), "expected 'HIERARCHY'"));
        CHECK(contains(errorOf("{\"motion\": 3}", "clip"), "found no frames"));
        CHECK(contains(errorOf("{\"motion\": [[1", "clip"), "is not JSON"));
        CHECK(contains(errorOf("{\"hello\": 3}", "clip"), "'output-data' nor 'motion'"));
        ImportOptions options;
        options.fps = 0.0;
        CHECK(contains(errorOf("x", "clip", options), "frame rate"));
        options.fps.reset();
        options.metres_per_unit = -1.0;
        CHECK(contains(errorOf("x", "clip", options), "unit"));
        CHECK(contains(assets::importClip("no_such.bvh").error().text(), "no_such.bvh"));
    }

    TEST_CASE("Absurd BVH files are rejected and take neither time nor memory") {
        const std::string head = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation }\nMOTION\n";
        CHECK(contains(errorOf(head + "Frames: 2000000000\nFrame Time: 0.1\n0\n", "f.bvh"),
                       "after 1 frames, expected 2000000000"));
        CHECK(
            contains(errorOf(head + "Frames: 1e300\nFrame Time: 0.1\n0\n", "f.bvh"), "found '1e300' frames"));
        std::string joints = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
        for (int i = 0; i < 1000000; ++i) joints += "JOINT b{\n";
        CHECK(contains(errorOf(joints, "f.bvh"), "more than 10000 joints"));
        // Joints without channels cost the file nothing, but every frame holds them.
        std::string wide = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xrotation\n";
        for (int i = 0; i < 5000; ++i) wide += "JOINT b" + std::to_string(i) + "{ OFFSET 0 1 0 }\n";
        wide += "}\nMOTION\nFrames: 100000\nFrame Time: 0.1\n";
        for (int i = 0; i < 100000; ++i) wide += "0\n";
        CHECK(contains(errorOf(wide, "f.bvh"), "of which few have channels"));
        // A figure as large as a country.
        const std::string far =
            "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 1 Xposition JOINT b { OFFSET 0 1e200 0 } }\nMOTION\n"
            "Frames: 1\nFrame Time: 0.1\n0\n";
        CHECK(contains(errorOf(far, "f.bvh"), "more than 100 km"));
    }
}
