// Files by others: the Khronos validator's and asset generator's, Quaternius, KayKit, VRM.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "assets/gltf/gltf_clip.hpp"
#include "core/files.hpp"
#include "shared_data.hpp"

using namespace deixis;
using assets::GltfClipFile;
using doctest::Approx;

namespace {

GltfClipFile read(const std::filesystem::path& path, const assets::GltfClipOptions& options = {}) {
    auto file = assets::readGltfClip(path, options);
    if (!file) FAIL(file.error().text());
    return std::move(*file);
}

Vec3 extent(const GltfClipFile& file, std::size_t frame) {
    const auto world = motion::worldPose(file.clip.skeleton, file.clip.frames.at(frame));
    Vec3 min = world.front().position;
    Vec3 max = min;
    for (const Pose& joint : world) {
        min = glm::min(min, joint.position);
        max = glm::max(max, joint.position);
    }
    return max - min;
}

Vec3 worldAtFrame(const GltfClipFile& file, std::size_t frame, const char* joint) {
    const int index = file.clip.skeleton.find(joint);
    REQUIRE(index >= 0);
    return motion::worldPose(file.clip.skeleton, file.clip.frames.at(frame))
        .at(static_cast<std::size_t>(index))
        .position;
}

// Errors in the validator's reports that concern what a clip does not need.
const std::set<std::string> not_read{
    // Numbers that no animation uses are not read.
    "ACCESSOR_INVALID_FLOAT",
    "ACCESSOR_MIN_MISMATCH",
    "ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND",
    "ACCESSOR_MAX_MISMATCH",
    "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND",
    // Inverse bind matrices bend meshes.
    "ACCESSOR_INVALID_IBM",
    // The attributes and morph targets of meshes.
    "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS",
    "NODE_SKIN_WITH_NON_SKINNED_MESH",
    "NODE_WEIGHTS_INVALID",
    // Which nodes a scene shows.
    "NODE_SKIN_NO_SCENE",
};

}  // namespace

