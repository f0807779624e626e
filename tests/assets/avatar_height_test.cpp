// Avatars that are no people's height, or whose bones a person has to name.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "assets/avatar/avatar.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "gltf_rig.hpp"
#include "shared_data.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using motion::Bone;
namespace fs = std::filesystem;

namespace {

/// A rig in a file of its own folder, perhaps with a word beside it.
fs::path figure(const std::string& name, const std::string& bytes, const std::string& words = {}) {
    const fs::path folder = deixis::tests::buildDir() / "avatar_height";
    fs::create_directories(folder);
    const fs::path path = folder / (name + ".glb");
    REQUIRE(writeFile(path, bytes).has_value());
    fs::remove(folder / (name + ".humanoid.toml"));
    if (!words.empty()) REQUIRE(writeFile(folder / (name + ".humanoid.toml"), words).has_value());
    return path;
}

/// The reference humanoid, 1.75 m tall, this many times as large.
std::string sized(double factor) {
    const RigOptions options;
    GlbText file = rigFile(makeRig(options), options);
    file.nodes.push_back(fmt::format(R"({{"name":"whole","scale":[{0},{0},{0}],"children":[0]}})", factor));
    return file.glb();
}

std::string rejection(const fs::path& path, const assets::AvatarOptions& options = {}) {
    const auto avatar = assets::loadAvatar(path, options);
    REQUIRE_FALSE(avatar.has_value());
    return avatar.error().text();
}

assets::Avatar loaded(const fs::path& path, const assets::AvatarOptions& options = {}) {
    auto avatar = assets::loadAvatar(path, options);
    REQUIRE_MESSAGE(avatar.has_value(), (avatar ? std::string() : avatar.error().text()));
    return std::move(*avatar);
}

double hipHeight(const assets::Avatar& avatar) {
    return motion::worldPose(
               avatar.skeleton,
               motion::restPose(avatar.skeleton))[static_cast<std::size_t>(avatar.humanoid[Bone::hips])]
        .position.y;
}

}  // namespace

