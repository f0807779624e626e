#include "motion/skeleton/clip_edit.hpp"

#include <doctest/doctest.h>

#include <cstring>

#include "core/random.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool sameBits(const Pose& a, const Pose& b) {
    return sameBits(a.position.x, b.position.x) && sameBits(a.position.y, b.position.y) &&
           sameBits(a.position.z, b.position.z) && sameBits(a.orientation.w, b.orientation.w) &&
           sameBits(a.orientation.x, b.orientation.x) && sameBits(a.orientation.y, b.orientation.y) &&
           sameBits(a.orientation.z, b.orientation.z);
}

bool sameBits(const Clip& a, const Clip& b) {
    bool same = sameBits(a.frame_time_s, b.frame_time_s) && a.skeleton.size() == b.skeleton.size() &&
                a.frames.size() == b.frames.size();
    for (std::size_t j = 0; same && j < a.skeleton.joints.size(); ++j) {
        const Joint& one = a.skeleton.joints[j];
        const Joint& other = b.skeleton.joints[j];
        same = one.name == other.name && one.parent == other.parent && sameBits(one.rest, other.rest) &&
               one.end_site.has_value() == other.end_site.has_value();
        if (same && one.end_site) same = sameBits(Pose{*one.end_site}, Pose{*other.end_site});
    }
    for (std::size_t f = 0; same && f < a.frames.size(); ++f)
        for (std::size_t j = 0; same && j < a.skeleton.joints.size(); ++j)
            same = sameBits(a.frames[f].joints[j], b.frames[f].joints[j]);
    return same;
}

Quat anyRotation(Random& random) {
    return glm::normalize(Quat(random.normal(), random.normal(), random.normal(), random.normal()));
}

Vec3 anyPoint(Random& random) {
    return {random.normal(), random.normal(), random.normal()};
}

/// Names as a list "name<parent"; every rest, end site and pose at random, so nothing is symmetric.
Clip anyClip(const std::vector<std::pair<std::string, int>>& joints, std::uint64_t seed, int frames = 5) {
    Random random(seed);
    Clip clip;
    clip.frame_time_s = 1.0 / 24.0;
    for (const auto& [name, parent] : joints)
        clip.skeleton.joints.push_back(
            {name, parent, {anyPoint(random), anyRotation(random)}, anyPoint(random)});
    for (int f = 0; f < frames; ++f) {
        LocalPose pose;
        for (std::size_t j = 0; j < joints.size(); ++j)
            pose.joints.push_back({anyPoint(random), anyRotation(random)});
        clip.frames.push_back(pose);
    }
    return clip;
}

/// The largest distance between where each joint (and its tip) of the image stands and where a mirror shows
/// the joint that `counterpart` names, over all frames and the rest pose, in units of the figure's size.
template <typename Counterpart>
double distanceFromMirror(const Clip& clip, const Clip& image, Counterpart counterpart) {
    double worst = 0.0;
    double size = 0.0;
    const auto compare = [&](const LocalPose& pose, const LocalPose& image_pose) {
        const auto world = worldPose(clip.skeleton, pose);
        const auto image_world = worldPose(image.skeleton, image_pose);
        for (int j = 0; j < clip.skeleton.size(); ++j) {
            const int k =
                image.skeleton.find(counterpart(clip.skeleton.joints[static_cast<std::size_t>(j)].name));
            REQUIRE(k >= 0);
            const auto apart = [&](const Vec3& p, const Vec3& q) {
                worst = std::max(worst, glm::length(Vec3(-p.x, p.y, p.z) - q));
                size = std::max(size, glm::length(p));
            };
            apart(world[static_cast<std::size_t>(j)].position,
                  image_world[static_cast<std::size_t>(k)].position);
            apart(tipPosition(clip.skeleton, world, j), tipPosition(image.skeleton, image_world, k));
            // An axis of the joint, seen in the mirror.
            const Vec3 axis = world[static_cast<std::size_t>(j)].orientation * Vec3(0.3, 0.4, -0.5);
            apart(axis, image_world[static_cast<std::size_t>(k)].orientation * Vec3(-0.3, 0.4, -0.5));
        }
    };
    compare(restPose(clip.skeleton), restPose(image.skeleton));
    for (std::size_t f = 0; f < clip.frames.size(); ++f) compare(clip.frames[f], image.frames[f]);
    return worst / size;
}

