#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "assets/joints/clip_import.hpp"
#include "assets/joints/joint_positions.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "text.hpp"

using namespace deixis;
using assets::ImportedClip;
using deixis::tests::contains;
using motion::Bone;

namespace {

using Pose10 = std::array<Vec3, 10>;

/// Spine, neck, nose, top, left and right shoulder, elbow, wrist of somebody who faces +z, y up,
/// right-handed: the right arm out to the side with the forearm up, the left arm hanging.
Pose10 person() {
    return {{{0, 0, 0},
             {0, 0.26, 0},
             {0, 0.40, 0.10},
             {0, 0.52, 0.02},
             {0.22, 0.26, 0},
             {0.22, -0.10, 0},
             {0.22, -0.43, 0},
             {-0.22, 0.26, 0},
             {-0.58, 0.26, 0},
             {-0.58, 0.59, 0}}};
}

/// Each joint with its coordinates times `sign`.
Pose10 flipped(const Vec3& sign) {
    Pose10 pose = person();
    for (Vec3& p : pose) p *= sign;
    return pose;
}

std::string numbers(const Pose10& pose, bool nested = false) {
    std::string out = "[";
    for (const Vec3& p : pose) {
        const std::string three = fmt::format("{},{},{}", p.x, p.y, p.z);
        out += (out.size() > 1 ? "," : "") + (nested ? "[" + three + "]" : three);
    }
    return out + "]";
}

/// The directions of the nine bones, as the toolkit's model makes them (data_utils.py, dir_vec_pairs).
std::string directions(const Pose10& pose) {
    constexpr std::array<std::array<std::size_t, 2>, 9> pairs{
        {{0, 1}, {1, 2}, {2, 3}, {1, 4}, {4, 5}, {5, 6}, {1, 7}, {7, 8}, {8, 9}}};
    std::string out = "[";
    for (const auto& [from, to] : pairs) {
        const Vec3 d = glm::normalize(pose[to] - pose[from]);
        out += fmt::format("{}{},{},{}", out.size() > 1 ? "," : "", d.x, d.y, d.z);
    }
    return out + "]";
}

std::string frames(const std::string& frame, int count = 3) {
    std::string out = "[";
    for (int i = 0; i < count; ++i) out += (i > 0 ? "," : "") + frame;
    return out + "]";
}

ImportedClip parsed(const std::string& text, const assets::ImportOptions& options = {}) {
    auto clip = assets::parseSgToolkitJson(text, "g.json", options);
    REQUIRE_MESSAGE(clip.has_value(), (clip ? "" : clip.error().text()));
    return std::move(*clip);
}

std::string errorOf(const std::string& text, const assets::ImportOptions& options = {}) {
    const auto clip = assets::parseSgToolkitJson(text, "g.json", options);
    REQUIRE_FALSE(clip.has_value());
    return clip.error().text();
}

Vec3 at(const motion::Clip& clip, Bone bone) {
    return motion::worldPose(clip.skeleton, clip.frames[1])[static_cast<std::size_t>(bone)].position;
}

void checkPerson(const ImportedClip& found) {
    const auto along = [&](Bone from, Bone to) {
        return glm::normalize(at(found.clip, to) - at(found.clip, from));
    };
    CHECK(glm::length(along(Bone::rightUpperArm, Bone::rightLowerArm) - Vec3(-1, 0, 0)) < 1e-6);
    CHECK(glm::length(along(Bone::rightLowerArm, Bone::rightHand) - Vec3(0, 1, 0)) < 1e-6);
    CHECK(glm::length(along(Bone::leftUpperArm, Bone::leftHand) - Vec3(0, -1, 0)) < 1e-6);
    CHECK(glm::length(along(Bone::spine, Bone::chest) - Vec3(0, 1, 0)) < 0.15);
    // The legs stand as at rest.
    const auto rest =
        motion::worldPose(motion::referenceHumanoid(), motion::restPose(motion::referenceHumanoid()));
    for (const Bone bone : {Bone::hips, Bone::leftLowerLeg, Bone::rightFoot, Bone::leftToes})
        CHECK(glm::length(at(found.clip, bone) - rest[static_cast<std::size_t>(bone)].position) < 1e-9);
}

}  // namespace

TEST_SUITE("assets/sgtoolkit") {
    TEST_CASE("Positions and directions of the ten joints move the upper body at 15 fps") {
        for (const std::string& text :
             {frames(numbers(person())), frames(numbers(person(), true)), frames(directions(person())),
              "{\"output-data\": " + frames(numbers(person())) + "}",
              "{\"name\": \"wave\", \"motion\": " + frames(directions(person())) + "}"}) {
            const ImportedClip found = parsed(text);
            checkPerson(found);
            CHECK(found.rate.fps == 15.0);
            CHECK(found.clip.frameCount() == 3);
            CHECK(found.format == "SGToolkit joint positions");
        }
    }

    TEST_CASE("The window's left-handed coordinates and the model's, whose y is down, give the same person") {
        // avatar.js: y up, facing +z, left at -x.
        const ImportedClip window = parsed(frames(numbers(flipped({-1, 1, 1}))));
        checkPerson(window);
        CHECK(contains(window.remarks.front(), "left-handed"));
        // The model: the same with y inverted.
        const ImportedClip model = parsed(frames(directions(flipped({-1, -1, 1}))));
        checkPerson(model);
        CHECK(model.up.axis == assets::UpAxis::minus_y);
        CHECK(model.remarks.size() == 1);
    }

    TEST_CASE("Of several gestures one is chosen by name or number") {
        const std::string two = "[{\"name\": \"rest\", \"motion\": " + frames(numbers(person()), 2) +
                                "}, {\"name\": \"wave\", \"motion\": " + frames(numbers(person()), 4) + "}]";
        assets::ImportOptions options;
        CHECK(contains(errorOf(two), "has 2 gestures: rest, wave; expected one to be named"));
        options.animation = "wave";
        CHECK(parsed(two, options).clip.frameCount() == 4);
        options.animation = "0";
        CHECK(parsed(two, options).clip.frameCount() == 2);
        options.animation = "clap";
        CHECK(contains(errorOf(two, options), "no gesture 'clap', only: rest, wave"));
    }

    TEST_CASE("A lean and a turn are those of the chest; the whole faces +z on the mean") {
        const Quat turn = yawRotation(0.7);
        Pose10 pose = person();
        for (Vec3& p : pose) p = turn * p;
        checkPerson(parsed(frames(numbers(pose))));
    }

    TEST_CASE("Each fault is named with its frame") {
        CHECK(contains(errorOf("{"), "g.json: is not JSON: parse error at line 1"));
        CHECK(contains(errorOf("[]"), "found no frames"));
        CHECK(contains(errorOf("[3]"), "g.json: frame 0: found something other than numbers"));
        CHECK(contains(errorOf("[[1,2,3]]"), "g.json: frame 0: found 3 numbers, expected frames of 30"));
        CHECK(contains(errorOf("[" + numbers(person()) + ",[1]]"), "frame 1: found 1 numbers"));
        CHECK(contains(errorOf("[[\"a\"]]"), "something other than numbers"));
        CHECK(contains(errorOf("[[1e999]]"), "is not JSON"));
        CHECK(contains(errorOf(frames(numbers(Pose10{}))), "has joints of the trunk in one place"));
        std::string still = directions(person());
        still.replace(1, still.find(",", still.find(",", still.find(",") + 1) + 1) - 1, "0,0,0");
        CHECK(contains(errorOf(frames(still)), "found no direction for bone 0"));
        std::string deep(100000, '[');
        CHECK(contains(errorOf(deep), "is not JSON"));
    }
}