TEST_SUITE("assets/avatar_height") {
    TEST_CASE("An avatar that is no person's height is rejected, and stands as tall as it is asked to") {
        const double plain_m = loaded(figure("plain", sized(1.0))).height_m;
        for (const double factor : {0.35, 0.6, 1.4, 1.8}) {
            CAPTURE(factor);
            const fs::path path = figure("odd", sized(factor));
            const std::string error = rejection(path);
            CHECK(contains(error, path.string()));
            CHECK(contains(error, fmt::format("is {:.2f} m tall, expected 1.2 to 2.2 m", factor * plain_m)));
            CHECK(contains(error, "avatar_height_m = 1.7 under [study]"));
            CHECK(contains(error, "height_m = 1.7 in "));
            CHECK(contains(error, "odd.humanoid.toml"));
            for (const double wanted_m : {0.9, 1.6, 2.8}) {
                const assets::Avatar avatar = loaded(path, {wanted_m});
                CHECK(avatar.height_m == doctest::Approx(wanted_m).epsilon(1e-4));
                CHECK(hipHeight(avatar) == doctest::Approx(0.93 * wanted_m / plain_m).epsilon(1e-3));
                REQUIRE(avatar.remarks.size() == 1);
                CHECK(contains(avatar.remarks[0], "as requested"));
            }
        }
        for (const double factor : {0.75, 1.0, 1.25, 100.0, 0.01})
            CHECK(loaded(figure("fine", sized(factor))).remarks.empty() == (factor > 0.1 && factor < 10.0));
    }

    TEST_CASE("The file beside an avatar tells its height, under the study's word, and is part of its hash") {
        const std::string bytes = sized(2.6);
        const fs::path path = figure("robot", bytes, "height_m = 1.8\n");
        const assets::Avatar avatar = loaded(path);
        CHECK(avatar.height_m == doctest::Approx(1.8).epsilon(1e-4));
        CHECK(loaded(path, {1.5}).height_m == doctest::Approx(1.5).epsilon(1e-4));
        CHECK(avatar.content_hash == sha256Hex(sha256Hex(bytes) + sha256Hex("height_m = 1.8\n")));
        CHECK(loaded(path, {1.5}).content_hash != avatar.content_hash);
        CHECK(contains(rejection(figure("robot", bytes, "height_m = nan\n")),
                       "robot.humanoid.toml:1: height_m"));
    }

    TEST_CASE("The file beside an avatar says which joint plays which bone") {
        RigOptions options;
        options.rename = [](const std::string& name) { return name == "leftHand" ? "claw" : "x_" + name; };
        const Rig rig = makeRig(options);
        const std::string bytes = rigFile(rig, options).glb();
        const assets::Avatar by_shape = loaded(figure("claw", bytes));
        CHECK(by_shape.humanoid.has(Bone::leftHand));
        // An arm that is a bone shorter, because somebody says so.
        const fs::path path = figure("claw", bytes, "leftHand = \"x_leftMiddleProximal\"\n");
        const assets::Avatar avatar = loaded(path);
        const auto x = [&](const assets::Avatar& a, Bone bone) {
            return motion::worldPose(a.skeleton,
                                     motion::restPose(a.skeleton))[static_cast<std::size_t>(a.humanoid[bone])]
                .position.x;
        };
        CHECK(x(avatar, Bone::leftHand) > x(by_shape, Bone::leftHand) + 0.05);
        CHECK(contains(avatar.remarks.front(),
                       "bones as " + (path.parent_path() / "claw.humanoid.toml").string()));
        const std::string unknown = rejection(figure("claw", bytes, "leftHand = \"clav\"\n"));
        CHECK(contains(unknown,
                       "claw.humanoid.toml:1: leftHand: found \"clav\", expected one of the figure's"));
        CHECK(contains(unknown, "Did you mean claw?"));
        // Refusals name joints, bones and the file that mends them.
        const std::string upside = rejection(
            figure("claw", bytes, "hips = \"x_leftHand\"\nleftHand = \"claw\"\nhead = \"x_head\"\n"));
        CHECK(contains(upside, "x_leftHand"));
        const std::string above = rejection(
            figure("claw", bytes, "leftUpperArm = \"x_leftLowerArm\"\nleftLowerArm = \"x_leftUpperArm\"\n"));
        CHECK(contains(above, "the joint \"x_leftUpperArm\" is leftLowerArm but is above"));
        CHECK(contains(above, "claw.humanoid.toml"));
    }

    TEST_CASE("VRM 0.x may list bones that a figure lacks with node -1; VRM 1.0 may not") {
        const RigOptions options{.faces_back = true};
        const Rig rig = makeRig(options);
        GlbText file = rigFile(rig, options);
        std::vector<std::string> bones;
        for (std::size_t b = 0; b < rig.names.size(); ++b) {
            if (rig.names[b].find("Little") != std::string::npos ||
                rig.names[b].find("Thumb") != std::string::npos)
                continue;
            bones.push_back(fmt::format(R"({{"bone":"{}","node":{}}})", rig.names[b],
                                        rig.names[b] == "jaw" ? -1 : static_cast<int>(b) + 1));
        }
        const auto vrm0 = [&] {
            return fmt::format(R"(,"extensions":{{"VRM":{{"humanoid":{{"humanBones":[{}]}}}}}})",
                               fmt::join(bones, ","));
        };
        file.more = vrm0();
        const assets::Avatar avatar = loaded(figure("vrm0", file.glb()));
        CHECK_FALSE(avatar.humanoid.has(Bone::jaw));
        CHECK(avatar.humanoid.has(Bone::leftHand));
        bones.push_back(R"({"bone":"jaw","node":-2})");
        file.more = vrm0();
        CHECK(contains(rejection(figure("vrm0", file.glb())), "/node: found -2, expected a whole number"));
        // VRM 1.0 forbids it, and exporters do it all the same.
        std::string vrm1;
        for (std::size_t b = 0; b < rig.names.size(); ++b)
            vrm1 += fmt::format(R"({}"{}":{{"node":{}}})", b > 0 ? "," : "", rig.names[b],
                                rig.names[b] == "jaw" ? -1 : static_cast<int>(b) + 1);
        file.more = R"(,"extensions":{"VRMC_vrm":{"humanoid":{"humanBones":{)" + vrm1 + "}}}}";
        CHECK_FALSE(loaded(figure("vrm1", file.glb())).humanoid.has(Bone::jaw));
        file.more = R"(,"extensions":{"VRMC_vrm":{"humanoid":{"humanBones":{"jaw":{"node":-2}}}}})";
        CHECK(
            contains(rejection(figure("vrm1", file.glb())),
                     "/extensions/VRMC_vrm/humanoid/humanBones/jaw/node: found -2, expected a whole number"));
    }

    TEST_CASE("A robot of 4.56 m comes through the door") {
        const fs::path robot = tests::sharedData("repro/RobotExpressive.glb");
        DEIXIS_SKIP_WITHOUT(robot);
        CHECK(contains(rejection(robot), "is 4.56"));
        const auto leftOut = [](const assets::Avatar& avatar) {
            return std::any_of(avatar.remarks.begin(), avatar.remarks.end(),
                               [](const std::string& remark) { return contains(remark, "left out"); });
        };
        const assets::Avatar by_names = loaded(robot, {1.7});
        CHECK(by_names.height_m == doctest::Approx(1.7).epsilon(1e-4));
        CHECK(leftOut(by_names));  // "Hips" carries the trunk alone
        const auto bytes = readFile(robot);
        REQUIRE(bytes.has_value());
        const assets::Avatar whole = loaded(figure("robot", *bytes,
                                                   "height_m = 1.7\nhips = \"Body\"\nleftFoot = \"FootL\"\n"
                                                   "rightFoot = \"FootR\"\n"));
        CHECK_FALSE(leftOut(whole));
        CHECK(whole.height_m == doctest::Approx(1.7).epsilon(1e-4));
    }
}
