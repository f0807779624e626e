// Avatars by others: each loads, and stands as an avatar does.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "shared_data.hpp"

using namespace deixis;
using motion::Bone;
namespace fs = std::filesystem;

namespace {

struct Figure {
    std::vector<Pose> world;
    double height_m = 0.0, floor_m = 0.0;
};

/// Loads it and checks what holds for every avatar.
Figure checkAvatar(const fs::path& file, assets::Avatar& avatar, const assets::AvatarOptions& options = {}) {
    CAPTURE(file.string());
    auto loaded = assets::loadAvatar(file, options);
    REQUIRE_MESSAGE(loaded.has_value(), (loaded ? std::string() : loaded.error().text()));
    avatar = std::move(*loaded);
    Figure figure;
    figure.world = motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton));
    double low = 100.0, high = -100.0;
    float max_error = 0.0F;
    for (const auto& v : avatar.vertices) {
        double y = 0.0;
        float sum = 0.0F;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += v.weights[i];
            y += static_cast<double>(v.weights[i]) *
                 transformPoint(figure.world[v.joints[i]] * avatar.joint_from_bind[v.joints[i]],
                                Vec3(v.position))
                     .y;
        }
        max_error = std::max(max_error, std::abs(sum - 1.0F));
        low = std::min(low, y);
        high = std::max(high, y);
    }
    CHECK(max_error < 1e-5F);
    CHECK(high == doctest::Approx(avatar.height_m));
    figure.height_m = high;
    figure.floor_m = low;
    for (const Bone bone : {Bone::hips, Bone::spine, Bone::head, Bone::leftUpperLeg, Bone::rightFoot})
        CHECK(avatar.humanoid.has(bone));
    const auto at = [&](Bone bone) {
        return figure.world[static_cast<std::size_t>(avatar.humanoid[bone])].position;
    };
    for (const bool left : {true, false}) {
        const auto bone = [&](Bone b) { return left ? b : motion::mirroredBone(b); };
        const Vec3 arm = glm::normalize(at(bone(Bone::leftHand)) - at(bone(Bone::leftUpperArm)));
        CHECK(arm.x * (left ? 1.0 : -1.0) > 0.9995);
        const Vec3 leg = glm::normalize(at(bone(Bone::leftFoot)) - at(bone(Bone::leftUpperLeg)));
        CHECK(leg.y < -0.98);
        if (avatar.humanoid.has(bone(Bone::leftToes))) {
            CHECK(at(bone(Bone::leftToes)).z > at(bone(Bone::leftFoot)).z + 0.02);
        }
    }
    for (const motion::Joint& joint : avatar.skeleton.joints) CHECK(joint.rest.orientation == no_rotation);
    return figure;
}

/// The mean of the vertices of a group of quads in an OBJ file, in its own unit.
Vec3 cubeMiddle(const fs::path& obj, const std::string& group) {
    std::ifstream file(obj);
    std::vector<Vec3> vertices;
    std::set<std::size_t> corners;
    bool inside = false;
    for (std::string word; file >> word;) {
        if (word == "v") {
            Vec3 p;
            file >> p.x >> p.y >> p.z;
            vertices.push_back(p);
        } else if (word == "g") {
            file >> word;
            inside = word == group;
        } else if (word == "f" && inside) {
            for (int i = 0; i < 4; ++i) {
                file >> word;
                corners.insert(std::stoul(word) - 1);
            }
        }
    }
    Vec3 sum(0.0);
    for (const std::size_t corner : corners) sum += vertices[corner];
    return sum / static_cast<double>(corners.size());
}

}  // namespace

TEST_SUITE("assets/shared_avatars") {
    TEST_CASE(
        "Figures under an armature of scale 100 stand on the floor, as tall as people, with whole hands") {
        for (const char* name : {"modular_men_Casual.glb", "modular_women_Formal.glb"}) {
            const fs::path file = tests::sharedData("avatars/quaternius") / name;
            DEIXIS_SKIP_WITHOUT(file);
            assets::Avatar avatar;
            const Figure figure = checkAvatar(file, avatar);
            CHECK(std::abs(figure.floor_m) < 1.1e-3);
            CHECK(figure.height_m > 1.5);
            CHECK(figure.height_m < 2.0);
            CHECK(avatar.skeleton.size() < 64);
            CHECK(avatar.humanoid.has(Bone::leftIndexDistal));
            CHECK(avatar.textures.empty());
        }
    }

    TEST_CASE("A figure in three files is read with its picture") {
        const fs::path file = tests::sharedData("avatars/kaykit_mannequin/manny_med_mod.gltf");
        DEIXIS_SKIP_WITHOUT(file);
        CHECK_FALSE(assets::loadAvatar(file).has_value());  // 2.21 m tall
        assets::Avatar avatar;
        const Figure figure = checkAvatar(file, avatar, {1.8});
        CHECK(std::abs(figure.floor_m) < 1.1e-3);
        CHECK(figure.height_m == doctest::Approx(1.8).epsilon(1e-3));
        REQUIRE(avatar.textures.size() == 1);
        REQUIRE(avatar.parts.size() == 1);
        CHECK(avatar.parts[0].double_sided);
    }

    TEST_CASE("A VRM without a skin is a figure of rigid parts") {
        const fs::path file = tests::sharedData("avatars/vrm/VRMC_vrm_expressions_isBinary_Overridden.vrm");
        DEIXIS_SKIP_WITHOUT(file);
        assets::Avatar avatar;
        const Figure figure = checkAvatar(file, avatar);
        CHECK(figure.height_m > 1.0);
        CHECK(figure.height_m < 1.5);
        CHECK(avatar.textures.size() == 3);
    }

    TEST_CASE("MakeHuman's base mesh with its Mixamo rig becomes a figure of a person's height") {
        const fs::path data = tests::sharedData("avatars/makehuman");
        DEIXIS_SKIP_WITHOUT(data);
        const fs::path file = deixis::tests::buildDir() / "makehuman.glb";
        const std::string command = std::string(DEIXIS_MAKE_HUMANOID) + " " + (data / "base.obj").string() +
                                    " " + (data / "mpfb2_rig.mixamo.json").string() + " " +
                                    (data / "mpfb2_weights.mixamo.json").string() + " " + file.string() +
                                    " > /dev/null";
        REQUIRE(std::system(command.c_str()) == 0);
        assets::Avatar avatar;
        const Figure figure = checkAvatar(file, avatar);
        CHECK(std::abs(figure.floor_m) < 1.1e-3);
        CHECK(figure.height_m > 1.5);
        CHECK(figure.height_m < 1.9);
        CHECK(avatar.humanoid.has(Bone::rightLittleDistal));
        // From knee to ankle as far as the cubes stand apart in the mesh that mark these joints.
        const auto at = [&](Bone bone) {
            return figure.world[static_cast<std::size_t>(avatar.humanoid[bone])].position;
        };
        CHECK(glm::length(at(Bone::leftLowerLeg) - at(Bone::leftFoot)) ==
              doctest::Approx(0.1 * glm::length(cubeMiddle(data / "base.obj", "joint-l-knee") -
                                                cubeMiddle(data / "base.obj", "joint-l-ankle")))
                  .epsilon(1e-5));
    }
}
