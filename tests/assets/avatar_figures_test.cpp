// Figures of all kinds come out as one kind of avatar, their skins as the glTF specification has them.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "assets/avatar/avatar.hpp"
#include "core/files.hpp"
#include "gltf_rig.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::tests;
using motion::Bone;

namespace {

assets::Avatar loaded(const std::string& bytes, const std::string& name) {
    const auto path = deixis::tests::buildDir() / ("avatar_figures_" + name + ".glb");
    REQUIRE(writeFile(path, bytes).has_value());
    auto avatar = assets::loadAvatar(path);
    REQUIRE_MESSAGE(avatar.has_value(), (avatar ? std::string() : avatar.error().text()));
    return std::move(*avatar);
}

std::vector<Vec3> skinned(const assets::Avatar& avatar, const motion::LocalPose& pose) {
    const auto world = motion::worldPose(avatar.skeleton, pose);
    std::vector<Vec3> out;
    for (const auto& v : avatar.vertices) {
        Vec3 sum(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            sum += static_cast<double>(v.weights[i]) *
                   transformPoint(world[v.joints[i]] * avatar.joint_from_bind[v.joints[i]], Vec3(v.position));
        out.push_back(sum);
    }
    return out;
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    REQUIRE(a.size() == b.size());
    double max = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) max = std::max(max, glm::length(a[i] - b[i]));
    return max;
}

/// A turn for each bone of the reference humanoid, up to 60 degrees about any axis.
std::vector<Quat> someTurns() {
    Random random(3);
    std::vector<Quat> turns;
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        turns.push_back(glm::slerp(no_rotation, someRotation(random), 0.3));
    return turns;
}

motion::LocalPose poseOf(const assets::Avatar& avatar, const std::vector<Quat>& turns) {
    motion::LocalPose pose = motion::restPose(avatar.skeleton);
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        if (const int joint = avatar.humanoid.joint[b]; joint >= 0)
            pose.joints[static_cast<std::size_t>(joint)].orientation = turns[b];
    return pose;
}

/// T pose and a bent pose against the specification; returns the avatar for more.
assets::Avatar checkFigure(const Rig& rig, const std::string& bytes, const std::string& name) {
    CAPTURE(name);
    assets::Avatar avatar = loaded(bytes, name);
    const std::vector<Quat> still(motion::bone_count, no_rotation);
    CHECK(farthest(skinned(avatar, motion::restPose(avatar.skeleton)),
                   skinnedBySpecification(rig, posed(rig, still))) < 1e-5);
    const auto turns = someTurns();
    CHECK(farthest(skinned(avatar, poseOf(avatar, turns)), skinnedBySpecification(rig, posed(rig, turns))) <
          1e-5);
    for (const motion::Joint& joint : avatar.skeleton.joints) CHECK(joint.rest.orientation == no_rotation);
    return avatar;
}

assets::Avatar checkFigure(const RigOptions& options, const std::string& name) {
    const Rig rig = makeRig(options);
    return checkFigure(rig, rigFile(rig, options).glb(), name);
}

}  // namespace

