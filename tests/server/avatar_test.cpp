// Another avatar than Deixis's own in the page: the file that is served, and the tracks that turn its bones.
#include "assets/avatar/avatar_glb.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "app/program.hpp"
#include "assets/avatar/avatar.hpp"
#include "assets/gltf_rig.hpp"
#include "assets/joints/clip_import.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

assets::Avatar oddAvatar() {
    RigOptions options;
    options.z_up_armature = true;
    options.rest_rotations = true;
    options.arms_down_deg = 40.0;
    options.faces_back = true;
    auto avatar = assets::readAvatar(rigFile(makeRig(options), options).glb(), "odd.glb");
    REQUIRE_MESSAGE(avatar.has_value(), (avatar ? "" : avatar.error().text()));
    return std::move(*avatar);
}

/// What hangs on it hangs on its parent.
motion::Skeleton withoutJoint(const motion::Skeleton& skeleton, const std::string& name) {
    const int gone = skeleton.find(name);
    REQUIRE(gone > 0);
    const motion::Joint& removed = skeleton.joints[static_cast<std::size_t>(gone)];
    motion::Skeleton out;
    for (int i = 0; i < skeleton.size(); ++i) {
        if (i == gone) continue;
        motion::Joint joint = skeleton.joints[static_cast<std::size_t>(i)];
        if (joint.parent == gone) {
            joint.parent = removed.parent;
            joint.rest.position += removed.rest.position;
        } else if (joint.parent > gone) {
            --joint.parent;
        }
        out.joints.push_back(joint);
    }
    return out;
}

/// Where a bone of the served file goes by the tracks, in the way of web/src/view/pose.ts: each named node
/// gets the rotation in its parent.
std::vector<Pose> posed(const motion::Skeleton& skeleton, const json& tracks, std::size_t frame) {
    auto local = motion::restPose(skeleton);
    const json& row = tracks["rotations"][frame];
    for (std::size_t i = 0; i < tracks["bones"].size(); ++i) {
        const int joint = skeleton.find(tracks["bones"][i].get<std::string>());
        if (joint < 0) continue;
        local.joints[static_cast<std::size_t>(joint)].orientation =
            Quat(row[4 * i + 3].get<double>(), row[4 * i].get<double>(), row[4 * i + 1].get<double>(),
                 row[4 * i + 2].get<double>());
    }
    return motion::worldPose(skeleton, local);
}

}  // namespace

