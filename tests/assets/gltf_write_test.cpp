#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "assets/gltf/gltf_clip.hpp"
#include "assets/joints/bvh.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "shared_data.hpp"

using namespace deixis;
using doctest::Approx;
using motion::Clip;

namespace {

/// The reference humanoid, every joint turning and its hips moving, from a seed.
Clip moving(int frames, double frame_time_s, std::uint64_t seed = 3) {
    Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    clip.frame_time_s = frame_time_s;
    Random random(seed);
    motion::LocalPose pose = motion::restPose(clip.skeleton);
    for (int k = 0; k < frames; ++k) {
        for (Pose& joint : pose.joints) {
            const Quat step(1.0, random.normal(0, 0.05), random.normal(0, 0.05), random.normal(0, 0.05));
            joint.orientation = glm::normalize(joint.orientation * step);
        }
        pose.joints[0].position += Vec3(random.normal(0, 0.01), 0.0, random.normal(0, 0.01));
        clip.frames.push_back(pose);
    }
    return clip;
}

assets::GltfClipFile readBack(const std::string& bytes) {
    auto file = assets::parseGltfClip(bytes, "f.glb");
    if (!file) FAIL(file.error().text());
    return std::move(*file);
}

/// Largest distance of any joint or tip that both have, by name, in any frame.
double worstDistance(const Clip& a, const Clip& b) {
    REQUIRE(a.frameCount() == b.frameCount());
    double worst = 0.0;
    std::vector<Pose> world_a, world_b;
    std::vector<int> other;
    for (const auto& joint : a.skeleton.joints) {
        other.push_back(b.skeleton.find(joint.name));
        REQUIRE(other.back() >= 0);
    }
    for (std::size_t k = 0; k < a.frames.size(); ++k) {
        motion::worldPose(a.skeleton, a.frames[k], world_a);
        motion::worldPose(b.skeleton, b.frames[k], world_b);
        for (int j = 0; j < a.skeleton.size(); ++j)
            worst = std::max(worst, glm::length(motion::tipPosition(a.skeleton, world_a, j) -
                                                motion::tipPosition(b.skeleton, world_b,
                                                                    other[static_cast<std::size_t>(j)])));
    }
    return worst;
}

}  // namespace