TEST_SUITE("assets/gltf_shared") {
    TEST_CASE("The validator's files never crash, and what it calls an error is rejected or told") {
        const auto folder = tests::sharedData("gltf/khronos_validator");
        DEIXIS_SKIP_WITHOUT(folder)
        int files = 0, faulty = 0, rejected = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
            const auto report_text = readFile(entry.path().string() + ".report.json");
            REQUIRE(report_text.has_value());
            const auto report = nlohmann::json::parse(*report_text);
            CAPTURE(entry.path().string());
            const auto text = readFile(entry.path());
            REQUIRE(text.has_value());
            auto json = nlohmann::json::parse(*text, nullptr, false);
            // Many hold accessors alone: a node, so that they are not rejected for the lack of one.
            if (!json.is_discarded() && !json.contains("nodes") && json.contains("accessors") &&
                !json.contains("skins") && !json.contains("animations"))
                json["nodes"] = {{{"name", "a"}}};
            const auto file = assets::parseGltfClip(json.is_discarded() ? *text : json.dump(),
                                                    entry.path().string(), {}, entry.path().parent_path());
            ++files;
            if (!file) ++rejected;
            // Accessors without data are zeros: valid, but no times.
            if (report.at("issues").at("numErrors") == 0 && !file &&
                file.error().text().find("expected a later one") == std::string::npos)
                FAIL_CHECK(file.error().text());
            bool concerns_us = false;
            for (const auto& message : report.at("issues").at("messages"))
                concerns_us = concerns_us || (message.at("severity") == 0 &&
                                              not_read.count(message.at("code").get<std::string>()) == 0);
            if (!concerns_us) continue;
            ++faulty;
            if (!file) continue;
            std::string told;
            for (const std::string& remark : file->remarks) told += remark + "\n";
            INFO(told);
            CHECK(told.find("violates the specification") != std::string::npos);
        }
        MESSAGE(files, " files, ", rejected, " rejected; ", faulty, " with errors in parts that are read");
        CHECK(files >= 80);
        CHECK(faulty >= 40);
    }

    TEST_CASE("The asset generator's animations of nodes and skins are read") {
        for (const char* group :
             {"Animation_Node", "Animation_NodeMisc", "Animation_Skin", "Animation_SkinType",
              "Buffer_Interleaved", "Node_NegativeScale", "Node_Attribute"}) {
            const auto folder = tests::sharedData(std::string("gltf/asset_generator_0.6/") + group);
            DEIXIS_SKIP_WITHOUT(folder)
            for (const auto& entry : std::filesystem::directory_iterator(folder)) {
                if (entry.path().extension() != ".gltf") continue;
                CAPTURE(entry.path().string());
                const auto file = assets::readGltfClip(entry.path());
                if (!file) FAIL_CHECK(file.error().text());
            }
        }
    }

    TEST_CASE("The asset generator's keys stand where its manual says") {
        const auto folder = tests::sharedData("gltf/asset_generator_0.6");
        DEIXIS_SKIP_WITHOUT(folder)
        // "One keyframe [...] translation with a value of [-0.1, 0.0, 0.0]"
        const auto one_key = read(folder / "Animation_NodeMisc/Animation_NodeMisc_03.gltf");
        CHECK(one_key.clip.frameCount() == 1);
        CHECK(one_key.clip.frames[0].joints[0].position.x == Approx(-0.1));
        // "The start and end times of both channels are 0.0 and 4.0"
        CHECK(read(folder / "Animation_NodeMisc/Animation_NodeMisc_00.gltf").clip.duration_s() ==
              Approx(4.0));
        // "translation with start and end times of 2.0 and 6.0, rotation with 1.0 and 5.0"
        CHECK(read(folder / "Animation_NodeMisc/Animation_NodeMisc_02.gltf").clip.duration_s() ==
              Approx(5.0));
        // "two animations: the first targets rotation, the second translation"
        const auto two = folder / "Animation_NodeMisc/Animation_NodeMisc_07.gltf";
        CHECK(read(two).animations.size() == 2);
        assets::GltfClipOptions second;
        second.animation_index = 1;
        const auto moved = read(two, second);
        CHECK(moved.clip.frames[0].joints[0].orientation == no_rotation);
        // skinB: the joints hang below the armature's node.
        CHECK(read(folder / "Animation_Skin/Animation_Skin_01.gltf").clip.frameCount() > 30);
    }

    TEST_CASE("Quaternius people, whose armature scales by 100, are of a person's size") {
        for (const char* name : {"modular_men_Casual.glb", "modular_women_Formal.glb"}) {
            const auto path = tests::sharedData(std::string("avatars/quaternius/") + name);
            DEIXIS_SKIP_WITHOUT(path)
            CAPTURE(name);
            const auto file = read(path);
            const Vec3 size = extent(file, 0);
            CAPTURE(size.y);
            CHECK(size.y > 1.4);
            CHECK(size.y < 2.0);
            CHECK(worldAtFrame(file, 0, "Head").y > worldAtFrame(file, 0, "Hips").y + 0.4);
            CHECK(worldAtFrame(file, 0, "Hand.L").x > 0.2);
            CHECK(file.clip.skeleton.size() >= 49);
            CHECK(file.remarks.size() == 1);  // that it has no animation
        }
    }

    TEST_CASE("KayKit's animations are read one by one, at 30 fps and a figure's size") {
        for (const char* name : {"Med_General.glb", "Med_Simulation.glb"}) {
            const auto path = tests::sharedData(std::string("avatars/kaykit_mannequin/") + name);
            DEIXIS_SKIP_WITHOUT(path)
            const auto first = read(path);
            REQUIRE(first.animations.size() >= 14);
            for (std::size_t i = 0; i < first.animations.size(); ++i) {
                assets::GltfClipOptions options;
                options.animation_index = static_cast<int>(i);
                const auto file = read(path, options);
                CAPTURE(file.animation);
                CHECK(file.clip.framesPerSecond() == Approx(30.0).epsilon(1e-5));
                const Vec3 size = extent(file, file.clip.frames.size() / 2);
                CHECK(std::max({size.x, size.y, size.z}) > 0.9);
                CHECK(std::max({size.x, size.y, size.z}) < 3.5);
            }
        }
        const auto path = tests::sharedData("avatars/kaykit_mannequin/Med_Simulation.glb");
        assets::GltfClipOptions waving;
        waving.animation = "Rig_Medium|Waving";
        const auto file = read(path, waving);
        double highest = 0.0;
        for (std::size_t k = 0; k < file.clip.frames.size(); ++k)
            highest =
                std::max({highest, worldAtFrame(file, k, "hand.r").y, worldAtFrame(file, k, "hand.l").y});
        CHECK(highest > worldAtFrame(file, 0, "head").y);  // a waving hand is above the neck
    }

    TEST_CASE("VRM 1.0 and a VRM animation bring their humanoid bones") {
        const auto vrm_path = tests::sharedData("avatars/vrm/VRMC_vrm_expressions_isBinary_Overridden.vrm");
        DEIXIS_SKIP_WITHOUT(vrm_path)
        using motion::Bone;
        const auto vrm = read(vrm_path);
        REQUIRE(vrm.humanoid.has_value());
        CHECK(vrm.clip.skeleton.joints[static_cast<std::size_t>((*vrm.humanoid)[Bone::leftFoot])].name ==
              "Foot.L");
        CHECK(vrm.clip.skeleton.joints[static_cast<std::size_t>((*vrm.humanoid)[Bone::rightToes])].name ==
              "Toes.R");
        const auto vrma = read(tests::sharedData("avatars/vrm/test.vrma"));
        REQUIRE(vrma.humanoid.has_value());
        CHECK(vrma.clip.skeleton.size() == 51);
        int bones = 0;
        for (const int joint : vrma.humanoid->joint) bones += joint >= 0 ? 1 : 0;
        CHECK(bones == 51);
        CHECK(vrma.clip.duration_s() == Approx(3.0));
        CHECK(worldAtFrame(vrma, 0, "leftHand").x > 0.5);  // T pose, facing +z
        CHECK(worldAtFrame(vrma, 0, "head").y > 1.3);
    }
}