TEST_SUITE("server/avatar") {
    TEST_CASE("The file that is served is the same avatar when it is read again") {
        auto avatar = oddAvatar();
        // Two parts, one with a texture.
        assets::AvatarTexture texture;
        texture.width = 3;
        texture.height = 2;
        for (int i = 0; i < 24; ++i) texture.rgba.push_back(static_cast<std::uint8_t>(i * 37 % 251));
        texture.wrap_v = assets::TextureWrap::clamp;
        avatar.textures = {texture};
        const auto half = static_cast<std::uint32_t>(avatar.indices.size() / 6 * 3);
        avatar.parts = {{0, half, 0, 0.5F, true},
                        {half, static_cast<std::uint32_t>(avatar.indices.size()) - half, -1, 0.0F, false}};
        for (std::size_t i = 0; i < avatar.vertices.size(); ++i)
            avatar.vertices[i].uv = {0.1F * static_cast<float>(i % 10), 0.25F};
        const auto again = assets::readAvatar(assets::writeAvatarGlb(avatar), "again.glb");
        REQUIRE_MESSAGE(again.has_value(), (again ? "" : again.error().text()));
        REQUIRE(again->skeleton.size() == avatar.skeleton.size());
        const auto before = motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton));
        const auto after = motion::worldPose(again->skeleton, motion::restPose(again->skeleton));
        for (int joint = 0; joint < avatar.skeleton.size(); ++joint) {
            const auto at = static_cast<std::size_t>(joint);
            const int there = again->skeleton.find(avatar.skeleton.joints[at].name);
            REQUIRE(there >= 0);
            CHECK(glm::length(before[at].position - after[static_cast<std::size_t>(there)].position) < 1e-5);
        }
        CHECK(again->height_m == doctest::Approx(avatar.height_m).epsilon(1e-5));
        REQUIRE(again->vertices.size() == 2 * avatar.vertices.size());  // once for each part
        const auto skinned = [](const assets::Avatar& of, const std::vector<Pose>& world, std::size_t i) {
            Vec3 sum(0.0);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t joint = of.vertices[i].joints[k];
                const Vec3 bound = transformPoint(of.joint_from_bind[joint], Vec3(of.vertices[i].position));
                sum += static_cast<double>(of.vertices[i].weights[k]) * transformPoint(world[joint], bound);
            }
            return sum;
        };
        for (std::size_t i = 0; i < avatar.vertices.size(); ++i)
            CHECK(glm::length(skinned(avatar, before, i) - skinned(*again, after, i)) < 1e-5);
        CHECK(again->indices.size() == avatar.indices.size());
        REQUIRE(again->textures.size() == 1);
        CHECK(again->textures[0].rgba == texture.rgba);
        CHECK(again->textures[0].wrap_v == assets::TextureWrap::clamp);
        REQUIRE(again->parts.size() == 2);
        CHECK(again->parts[0].texture == 0);
        CHECK(again->parts[0].alpha_cutoff == 0.5F);
        CHECK(again->parts[0].double_sided);
        CHECK(again->parts[1].texture == -1);
    }

    TEST_CASE("Textures are made smaller until they fit") {
        auto avatar = oddAvatar();
        assets::AvatarTexture texture;
        texture.width = 4 * assets::largest_texture_side;
        texture.height = 4;
        texture.rgba.assign(static_cast<std::size_t>(texture.width) * 16, 200);
        avatar.textures = {texture};
        avatar.parts = {{0, static_cast<std::uint32_t>(avatar.indices.size()), 0, 0.0F, false}};
        const auto again = assets::readAvatar(assets::writeAvatarGlb(avatar), "again.glb");
        REQUIRE_MESSAGE(again.has_value(), (again ? "" : again.error().text()));
        CHECK(again->textures[0].width == assets::largest_texture_side);
        CHECK(again->textures[0].height == 1);
        CHECK(again->textures[0].rgba[5] == 200);
    }

    TEST_CASE("Its arms point where those of Deixis's own avatar do, though a bone of the back is missing") {
        const auto avatar = oddAvatar();
        auto parts = studioParts();
        const motion::Skeleton skeleton = withoutJoint(avatar.skeleton, "upperChest");
        parts.avatar = server::DrawnAvatar{skeleton, motion::mapByVrmNames(skeleton)};
        const StudioServer server{std::move(parts)}, plain;
        json frames = plain.get("/v1/motions")["motions"][0]["frames"];
        for (json& frame : frames) frame[0] = 0.4, frame[1] = 0.9;  // leaning to its left
        const json own = server.post("/v1/tracks", {{"frames", frames}}).body["tracks"];
        const json reference = plain.post("/v1/tracks", {{"frames", frames}}).body["tracks"];
        for (const json& bone : own["bones"]) CHECK(skeleton.find(bone.get<std::string>()) >= 0);
        double turned = 0.0;
        for (std::size_t frame = 0; frame < frames.size(); frame += 5) {
            const auto theirs = posed(skeleton, own, frame);
            const auto ours = posed(motion::referenceHumanoid(), reference, frame);
            const auto direction = [](const motion::Skeleton& of, const std::vector<Pose>& world,
                                      const std::string& from, const std::string& to) {
                const auto at = [&](const std::string& name) {
                    return world[static_cast<std::size_t>(of.find(name))].position;
                };
                return glm::normalize(at(to) - at(from));
            };
            for (const std::string side : {"left", "right"})
                for (const auto& [from, to] :
                     {std::pair{"UpperArm", "LowerArm"}, std::pair{"LowerArm", "Hand"}}) {
                    const Vec3 there = direction(skeleton, theirs, side + from, side + to);
                    const Vec3 here = direction(motion::referenceHumanoid(), ours, side + from, side + to);
                    CHECK(angleBetween(there, here) < 0.02);
                    turned = std::max(turned, angleBetween(here, Vec3(side == "left" ? 1 : -1, 0, 0)));
                }
        }
        CHECK(turned > 0.5);
        // And so does a file.
        const auto file = server.client().Post(
            "/v1/export", json{{"frames", frames}, {"format", "bvh"}}.dump(), "application/json");
        REQUIRE(file);
        REQUIRE_MESSAGE(file->status == 200, file->body);
        const auto clip = assets::importClipBytes(file->body, "theirs.bvh");
        REQUIRE(clip);
        CHECK(clip->clip.skeleton.find("upperChest") < 0);
        const auto back = motion::upperBodyOf(clip->clip, motion::mapByVrmNames(clip->clip.skeleton));
        REQUIRE(back);
        for (std::size_t k = 9; k < 27; ++k)
            CHECK(std::abs(motion::numbersOf(back->frames[0])[k] - frames[0][k].get<double>()) < 0.1);
    }
}