TEST_SUITE("assets/avatar_figures") {
    TEST_CASE("Any rest pose, axes, scales and order of joints give the same skeleton and the file's skin") {
        RigOptions plain;
        RigOptions scaled{.armature_scale = 100.0, .z_up_armature = true, .mesh_unit = 0.01};
        RigOptions turned{.rest_rotations = true};
        RigOptions a_pose{.rest_rotations = true, .arms_down_deg = 50.0};
        RigOptions matrices{.armature_scale = 0.01, .rest_rotations = true, .matrices = true};
        RigOptions shorts{.shuffled = true, .short_joints = true};
        RigOptions back{.rest_rotations = true, .faces_back = true};
        RigOptions bound_t{.arms_down_deg = 70.0, .mesh_unit = 0.01, .bound_in_t_pose = true};
        const motion::Skeleton& reference = motion::referenceHumanoid();
        const auto expected = motion::worldPose(reference, motion::restPose(reference));
        const std::vector<std::pair<std::string, RigOptions>> kinds{
            {"plain", plain},       {"scaled", scaled}, {"turned", turned}, {"a_pose", a_pose},
            {"matrices", matrices}, {"shorts", shorts}, {"back", back},     {"bound_t", bound_t}};
        for (const auto& kind : kinds) {
            CAPTURE(kind.first);
            const assets::Avatar avatar = checkFigure(kind.second, kind.first);
            REQUIRE(avatar.skeleton.size() == reference.size());
            const auto world = motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton));
            for (std::size_t b = 0; b < motion::bone_count; ++b) {
                REQUIRE(avatar.humanoid.joint[b] >= 0);
                const auto joint = static_cast<std::size_t>(avatar.humanoid.joint[b]);
                CHECK(avatar.skeleton.joints[joint].name == motion::boneName(static_cast<Bone>(b)));
                CHECK(glm::length(world[joint].position - expected[b].position) < 1e-5);
            }
        }
    }

    TEST_CASE("Names of another scheme come out as VRM names") {
        RigOptions options;
        options.rename = [](const std::string& name) {
            static const std::map<std::string, std::string> mixamo{
                {"hips", "mixamorig:Hips"},
                {"head", "mixamorig:Head"},
                {"spine", "mixamorig:Spine"},
                {"neck", "mixamorig:Neck"},
                {"leftUpperLeg", "mixamorig:LeftUpLeg"},
                {"rightUpperLeg", "mixamorig:RightUpLeg"},
                {"leftLowerLeg", "mixamorig:LeftLeg"},
                {"rightLowerLeg", "mixamorig:RightLeg"},
                {"leftFoot", "mixamorig:LeftFoot"},
                {"rightFoot", "mixamorig:RightFoot"},
                {"leftUpperArm", "mixamorig:LeftArm"},
                {"rightUpperArm", "mixamorig:RightArm"},
                {"leftLowerArm", "mixamorig:LeftForeArm"},
                {"rightLowerArm", "mixamorig:RightForeArm"},
                {"leftHand", "mixamorig:LeftHand"},
                {"rightHand", "mixamorig:RightHand"},
                {"leftShoulder", "mixamorig:LeftShoulder"},
                {"rightShoulder", "mixamorig:RightShoulder"}};
            const auto found = mixamo.find(name);
            return found == mixamo.end() ? "x_" + name : found->second;
        };
        const Rig rig = makeRig(options);
        const assets::Avatar avatar = loaded(rigFile(rig, options).glb(), "mixamo");
        CHECK(avatar.skeleton.find("leftLowerArm") == avatar.humanoid[Bone::leftLowerArm]);
        CHECK(avatar.skeleton.find("leftLowerArm") >= 0);
        CHECK(avatar.skeleton.find("mixamorig:LeftForeArm") == -1);
    }

    TEST_CASE("VRM's own map is taken whatever the names are, of either version") {
        RigOptions options{.rest_rotations = true, .faces_back = true};
        options.rename = [](const std::string& name) { return fmt::format("n{}", name.size()); };
        const Rig rig = makeRig(options);
        GlbText file = rigFile(rig, options);
        std::vector<std::string> bones_1, bones_0;
        for (std::size_t b = 0; b < rig.names.size(); ++b) {
            bones_1.push_back(fmt::format(R"("{}":{{"node":{}}})", rig.names[b], b + 1));
            std::string old = rig.names[b];
            for (const std::string side : {"left", "right"}) {
                if (rig.names[b] == side + "ThumbMetacarpal") old = side + "ThumbProximal";
                if (rig.names[b] == side + "ThumbProximal") old = side + "ThumbIntermediate";
            }
            bones_0.push_back(fmt::format(R"({{"bone":"{}","node":{}}})", old, b + 1));
        }
        const std::string plain = file.glb();
        file.more = fmt::format(R"(,"extensions":{{"VRMC_vrm":{{"humanoid":{{"humanBones":{{{}}}}}}}}})",
                                fmt::join(bones_1, ","));
        checkFigure(rig, file.glb(), "vrm1");
        file.more = fmt::format(R"(,"extensions":{{"VRM":{{"humanoid":{{"humanBones":[{}]}}}}}})",
                                fmt::join(bones_0, ","));
        const assets::Avatar avatar = checkFigure(rig, file.glb(), "vrm0");
        CHECK(avatar.skeleton.find("leftThumbMetacarpal") >= 0);

        file.more = R"(,"extensions":{"VRMC_vrm":{"humanoid":{"humanBones":{"hips":{"node":999}}}}})";
        const auto path = deixis::tests::buildDir() / "avatar_figures_bad.glb";
        REQUIRE(writeFile(path, file.glb()).has_value());
        auto bad = assets::loadAvatar(path);
        REQUIRE_FALSE(bad.has_value());
        CHECK(bad.error().text().find("hips") != std::string::npos);
        REQUIRE(writeFile(path, plain).has_value());
        // Without the map the figure's shape tells the same bones.
        const auto by_shape = assets::loadAvatar(path);
        REQUIRE(by_shape.has_value());
        for (const char* bone : {"hips", "head", "leftHand", "rightLowerArm", "rightFoot"})
            CHECK_MESSAGE(by_shape->skeleton.find(bone) == avatar.skeleton.find(bone), bone);
    }

    TEST_CASE("Two meshes bound in different poses, with skins of their own, each keep their skin") {
        RigOptions options{.armature_scale = 10.0, .rest_rotations = true, .arms_down_deg = 40.0};
        const Rig first = makeRig(options);
        RigOptions other = options;
        other.bound_in_t_pose = true;
        other.mesh_unit = 0.1;
        other.short_joints = true;
        Rig second = makeRig(other);
        GlbText file = rigFile(first, options);
        addMesh(file, second, other);
        const assets::Avatar avatar = loaded(file.glb(), "two_skins");
        const auto turns = someTurns();
        auto expected = skinnedBySpecification(first, posed(first, turns));
        const auto more = skinnedBySpecification(second, posed(second, turns));
        expected.insert(expected.end(), more.begin(), more.end());
        CHECK(farthest(skinned(avatar, poseOf(avatar, turns)), expected) < 1e-5);
    }

    TEST_CASE("A mesh that hangs on a joint without a skin follows it, at its own place and scale") {
        RigOptions options{.armature_scale = 10.0, .rest_rotations = true};
        const Rig rig = makeRig(options);
        GlbText file = rigFile(rig, options);
        const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        const int position = file.accessor(corners, 5126, "VEC3", 4);
        // A strip of two triangles, the second of which runs the other way round.
        file.meshes.push_back(
            fmt::format(R"({{"primitives":[{{"mode":5,"attributes":{{"POSITION":{}}}}}]}})", position));
        file.nodes.push_back(
            R"({"name":"watch","mesh":1,"translation":[0.001,0,0],"scale":[0.005,0.01,0.02]})");
        const auto hand = static_cast<std::size_t>(Bone::leftHand) + 1;
        std::string& node = file.nodes[hand];
        const auto at = node.find(R"("children":[)");
        REQUIRE(at != std::string::npos);
        node.insert(at + 12, fmt::format("{},", file.nodes.size() - 1));
        const assets::Avatar avatar = loaded(file.glb(), "rigid");
        const auto turns = someTurns();
        const glm::dmat4 world = posed(rig, turns)[hand] *
                                 glm::translate(glm::dmat4(1.0), Vec3(0.001, 0, 0)) *
                                 glm::scale(glm::dmat4(1.0), Vec3(0.005, 0.01, 0.02));
        auto expected = skinnedBySpecification(rig, posed(rig, turns));
        for (std::size_t i = 0; i < 4; ++i)
            expected.emplace_back(world *
                                  glm::dvec4(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2], 1.0));
        CHECK(farthest(skinned(avatar, poseOf(avatar, turns)), expected) < 1e-5);
        const auto first = static_cast<std::uint32_t>(rig.vertices.size());
        const std::vector<std::uint32_t> strip(avatar.indices.end() - 6, avatar.indices.end());
        CHECK(strip ==
              std::vector<std::uint32_t>{first, first + 1, first + 2, first + 1, first + 3, first + 2});
    }

    TEST_CASE("Feet that hang on the root are hung on the legs") {
        RigOptions options;
        options.feet_on_root = true;
        const Rig rig = makeRig(options);
        const assets::Avatar avatar = checkFigure(rig, rigFile(rig, options).glb(), "feet");
        const auto foot = static_cast<std::size_t>(avatar.humanoid[Bone::leftFoot]);
        CHECK(avatar.skeleton.joints[foot].parent == avatar.humanoid[Bone::leftLowerLeg]);
        CHECK(avatar.remarks.size() == 2);
    }

    TEST_CASE("Where joints scale a mesh differently it is set in the rest pose, and a remark says so") {
        const RigOptions options{.rest_rotations = true};
        Rig rig = makeRig(options);
        auto& inverse = rig.inverse_bind[static_cast<std::size_t>(Bone::leftLowerArm)];
        inverse = inverse * glm::scale(glm::dmat4(1.0), Vec3(1.2, 1.0, 0.9));
        const assets::Avatar avatar = loaded(rigFile(rig, options).glb(), "sheared");
        const std::vector<Quat> still(motion::bone_count, no_rotation);
        CHECK(farthest(skinned(avatar, motion::restPose(avatar.skeleton)),
                       skinnedBySpecification(rig, posed(rig, still))) < 1e-5);
        REQUIRE(avatar.remarks.size() == 1);
        CHECK(avatar.remarks[0].find("fixed in the rest pose") != std::string::npos);
    }

    TEST_CASE("Of more than four influences the heaviest stay") {
        const RigOptions options;
        const Rig rig = makeRig(options);
        GlbText file = rigFile(rig, options);
        // A second set: every vertex follows joint 3 by half, which the first set then lacks.
        std::vector<std::uint8_t> joints;
        std::vector<float> weights, first_weights;
        std::vector<std::uint8_t> first_joints;
        for (std::size_t v = 0; v < rig.vertices.size(); ++v) {
            joints.insert(joints.end(), {3, 0, 0, 0});
            weights.insert(weights.end(), {0.5F, 0, 0, 0});
            first_joints.insert(first_joints.end(), {0, 1, 2, 4});
            first_weights.insert(first_weights.end(), {0.2F, 0.15F, 0.1F, 0.05F});
        }
        const std::size_t count = rig.vertices.size();
        const int set = file.accessor(joints, 5121, "VEC4", count);
        file.accessor(weights, 5126, "VEC4", count);
        file.accessor(first_joints, 5121, "VEC4", count);
        file.accessor(first_weights, 5126, "VEC4", count);
        file.meshes[0] = fmt::format(
            R"({{"primitives":[{{"attributes":{{"POSITION":0,"JOINTS_0":{},"WEIGHTS_0":{},"JOINTS_1":{},"WEIGHTS_1":{}}}}}]}})",
            set + 2, set + 3, set, set + 1);
        const assets::Avatar avatar = loaded(file.glb(), "five");
        REQUIRE(avatar.vertices.size() == count);
        const auto& v = avatar.vertices.front();
        CHECK(v.joints == std::array<std::uint16_t, 4>{3, 0, 1, 2});
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(v.weights[i] == doctest::Approx(std::array{0.5, 0.2, 0.15, 0.1}[i] / 0.95));
        REQUIRE(avatar.remarks.size() == 1);
        CHECK(avatar.remarks[0].find("4 with the largest weights") != std::string::npos);
    }

    TEST_CASE("A figure in centimetres is scaled to metres, with a remark") {
        RigOptions options;
        options.armature_scale = 1.0;
        const Rig rig = makeRig(options);
        GlbText file = rigFile(rig, options);
        file.nodes.push_back(R"({"name":"whole","scale":[100,100,100],"children":[0]})");
        const assets::Avatar avatar = loaded(file.glb(), "unit");
        const auto world = motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton));
        const auto hips = static_cast<std::size_t>(avatar.humanoid[Bone::hips]);
        CHECK(world[hips].position.y == doctest::Approx(0.93).epsilon(1e-4));
        CHECK(avatar.remarks.size() == 1);
    }
}