std::string partnerOf(const std::vector<std::string>& names, const std::string& name) {
    Skeleton skeleton;
    for (const std::string& n : names) skeleton.joints.push_back({n, skeleton.size() - 1, {}, std::nullopt});
    const auto partners = mirrorPartners(skeleton);
    return names[static_cast<std::size_t>(partners[static_cast<std::size_t>(skeleton.find(name))])];
}

}  // namespace

TEST_SUITE("motion/mirror") {
    TEST_CASE("joints of the two sides are paired by name in every scheme in use") {
        const std::vector<std::pair<std::string, std::string>> pairs{
            {"LeftArm", "RightArm"},
            {"mixamorig:LeftHandIndex1", "mixamorig:RightHandIndex1"},
            {"leftUpperArm", "rightUpperArm"},
            {"left_wrist", "right_wrist"},
            {"ElbowLeft", "ElbowRight"},
            {"LEFT_HAND", "RIGHT_HAND"},
            {"Bip01 L UpperArm", "Bip01 R UpperArm"},
            {"CC_Base_L_Thigh", "CC_Base_R_Thigh"},
            {"J_Bip_L_Hand", "J_Bip_R_Hand"},
            {"upper_arm.L", "upper_arm.R"},
            {"hand.l.001", "hand.r.001"},
            {"thigh_l", "thigh_r"},
            {"lhumerus", "rhumerus"},
            {"lShldr", "rShldr"},
            {"LThumb", "RThumb"},
            {"handL", "handR"},
            {"finger1-1.L", "finger1-1.R"}};
        std::vector<std::string> all{"Hips", "root", "RL_BoneRoot", "L5", "spine01", "upright", "lowerback"};
        const std::size_t middle = all.size();
        for (const auto& [left, right] : pairs) {
            all.push_back(left);
            all.push_back(right);
        }
        for (const auto& pair : pairs) {
            CAPTURE(pair.first);
            CHECK(partnerOf(all, pair.first) == pair.second);
            CHECK(partnerOf(all, pair.second) == pair.first);
        }
        for (std::size_t i = 0; i < middle; ++i) CHECK(partnerOf(all, all[i]) == all[i]);
    }

    TEST_CASE("names that only look like a pair are none") {
        CHECK(partnerOf({"root", "radius"}, "root") == "root");
        CHECK(partnerOf({"reft", "left", "right"}, "reft") == "reft");
        CHECK(partnerOf({"reft", "left", "right"}, "left") == "right");
        CHECK(partnerOf({"LeftArm", "rightArm"}, "LeftArm") == "LeftArm");
    }

    TEST_CASE("any figure and its image are mirror images, rest rotations and uneven bones included") {
        const std::vector<std::pair<std::string, int>> joints{
            {"Hips", -1},    {"Spine", 0},     {"LeftArm", 1},  {"LeftHand", 2},
            {"RightArm", 1}, {"RightHand", 4}, {"lhumerus", 1}, {"rhumerus", 1}};
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Clip clip = anyClip(joints, seed);
            const Clip image = mirrored(clip);
            const double apart = distanceFromMirror(clip, image, [](std::string name) {
                if (name.starts_with("Left")) return "Right" + name.substr(4);
                if (name.starts_with("Right")) return "Left" + name.substr(5);
                if (name == "lhumerus") return std::string("rhumerus");
                if (name == "rhumerus") return std::string("lhumerus");
                return name;
            });
            CHECK(apart < 1e-12);
            for (std::size_t j = 0; j < joints.size(); ++j)
                CHECK(image.skeleton.joints[j].name == joints[j].first);
            CHECK(sameBits(mirrored(image), clip));
            CHECK_FALSE(sameBits(image, clip));
        }
    }

    TEST_CASE("a figure with more joints on one side becomes one with more on the other") {
        const std::vector<std::pair<std::string, int>> joints{{"Hips", -1},    {"LeftArm", 0},
                                                              {"LeftHand", 1}, {"Left_Thumb", 2},
                                                              {"RightArm", 0}, {"sword.R", 4}};
        const Clip clip = anyClip(joints, 3);
        const Clip image = mirrored(clip);
        CHECK(distanceFromMirror(clip, image, [](const std::string& name) -> std::string {
                  if (name == "LeftArm") return "RightArm";
                  if (name == "RightArm") return "LeftArm";
                  if (name == "LeftHand") return "RightHand";
                  if (name == "Left_Thumb") return "Right_Thumb";
                  if (name == "sword.R") return "sword.L";
                  return name;
              }) < 1e-12);
        CHECK(image.skeleton.find("LeftHand") == -1);
        CHECK(sameBits(mirrored(image), clip));
    }

    TEST_CASE("where names do not tell, the humanoid bones do") {
        const std::vector<std::pair<std::string, int>> joints{{"b0", -1}, {"b1", 0}, {"b2", 1},
                                                              {"b3", 0},  {"b4", 3}, {"b5", 0}};
        HumanoidMap map;
        map[Bone::hips] = 0;
        map[Bone::leftUpperArm] = 1;
        map[Bone::leftLowerArm] = 2;
        map[Bone::rightUpperArm] = 3;
        map[Bone::rightLowerArm] = 4;
        map[Bone::head] = 5;
        const Clip clip = anyClip(joints, 4);
        const Clip image = mirrored(clip, map);
        CHECK(distanceFromMirror(clip, image, [](const std::string& name) -> std::string {
                  if (name == "b1") return "b3";
                  if (name == "b3") return "b1";
                  if (name == "b2") return "b4";
                  if (name == "b4") return "b2";
                  return name;
              }) < 1e-12);
        CHECK(sameBits(mirrored(image, map), clip));
    }

    TEST_CASE("every system's clip, mirrored, errs at the mirrored target as the clip does at its own") {
        for (const std::string& name : generatorNames()) {
            const auto system = makeGenerator(name, referenceHumanoid(), {});
            REQUIRE(system.has_value());
            for (const Vec3& target : drawTargets(4, 31)) {
                GeneratedClip made = (*system)->generate({"T", target, 9, {}});
                GeneratedClip image = made;
                image.clip = mirrored(made.clip);
                image.hand = opposite(made.hand);
                CHECK(sameBits(mirrored(image.clip), made.clip));
                for (const PointingRay ray : {PointingRay::eye_fingertip, PointingRay::index_finger,
                                              PointingRay::forearm, PointingRay::shoulder_hand})
                    CHECK(errorDeg(image, mirrored(target), ray) ==
                          doctest::Approx(errorDeg(made, target, ray)).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("the whole clip of a figure with two like sides is what mirroring its poses gives") {
        const auto system = makeGenerator("direct", referenceHumanoid(), {});
        REQUIRE(system.has_value());
        const Clip clip = (*system)->generate({"T", {0.8, 1.2, 1.7}, 2, {}}).clip;
        const Clip image = mirrored(clip);
        const auto partners = mirrorPartners(clip.skeleton);
        for (std::size_t f = 0; f < clip.frames.size(); f += 10) {
            const LocalPose pose = mirrored(clip.skeleton, partners, clip.frames[f]);
            for (std::size_t j = 0; j < pose.joints.size(); ++j) {
                CHECK(pose.joints[j].position == image.frames[f].joints[j].position);
                CHECK(pose.joints[j].orientation == image.frames[f].joints[j].orientation);
            }
        }
    }
}

TEST_SUITE("motion/clip_edit") {
    TEST_CASE("a trimmed clip has the frames asked for, and no others can be asked for") {
        const Clip clip = anyClip({{"a", -1}}, 8, 10);
        const auto part = trimmed(clip, 3, 6);
        REQUIRE(part.has_value());
        CHECK(part->frame_time_s == clip.frame_time_s);
        REQUIRE(part->frameCount() == 4);
        for (std::size_t f = 0; f < 4; ++f)
            CHECK(sameBits(part->frames[f].joints[0], clip.frames[f + 3].joints[0]));
        CHECK(sameBits(*trimmed(clip, 0, 9), clip));
        for (const auto& range : std::vector<std::pair<int, int>>{{-1, 5}, {0, 10}, {6, 5}, {10, 10}}) {
            CAPTURE(range.first);
            CHECK_FALSE(trimmed(clip, range.first, range.second).has_value());
        }
        CHECK(trimmed(clip, 2, 10).error().text().find("expected frames from 0 to 9") != std::string::npos);
    }

    TEST_CASE("a moved clip's joints all stand where the move takes them") {
        const Clip clip = anyClip({{"a", -1}, {"b", 0}, {"c", 1}}, 9);
        const Pose there{{1.0, -2.0, 0.5}, yawRotation(0.7)};
        const Clip out = moved(clip, there);
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            const auto before = worldPose(clip.skeleton, clip.frames[f]);
            const auto after = worldPose(out.skeleton, out.frames[f]);
            for (std::size_t j = 0; j < 3; ++j)
                CHECK(glm::length(transformPoint(there, before[j].position) - after[j].position) < 1e-12);
        }
    }
}
