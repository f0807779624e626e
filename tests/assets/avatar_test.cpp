#include "assets/avatar/avatar.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "motion/humanoid/hand_shapes.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/body_shape.hpp"
#include "paths.hpp"

using namespace deixis;
using assets::Avatar;
using motion::Bone;

namespace {

const std::filesystem::path avatar_file = deixis::tests::buildDir() / "share/deixis/avatar.glb";

const Avatar& avatar() {
    static const Avatar loaded = [] {
        auto result = assets::loadAvatar(avatar_file);
        if (!result) FAIL(result.error().text());
        return *result;
    }();
    return loaded;
}

/// Linear blend skinning, written from glTF 2.0 section 3.7.3.3.
std::vector<Vec3> skinned_file(const Avatar& a, const motion::LocalPose& pose) {
    const auto world = motion::worldPose(a.skeleton, pose);
    std::vector<Vec3> out;
    for (const auto& v : a.vertices) {
        Vec3 sum(0.0);
        for (std::size_t i = 0; i < 4; ++i)
            sum += static_cast<double>(v.weights[i]) *
                   transformPoint(world[v.joints[i]],
                                  transformPoint(a.joint_from_bind[v.joints[i]], Vec3(v.position)));
        out.push_back(sum);
    }
    return out;
}

std::vector<Vec3> restPositions(const Avatar& a) {
    std::vector<Vec3> out;
    for (const auto& v : a.vertices) out.emplace_back(v.position);
    return out;
}

double volume(const Avatar& a, const std::vector<Vec3>& p) {
    double six_times = 0.0;
    for (std::size_t t = 0; t < a.indices.size(); t += 3)
        six_times += glm::dot(p[a.indices[t]], glm::cross(p[a.indices[t + 1]], p[a.indices[t + 2]]));
    return six_times / 6.0;
}

double weightOf(const assets::SkinnedVertex& v, Bone bone) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        if (v.joints[i] == static_cast<std::uint16_t>(bone)) sum += static_cast<double>(v.weights[i]);
    return sum;
}

Vec3 tip(const Avatar& a, const std::vector<Pose>& world, Bone bone) {
    return motion::tipPosition(a.skeleton, world, static_cast<int>(bone));
}

}  // namespace