TEST_SUITE("assets/gltf_write") {
    TEST_CASE("A clip written and read again is the same within a micrometre") {
        for (const double frame_time : {1.0 / 30.0, 1.0 / 120.0, 0.0083333, 1.0 / 15.0, 0.04}) {
            const Clip clip = moving(80, frame_time);
            const auto file = readBack(assets::writeGlb(clip));
            CAPTURE(frame_time);
            CHECK(file.clip.frame_time_s == Approx(frame_time).epsilon(1e-7));
            REQUIRE(file.clip.skeleton.size() == clip.skeleton.size());
            for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j) {
                const auto& found = file.clip.skeleton.joints[j];
                const auto& expected = clip.skeleton.joints[j];
                CHECK(found.name == expected.name);
                CHECK(found.parent == expected.parent);
                CHECK(found.rest.position == expected.rest.position);
                CHECK(found.end_site == expected.end_site);
            }
            CHECK(worstDistance(clip, file.clip) < 1e-6);
            CHECK(file.remarks.empty());
        }
    }

    TEST_CASE("Odd names, rest rotations, several roots and a single frame survive") {
        Clip clip;
        clip.skeleton.joints = {
            {"a \"quoted\" \\ name\n", -1, {{1, 2, 3}, glm::normalize(Quat(1, 2, 3, 4))}, {}},
            {"b", 0, {{0, 1, 0}, {0, 0, 1, 0}}, Vec3(0, 0, 0.5)},
            {"hände", -1, {}, {}}};
        clip.frames = {motion::restPose(clip.skeleton)};
        clip.frames[0].joints[2].position = {4, 5, 6};
        const auto file = readBack(assets::writeGlb(clip));
        CHECK(file.clip.frameCount() == 1);
        CHECK(worstDistance(clip, file.clip) < 1e-6);
    }

    TEST_CASE("The same clip gives the same bytes") {
        Clip clip;
        clip.skeleton.joints = {{"hips", -1, {{0, 1, 0}, no_rotation}, {}},
                                {"head", 0, {{0, 0.5, 0}, no_rotation}, Vec3(0, 0.25, 0)}};
        clip.frame_time_s = 1.0 / 30.0;
        for (int k = 0; k < 3; ++k) {
            clip.frames.push_back(motion::restPose(clip.skeleton));
            clip.frames.back().joints[0].position.x = 0.125 * k;
            clip.frames.back().joints[1].orientation = Quat(0.6, 0.0, 0.8, 0.0);
        }
        const std::string bytes = assets::writeGlb(clip);
        CHECK(bytes == assets::writeGlb(clip));
        // glTF 2.0, 4.4: "glTF", version 2, and the file's length.
        CHECK(bytes.starts_with(std::string("glTF\2\0\0\0", 8)));
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 8, sizeof length);
        CHECK(length == bytes.size());
    }

    TEST_CASE("Clips that break their promises are the caller's mistake") {
        Clip clip = moving(2, 1.0 / 30.0);
        clip.frames[1].joints[3].position.x = std::nan("");
        CHECK_THROWS_AS(static_cast<void>(assets::writeGlb(clip)), std::invalid_argument);
        clip.frames.clear();
        CHECK_THROWS_AS(static_cast<void>(assets::writeGlb(clip)), std::invalid_argument);
        Clip crowded = moving(3, 1e-300);
        CHECK_THROWS_AS(static_cast<void>(assets::writeGlb(crowded)), std::invalid_argument);
    }

    TEST_CASE("A humanoid in a T pose becomes a VRM animation, and only such a one") {
        const Clip clip = moving(5, 1.0 / 30.0);
        assets::GlbOptions options;
        options.humanoid = motion::mapByVrmNames(clip.skeleton);
        CHECK(assets::whyNoVrmAnimation(clip, *options.humanoid).empty());
        const auto file = readBack(assets::writeGlb(clip, options));
        REQUIRE(file.humanoid.has_value());
        auto expected = *options.humanoid;
        expected[motion::Bone::leftEye] = expected[motion::Bone::rightEye] =
            -1;  // the format has gaze for them
        REQUIRE(expected.joint != options.humanoid->joint);
        CHECK(file.humanoid->joint == expected.joint);
        CHECK(file.humanoid_source == "VRMC_vrm_animation");

        Clip stretching = clip;
        stretching.frames[2]
            .joints[static_cast<std::size_t>((*options.humanoid)[motion::Bone::leftHand])]
            .position.x += 0.01;
        CHECK(assets::whyNoVrmAnimation(stretching, *options.humanoid) ==
              "the bone leftHand moves relative to its parent; only the hips may");
        CHECK_FALSE(readBack(assets::writeGlb(stretching, options)).humanoid.has_value());
        Clip turned = clip;
        turned.skeleton.joints[0].rest.orientation = Quat(0, 0, 1, 0);
        CHECK(assets::whyNoVrmAnimation(turned, *options.humanoid).find("T pose") != std::string::npos);
        auto handless = *options.humanoid;
        handless[motion::Bone::rightHand] = -1;
        CHECK(assets::whyNoVrmAnimation(clip, handless) == "the bone rightHand is missing");
    }

    TEST_CASE("BVH files turned into glTF and back keep every joint within a tenth of a millimetre") {
        const auto folder = tests::sharedData("bvh");
        DEIXIS_SKIP_WITHOUT(folder)
        int files = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            if (name.find(".bvh") == std::string::npos || !entry.is_regular_file()) continue;
            CAPTURE(name);
            auto bvh = assets::readBvh(entry.path());
            if (!bvh) FAIL(bvh.error().text());
            // A few seconds of the long ones tell as much.
            if (bvh->clip.frames.size() > 200) bvh->clip.frames.resize(200);
            const auto glb = readBack(assets::writeGlb(bvh->clip));
            const auto back = assets::parseBvh(assets::writeBvh(glb.clip), name, {1.0});
            REQUIRE(back.has_value());
            CHECK(worstDistance(bvh->clip, back->clip) < 1e-4);
            if (bvh->clip.frameCount() > 1)
                CHECK(glb.clip.frame_time_s == Approx(bvh->clip.frame_time_s).epsilon(1e-6));
            ++files;
        }
        CHECK(files >= 9);
    }

    // What follows writes files that other tests look at: the Khronos validator and Blender.
    TEST_CASE("A clip is exported for programs by others") {
        const std::filesystem::path folder = deixis::tests::buildDir() / "exported_clip";
        const Clip clip = moving(40, 1.0 / 30.0, 11);
        assets::GlbOptions options;
        options.humanoid = motion::mapByVrmNames(clip.skeleton);
        REQUIRE(writeFile(folder / "clip.glb", assets::writeGlb(clip, options)).has_value());
        REQUIRE(writeFile(folder / "clip.bvh", assets::writeBvh(clip)).has_value());
        std::string table;
        for (const std::size_t frame : {0U, 7U, 20U, 39U}) {
            const auto world = motion::worldPose(clip.skeleton, clip.frames[frame]);
            for (std::size_t j = 0; j < world.size(); ++j)
                table += fmt::format("{} {} {:.9f} {:.9f} {:.9f}\n", frame, clip.skeleton.joints[j].name,
                                     world[j].position.x, world[j].position.y, world[j].position.z);
        }
        REQUIRE(writeFile(folder / "positions.txt", table).has_value());
        CHECK(readBack(*readFile(folder / "clip.glb")).clip.frameCount() == 40);
    }
}
