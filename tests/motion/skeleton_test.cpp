#include "motion/skeleton/skeleton.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <string>

#include "core/random.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using motion::Bone;

TEST_SUITE("motion/skeleton") {
    TEST_CASE("A chain of two turned joints ends where the drawing says") {
        motion::Skeleton skeleton;
        skeleton.joints.push_back({"upper", -1, {{0, 1, 0}, no_rotation}, std::nullopt});
        skeleton.joints.push_back({"lower", 0, {{2, 0, 0}, no_rotation}, Vec3(3, 0, 0)});
        auto pose = motion::restPose(skeleton);
        const Quat quarter = glm::angleAxis(pi / 2, Vec3(0, 0, 1));
        pose.joints[0].orientation = quarter;  // 2 m along x now point up
        pose.joints[1].orientation = quarter;  // and the last 3 m back along -x
        const auto world = motion::worldPose(skeleton, pose);
        CHECK(glm::length(world[1].position - Vec3(0, 3, 0)) < 1e-12);
        CHECK(glm::length(motion::tipPosition(skeleton, world, 1) - Vec3(-3, 3, 0)) < 1e-12);
        CHECK(glm::length(motion::tipPosition(skeleton, world, 0) - Vec3(0, 1, 0)) < 1e-12);
    }

    TEST_CASE("No pose changes the length of a bone") {
        const auto& skeleton = motion::referenceHumanoid();
        Random random(5);
        auto pose = motion::restPose(skeleton);
        for (auto& joint : pose.joints)
            joint.orientation =
                glm::normalize(Quat(random.normal(), random.normal(), random.normal(), random.normal()));
        const auto world = motion::worldPose(skeleton, pose);
        for (std::size_t j = 1; j < world.size(); ++j) {
            const auto parent = static_cast<std::size_t>(skeleton.joints[j].parent);
            CHECK(glm::length(world[j].position - world[parent].position) ==
                  doctest::Approx(glm::length(skeleton.joints[j].rest.position)));
        }
    }

    TEST_CASE("Names lead to joints, and unknown names to none") {
        const auto& skeleton = motion::referenceHumanoid();
        CHECK(skeleton.find("leftHand") == static_cast<int>(Bone::leftHand));
        CHECK(skeleton.find("LeftHand") == -1);
    }
}

TEST_SUITE("motion/detect_humanoid") {
    TEST_CASE("The avatar's own names are recognised, every one") {
        const auto& skeleton = motion::referenceHumanoid();
        const auto map = motion::detectHumanoid(skeleton);
        CHECK(map.joint == motion::mapByVrmNames(skeleton).joint);
    }

    TEST_CASE("The naming schemes in use are recognised") {
        struct Scheme {
            const char* name;
            const char* hips;
            const char* thigh;
            const char* shin;
            const char* foot;
            const char* collar;
            const char* upper_arm;
            const char* forearm;
            const char* hand;
            const char* index;
            bool at_end;  // the side stands last
        };
        // "%" stands for the side.
        const Scheme schemes[] = {
            {"Mixamo", "mixamorig:Hips", "mixamorig:%UpLeg", "mixamorig:%Leg", "mixamorig:%Foot",
             "mixamorig:%Shoulder", "mixamorig:%Arm", "mixamorig:%ForeArm", "mixamorig:%Hand",
             "mixamorig:%HandIndex1", false},
            {"CMU", "Hips", "%UpLeg", "%Leg", "%Foot", "%Shoulder", "%Arm", "%ForeArm", "%Hand",
             "%HandIndex1", false},
            {"OptiTrack", "Hips", "%Hip", "%Knee", "%Ankle", "%Collar", "%Shoulder", "%Elbow", "%Wrist", "",
             false},
            {"iClone", "CC_Base_Hip", "CC_Base_%_Thigh", "CC_Base_%_Calf", "CC_Base_%_Foot",
             "CC_Base_%_Clavicle", "CC_Base_%_Upperarm", "CC_Base_%_Forearm", "CC_Base_%_Hand",
             "CC_Base_%_Index1", true},
            {"MakeHuman", "root", "upperleg01.%", "lowerleg01.%", "foot.%", "clavicle.%", "upperarm01.%",
             "lowerarm01.%", "wrist.%", "finger2-1.%", true},
            {"Biped", "Bip01 Pelvis", "Bip01 % Thigh", "Bip01 % Calf", "Bip01 % Foot", "Bip01 % Clavicle",
             "Bip01 % UpperArm", "Bip01 % Forearm", "Bip01 % Hand", "", true},
        };
        for (const Scheme& scheme : schemes) {
            INFO(std::string(scheme.name));
            motion::Skeleton skeleton;
            const auto add = [&](const std::string& name) {
                skeleton.joints.push_back({name, skeleton.size() - 1, {}, std::nullopt});
            };
            add(scheme.hips);
            const std::string sides[2] = {scheme.at_end ? "L" : "Left", scheme.at_end ? "R" : "Right"};
            const char* parts[] = {scheme.thigh,     scheme.shin,    scheme.foot, scheme.collar,
                                   scheme.upper_arm, scheme.forearm, scheme.hand, scheme.index};
            for (const std::string& side : sides)
                for (const char* part : parts) {
                    std::string name = part;
                    if (name.empty()) continue;
                    name.replace(name.find('%'), 1, side);
                    add(name);
                }
            add("Head");
            const auto map = motion::detectHumanoid(skeleton);
            const bool fingers = std::string(scheme.index).size() > 0;
            const int count = fingers ? 8 : 7;
            const Bone left[] = {Bone::leftUpperLeg, Bone::leftLowerLeg,     Bone::leftFoot,
                                 Bone::leftShoulder, Bone::leftUpperArm,     Bone::leftLowerArm,
                                 Bone::leftHand,     Bone::leftIndexProximal};
            CHECK(map[Bone::hips] == 0);
            for (int i = 0; i < count; ++i) {
                CHECK(map[left[i]] == 1 + i);
                CHECK(map[motion::mirroredBone(left[i])] == 1 + count + i);
            }
        }
    }

    TEST_CASE("The joints between hips and neck are shared out over the spine, the topmost last") {
        const auto chain = [](int spines) {
            motion::Skeleton skeleton;
            skeleton.joints.push_back({"Hips", -1, {}, std::nullopt});
            for (int i = 0; i < spines; ++i)
                skeleton.joints.push_back({"segment" + std::to_string(i), i, {}, std::nullopt});
            skeleton.joints.push_back({"Neck", spines, {}, std::nullopt});
            return motion::detectHumanoid(skeleton);
        };
        CHECK(chain(1)[Bone::spine] == 1);
        CHECK_FALSE(chain(1).has(Bone::chest));
        CHECK(chain(2)[Bone::chest] == 2);
        CHECK(chain(5)[Bone::spine] == 1);
        CHECK(chain(5)[Bone::chest] == 3);
        CHECK(chain(5)[Bone::upperChest] == 5);
    }
}