TEST_SUITE("assets/avatar") {
    TEST_CASE("the avatar has the reference skeleton, bone for bone") {
        const auto& expected = motion::referenceHumanoid();
        const auto& found = avatar().skeleton;
        REQUIRE(found.size() == 55);
        for (std::size_t j = 0; j < 55; ++j) {
            CAPTURE(expected.joints[j].name);
            CHECK(found.joints[j].name == expected.joints[j].name);
            CHECK(found.joints[j].parent == expected.joints[j].parent);
            CHECK(found.joints[j].rest.position == expected.joints[j].rest.position);
            CHECK(found.joints[j].rest.orientation == no_rotation);
            REQUIRE(found.joints[j].end_site.has_value() == expected.joints[j].end_site.has_value());
            if (expected.joints[j].end_site) CHECK(*found.joints[j].end_site == *expected.joints[j].end_site);
            CHECK(avatar().humanoid.joint[j] == static_cast<int>(j));
        }
    }

    TEST_CASE("the rest pose bends no vertex") {
        const Avatar& a = avatar();
        const auto posed = skinned_file(a, motion::restPose(a.skeleton));
        double worst = 0.0;
        for (std::size_t v = 0; v < posed.size(); ++v)
            worst = std::max(worst, glm::length(posed[v] - Vec3(a.vertices[v].position)));
        CHECK(worst < 1e-6);
    }

    TEST_CASE("it is 1.75 m tall, stands on the floor and has 10,000 to 60,000 triangles") {
        float low = 1.0F, high = 0.0F;
        for (const auto& v : avatar().vertices) {
            low = std::min(low, v.position.y);
            high = std::max(high, v.position.y);
        }
        CHECK(low == doctest::Approx(0.0).epsilon(0.003));
        CHECK(high - low == doctest::Approx(1.75).epsilon(0.01 / 1.75));
        CHECK(avatar().indices.size() / 3 >= 10000);
        CHECK(avatar().indices.size() / 3 <= 60000);
    }

    TEST_CASE("weights are up to four, positive and sum to one") {
        for (const auto& v : avatar().vertices) {
            float sum = 0.0F;
            std::set<std::uint16_t> used;
            for (std::size_t i = 0; i < 4; ++i) {
                REQUIRE(v.weights[i] >= 0.0F);
                REQUIRE(v.joints[i] < 55);
                if (v.weights[i] > 0.0F) REQUIRE(used.insert(v.joints[i]).second);
                sum += v.weights[i];
            }
            REQUIRE(std::abs(sum - 1.0F) < 1e-6F);
        }
    }

    TEST_CASE("the surface is closed: every edge has two triangles, which run through it in opposite ways") {
        const Avatar& a = avatar();
        // Vertices are doubled where colours meet, so that edges are told by their ends' places. Body, eyes
        // and lids are separate closed surfaces that share no place.
        std::map<std::tuple<float, float, float>, std::uint32_t> place_of;
        std::vector<std::uint32_t> place;
        for (const auto& v : a.vertices) {
            const auto next = static_cast<std::uint32_t>(place_of.size());
            place.push_back(
                place_of.try_emplace({v.position.x, v.position.y, v.position.z}, next).first->second);
        }
        std::map<std::array<std::uint32_t, 2>, int> edges;
        for (std::size_t t = 0; t < a.indices.size(); t += 3)
            for (std::size_t i = 0; i < 3; ++i)
                ++edges[{place[a.indices[t + i]], place[a.indices[t + (i + 1) % 3]]}];
        int bad = 0;
        for (const auto& [edge, count] : edges) {
            const auto back = edges.find({edge[1], edge[0]});
            bad += count != 1 || back == edges.end() || back->second != 1 || edge[0] == edge[1] ? 1 : 0;
        }
        CHECK(bad == 0);
    }

    TEST_CASE("normals have unit length and point outwards") {
        const Avatar& a = avatar();
        CHECK(volume(a, restPositions(a)) >
              0.04);  // triangles face outwards; a person has some 0.07 cubic metres
        CHECK(volume(a, restPositions(a)) < 0.10);
        for (const auto& v : a.vertices) REQUIRE(std::abs(glm::length(v.normal) - 1.0F) < 1e-4F);
        std::size_t against = 0;
        for (std::size_t t = 0; t < a.indices.size(); t += 3) {
            const auto& p = a.vertices[a.indices[t]];
            const auto& q = a.vertices[a.indices[t + 1]];
            const auto& r = a.vertices[a.indices[t + 2]];
            const glm::vec3 face = glm::cross(q.position - p.position, r.position - p.position);
            against += glm::dot(face, p.normal + q.normal + r.normal) <= 0.0F ? 1 : 0;
        }
        CHECK(static_cast<double>(against) < 0.002 * static_cast<double>(a.indices.size() / 3));
    }

    TEST_CASE("fingers are moved by their own bones alone, and the trunk by no arm") {
        const Avatar& a = avatar();
        const auto world = motion::worldPose(a.skeleton, motion::restPose(a.skeleton));
        const std::array<Bone, 5> distal{Bone::leftThumbDistal, Bone::leftIndexDistal, Bone::leftMiddleDistal,
                                         Bone::leftRingDistal, Bone::leftLittleDistal};
        for (const auto& v : a.vertices) {
            const Vec3 p(v.position);
            for (const Bone own : distal) {
                if (glm::length(p - tip(a, world, own)) > 0.012) continue;
                for (const Bone other : distal)
                    REQUIRE(std::abs(weightOf(v, other) - (other == own ? 1.0 : 0.0)) < 0.005);
            }
            if (std::abs(p.x) < 0.09)
                for (const Bone arm : {Bone::leftUpperArm, Bone::rightUpperArm})
                    REQUIRE(weightOf(v, arm) < 0.05);
            if (p.x < 0.65)
                for (const Bone hand : {Bone::leftHand, Bone::leftIndexProximal})
                    REQUIRE(weightOf(v, hand) == 0.0);
        }
    }

    TEST_CASE("both sides of the skin weights mirror each other") {
        const Avatar& a = avatar();
        double left = 0.0, right = 0.0;
        for (const auto& v : a.vertices) {
            left += weightOf(v, Bone::leftUpperArm);
            right += weightOf(v, Bone::rightUpperArm);
        }
        CHECK(left > 100.0);
        CHECK(left / right == doctest::Approx(1.0).epsilon(0.05));
    }

    TEST_CASE("with the arms down, bent or pointing the body keeps its volume") {
        const Avatar& a = avatar();
        const double at_rest = volume(a, restPositions(a));
        motion::LocalPose relaxed = motion::relaxedPose(a.skeleton);
        CHECK(volume(a, skinned_file(a, relaxed)) == doctest::Approx(at_rest).epsilon(0.05));
        motion::LocalPose bent = motion::restPose(a.skeleton);
        bent.joints[static_cast<std::size_t>(Bone::leftLowerArm)].orientation =
            glm::angleAxis(radiansFromDegrees(-120), Vec3(0, 1, 0));
        bent.joints[static_cast<std::size_t>(Bone::leftLowerLeg)].orientation =
            glm::angleAxis(radiansFromDegrees(90), Vec3(1, 0, 0));
        CHECK(volume(a, skinned_file(a, bent)) == doctest::Approx(at_rest).epsilon(0.05));
    }

    TEST_CASE("the pointing hand stretches the index and closes the other fingers, on either side") {
        const Avatar& a = avatar();
        for (const auto side : {motion::Side::left, motion::Side::right}) {
            const auto bone = [&](Bone b) {
                return side == motion::Side::left ? b : motion::mirroredBone(b);
            };
            motion::LocalPose pose = motion::restPose(a.skeleton);
            motion::applyPointingHand(pose, side, 1.0);
            const auto world = motion::worldPose(a.skeleton, pose);
            const Vec3 wrist = world[static_cast<std::size_t>(bone(Bone::leftHand))].position;
            CHECK(glm::length(tip(a, world, bone(Bone::leftIndexDistal)) - wrist) > 0.18);
            for (const Bone b : {Bone::leftMiddleDistal, Bone::leftRingDistal, Bone::leftLittleDistal}) {
                CHECK(glm::length(tip(a, world, bone(b)) - wrist) < 0.10);
                CHECK(tip(a, world, bone(b)).y < 1.38);  // on the palm's side of the hand, which faces down
            }
            // The pointing finger is the foremost part of the hand's surface.
            const auto posed = skinned_file(a, pose);
            const double sign = side == motion::Side::left ? 1.0 : -1.0;
            double index_reach = 0.0, other_reach = 0.0;
            for (std::size_t v = 0; v < posed.size(); ++v) {
                const bool index = weightOf(a.vertices[v], bone(Bone::leftIndexDistal)) > 0.5;
                double& reach = index ? index_reach : other_reach;
                reach = std::max(reach, sign * posed[v].x);
            }
            CHECK(index_reach > 0.905);
            CHECK(index_reach < 0.92);
            CHECK(other_reach < 0.90);
        }
    }

    TEST_CASE("a relaxed hand is that of the relaxed pose, and the other joints are left alone") {
        const auto& skeleton = motion::referenceHumanoid();
        const motion::LocalPose relaxed = motion::relaxedPose(skeleton);
        motion::LocalPose pose = relaxed;
        motion::applyPointingHand(pose, motion::Side::right, 0.0);
        for (std::size_t j = 0; j < 55; ++j)
            CHECK(std::abs(glm::dot(pose.joints[j].orientation, relaxed.joints[j].orientation)) >
                  1.0 - 1e-12);
        motion::applyPointingHand(pose, motion::Side::right, 1.0);
        for (std::size_t j = 0; j <= static_cast<std::size_t>(Bone::leftLittleDistal); ++j)
            CHECK(pose.joints[j].orientation == relaxed.joints[j].orientation);
    }

    TEST_CASE("eyes turn in their lids: the iris moves with the eye joint, the face does not") {
        const Avatar& a = avatar();
        motion::LocalPose pose = motion::restPose(a.skeleton);
        pose.joints[static_cast<std::size_t>(Bone::leftEye)].orientation =
            yawRotation(radiansFromDegrees(20));
        const auto posed = skinned_file(a, pose);
        int moved = 0;
        for (std::size_t v = 0; v < posed.size(); ++v) {
            const double by = glm::length(posed[v] - Vec3(a.vertices[v].position));
            if (weightOf(a.vertices[v], Bone::leftEye) == 0.0) {
                REQUIRE(by < 1e-6);
            } else if (by > 0.003) {
                ++moved;
            }
        }
        CHECK(moved > 100);
    }

    TEST_CASE("the tool makes the same bytes twice, and the hash is that of the file") {
        const auto again = deixis::tests::buildDir() / "avatar_again.glb";
        const std::string command =
            std::string("\"") + DEIXIS_MAKE_AVATAR + "\" \"" + again.string() + "\" > /dev/null";
        REQUIRE(std::system(command.c_str()) == 0);
        const auto first = readFile(avatar_file);
        const auto second = readFile(again);
        REQUIRE(first.has_value());
        REQUIRE(second.has_value());
        CHECK(*first == *second);
        CHECK(avatar().content_hash == sha256Hex(*first));
        std::filesystem::remove(again);
    }

    TEST_CASE("the body's capsules hold the figure at ease, and are no broader") {
        const Avatar& a = avatar();
        const auto idle = motion::worldPose(a.skeleton, motion::relaxedPose(a.skeleton));
        const std::vector<motion::Capsule> shape = motion::bodyShape(a.skeleton, a.humanoid, idle);
        const std::vector<Vec3> skin = skinned_file(a, motion::relaxedPose(a.skeleton));
        int outside = 0;
        Vec3 low(1.0), high(-1.0), shape_low(1.0), shape_high(-1.0);
        for (const Vec3& p : skin) {
            double nearest = 1.0;
            for (const motion::Capsule& part : shape)
                nearest = std::min(nearest, motion::capsuleDistance({p, p, 0.0}, part));
            outside += nearest > 0.02;
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        CHECK(outside < static_cast<int>(0.03 * static_cast<double>(skin.size())));
        for (const motion::Capsule& part : shape)
            for (const Vec3& end : {part.from, part.to}) {
                shape_low = glm::min(shape_low, end - part.radius_m);
                shape_high = glm::max(shape_high, end + part.radius_m);
            }
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(std::abs(shape_low[axis] - low[axis]) < 0.05);
            CHECK(std::abs(shape_high[axis] - high[axis]) < 0.05);
        }
    }
}
