// Figures under the names of the schemes in use, and under no names at all.
#include "motion/humanoid/mapping.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

using namespace deixis;
using motion::Bone;
using motion::FoundBy;

namespace {

using Names = std::map<Bone, std::string>;

/// The avatar with the named bones only, under these names; the figure of the avatar's bones stays.
struct Figure {
    motion::Skeleton skeleton;
    motion::HumanoidMap truth;
};
Figure figureOf(const Names& names) {
    const auto& avatar = motion::referenceHumanoid();
    const auto world = motion::worldPose(avatar, motion::restPose(avatar));
    Figure figure;
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        const auto bone = static_cast<Bone>(b);
        if (!names.contains(bone)) continue;
        auto above = motion::parentBone(bone);
        while (above && !figure.truth.has(*above)) above = motion::parentBone(*above);
        motion::Joint joint;
        joint.name = names.at(bone);
        joint.parent = above ? figure.truth[*above] : -1;
        joint.rest.position =
            world[b].position - (above ? world[static_cast<std::size_t>(*above)].position : Vec3(0.0));
        joint.end_site = avatar.joints[b].end_site;
        figure.truth[bone] = figure.skeleton.size();
        figure.skeleton.joints.push_back(joint);
    }
    return figure;
}

/// "upperArm=%Arm index=%HandIndex1 ...": bones of both sides without "left", % for the side as written in
/// `left` and `right`, _ for a blank.
Names namesOf(const std::string& text, const std::string& left, const std::string& right) {
    Names names;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const auto end = std::min(text.find(' ', begin), text.size());
        const std::string row = text.substr(begin, end - begin);
        begin = end + 1;
        const auto equals = row.find('=');
        const std::string bone = row.substr(0, equals);
        const auto named = [&](const std::string& side) {
            std::string name;
            for (const char c : row.substr(equals + 1))
                name += c == '%' ? side : c == '~' ? " " : std::string(1, c);
            return name;
        };
        if (const auto middle = motion::boneFromName(bone)) {
            names[*middle] = named("");
            continue;
        }
        const auto on_left = motion::boneFromName("left" + bone);
        REQUIRE_MESSAGE(on_left.has_value(), bone);
        names[*on_left] = named(left);
        names[motion::mirroredBone(*on_left)] = named(right);
    }
    return names;
}

struct Case {
    const char* scheme;
    const char* left;
    const char* right;
    const char* names;
};

// As files of each kind name them. Sources: VRM 1.0 specification; Unity's HumanBodyBones; mixamo.com rigs;
// CMU BVH files by cgspeed; Motive and Arena exports; MVN's segment list; MakeHuman's default rig; Rokoko
// Studio's Newton; Unreal's mannequin; Character Creator; 3ds Max Biped.
const Case cases[] = {
    {"VRM", "left", "right",
     "hips=hips spine=spine chest=chest upperChest=upperChest neck=neck head=head UpperLeg=%UpperLeg "
     "LowerLeg=%LowerLeg Foot=%Foot Toes=%Toes Shoulder=%Shoulder UpperArm=%UpperArm LowerArm=%LowerArm "
     "Hand=%Hand ThumbMetacarpal=%ThumbProximal ThumbProximal=%ThumbIntermediate ThumbDistal=%ThumbDistal "
     "IndexProximal=%IndexProximal IndexIntermediate=%IndexIntermediate IndexDistal=%IndexDistal"},
    {"Unity", "Left", "Right",
     "hips=Hips spine=Spine chest=Chest neck=Neck head=Head UpperLeg=%UpperLeg LowerLeg=%LowerLeg Foot=%Foot "
     "Toes=%Toes Shoulder=%Shoulder UpperArm=%UpperArm LowerArm=%LowerArm Hand=%Hand "
     "ThumbMetacarpal=%~Thumb~Proximal IndexProximal=%~Index~Proximal IndexDistal=%~Index~Distal"},
    {"Mixamo", "Left", "Right",
     "hips=mixamorig:Hips spine=mixamorig:Spine chest=mixamorig:Spine1 upperChest=mixamorig:Spine2 "
     "neck=mixamorig:Neck head=mixamorig:Head UpperLeg=mixamorig:%UpLeg LowerLeg=mixamorig:%Leg "
     "Foot=mixamorig:%Foot Toes=mixamorig:%ToeBase Shoulder=mixamorig:%Shoulder UpperArm=mixamorig:%Arm "
     "LowerArm=mixamorig:%ForeArm Hand=mixamorig:%Hand IndexProximal=mixamorig:%HandIndex1 "
     "LittleDistal=mixamorig:%HandPinky3"},
    {"Mixamo", "Left", "Right",
     "hips=mixamorig1_Hips spine=mixamorig1_Spine neck=mixamorig1_Neck head=mixamorig1_Head "
     "UpperLeg=mixamorig1_%UpLeg LowerLeg=mixamorig1_%Leg Foot=mixamorig1_%Foot "
     "Shoulder=mixamorig1_%Shoulder UpperArm=mixamorig1_%Arm LowerArm=mixamorig1_%ForeArm "
     "Hand=mixamorig1_%Hand RingIntermediate=mixamorig1_%HandRing2"},
    {"CMU/cgspeed", "Left", "Right",
     "hips=Hips spine=LowerBack chest=Spine upperChest=Spine1 neck=Neck head=Head UpperLeg=%UpLeg "
     "LowerLeg=%Leg Foot=%Foot Toes=%ToeBase Shoulder=%Shoulder UpperArm=%Arm LowerArm=%ForeArm Hand=%Hand "
     "IndexProximal=%HandIndex1"},
    {"OptiTrack", "Left", "Right",
     "hips=Hips spine=Chest neck=Neck head=Head UpperLeg=%Hip LowerLeg=%Knee Foot=%Ankle Shoulder=%Collar "
     "UpperArm=%Shoulder LowerArm=%Elbow Hand=%Wrist"},
    {"OptiTrack", "L", "R",
     "hips=Skeleton~1_Hip spine=Skeleton~1_Ab chest=Skeleton~1_Chest neck=Skeleton~1_Neck "
     "head=Skeleton~1_Head UpperLeg=Skeleton~1_%Thigh LowerLeg=Skeleton~1_%Shin Foot=Skeleton~1_%Foot "
     "Toes=Skeleton~1_%Toe Shoulder=Skeleton~1_%Shoulder UpperArm=Skeleton~1_%UArm "
     "LowerArm=Skeleton~1_%FArm Hand=Skeleton~1_%Hand IndexProximal=Skeleton~1_%Index1"},
    {"Xsens", "Left", "Right",
     "hips=Pelvis spine=L5 chest=T12 upperChest=T8 neck=Neck head=Head UpperLeg=%UpperLeg LowerLeg=%LowerLeg "
     "Foot=%Foot Toes=%Toe Shoulder=%Shoulder UpperArm=%UpperArm LowerArm=%ForeArm Hand=%Hand "
     "ThumbMetacarpal=%FirstMC ThumbProximal=%FirstPP IndexProximal=%SecondPP IndexDistal=%SecondDP"},
    {"Xsens", "Left", "Right",
     "hips=Hips spine=Chest chest=Chest3 upperChest=Chest4 neck=Neck head=Head UpperLeg=%Hip LowerLeg=%Knee "
     "Foot=%Ankle Toes=%Toe Shoulder=%Collar UpperArm=%Shoulder LowerArm=%Elbow Hand=%Wrist"},
    {"MakeHuman", "L", "R",
     "hips=root spine=spine05 chest=spine03 upperChest=spine01 neck=neck01 head=head UpperLeg=upperleg01.% "
     "LowerLeg=lowerleg01.% Foot=foot.% Toes=toe3-1.% Shoulder=clavicle.% UpperArm=upperarm01.% "
     "LowerArm=lowerarm01.% Hand=wrist.% ThumbMetacarpal=finger1-1.% IndexProximal=finger2-1.% "
     "LittleDistal=finger5-3.%"},
    {"Rokoko", "Left", "Right",
     "hips=Hips spine=Spine1 chest=Spine3 upperChest=Spine4 neck=Neck head=Head UpperLeg=%Thigh "
     "LowerLeg=%Shin Foot=%Foot Toes=%Toe Shoulder=%Shoulder UpperArm=%Arm LowerArm=%ForeArm Hand=%Hand "
     "ThumbMetacarpal=%Finger1Metacarpal IndexProximal=%Finger2Proximal IndexIntermediate=%Finger2Medial"},
    {"UE", "l", "r",
     "hips=pelvis spine=spine_01 chest=spine_02 upperChest=spine_03 neck=neck_01 head=head UpperLeg=thigh_% "
     "LowerLeg=calf_% Foot=foot_% Toes=ball_% Shoulder=clavicle_% UpperArm=upperarm_% LowerArm=lowerarm_% "
     "Hand=hand_% ThumbMetacarpal=thumb_01_% IndexProximal=index_01_% LittleDistal=pinky_03_%"},
    {"iClone", "L", "R",
     "hips=CC_Base_Hip spine=CC_Base_Waist chest=CC_Base_Spine01 upperChest=CC_Base_Spine02 "
     "neck=CC_Base_NeckTwist01 head=CC_Base_Head UpperLeg=CC_Base_%_Thigh LowerLeg=CC_Base_%_Calf "
     "Foot=CC_Base_%_Foot Toes=CC_Base_%_ToeBase Shoulder=CC_Base_%_Clavicle UpperArm=CC_Base_%_Upperarm "
     "LowerArm=CC_Base_%_Forearm Hand=CC_Base_%_Hand MiddleProximal=CC_Base_%_Mid1"},
    {"Biped", "L", "R",
     "hips=Bip001~Pelvis spine=Bip001~Spine chest=Bip001~Spine1 neck=Bip001~Neck head=Bip001~Head "
     "UpperLeg=Bip001~%~Thigh LowerLeg=Bip001~%~Calf Foot=Bip001~%~Foot Toes=Bip001~%~Toe0 "
     "Shoulder=Bip001~%~Clavicle UpperArm=Bip001~%~UpperArm LowerArm=Bip001~%~Forearm Hand=Bip001~%~Hand "
     "ThumbMetacarpal=Bip001~%~Finger0 IndexProximal=Bip001~%~Finger1 IndexIntermediate=Bip001~%~Finger11"},
};

/// Names that say nothing.
Figure nameless(std::uint64_t seed) {
    Names names;
    Random random(seed);
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        names[static_cast<Bone>(b)] = "node" + std::to_string(b) + "x" + std::to_string(random.below(1000));
    return figureOf(names);
}

void turn(motion::Skeleton& skeleton, const Quat& by, double scale) {
    for (auto& joint : skeleton.joints) {
        joint.rest.position = scale * (by * joint.rest.position);
        if (joint.end_site) joint.end_site = scale * (by * *joint.end_site);
    }
}

}  // namespace

TEST_SUITE("motion/humanoid_mapping") {
    TEST_CASE("Every naming scheme is recognised, and every bone it names is found") {
        for (const Case& c : cases) {
            CAPTURE(std::string(c.names).substr(0, 60));
            const Names names = namesOf(c.names, c.left, c.right);
            const Figure figure = figureOf(names);
            const auto mapping = motion::mapHumanoid(figure.skeleton);
            CHECK(mapping.scheme == c.scheme);
            CHECK(mapping.remarks.empty());
            for (const auto& named : names) {
                const Bone bone = named.first;
                CAPTURE(named.second);
                CHECK(mapping.map[bone] == figure.truth[bone]);
                const bool in_spine = bone >= Bone::spine && bone <= Bone::upperChest;
                if (!in_spine) CHECK(mapping.foundBy(bone) == FoundBy::scheme);
            }
            for (const Bone bone : mapping.missing()) CHECK_FALSE(names.contains(bone));
        }
    }

    TEST_CASE("A mirrored figure has the mirrored map") {
        for (const Case& c : cases) {
            const Figure figure = figureOf(namesOf(c.names, c.left, c.right));
            const Figure mirrored = figureOf(namesOf(c.names, c.right, c.left));
            const auto map = motion::detectHumanoid(figure.skeleton);
            const auto other = motion::detectHumanoid(mirrored.skeleton);
            for (std::size_t b = 0; b < motion::bone_count; ++b)
                CHECK(map.joint[b] == other[motion::mirroredBone(static_cast<Bone>(b))]);
        }
    }

    TEST_CASE("Rigs of no scheme are mapped by the words of their names") {
        const Case rigs[] = {
            {"", "L", "R",
             "hips=Hips spine=Abdomen chest=Torso upperChest=Chest neck=Neck head=Head UpperLeg=UpperLeg.% "
             "LowerLeg=LowerLeg.% Foot=Foot.% Shoulder=Shoulder.% UpperArm=UpperArm.% LowerArm=LowerArm.% "
             "Hand=Hand.% IndexProximal=Index1.% IndexIntermediate=Index2.%"},
            {"", "l", "r",
             "hips=hip spine=abdomenLower chest=chestLower neck=neckLower head=head UpperLeg=%ThighBend "
             "LowerLeg=%Shin Foot=%Foot Toes=%Toe Shoulder=%Collar UpperArm=%ShldrBend LowerArm=%ForearmBend "
             "Hand=%Hand IndexProximal=%Index1"},
            {"", "Left", "Right",
             "hips=pelvis spine=body head=head UpperLeg=%Leg LowerLeg=%Knee Foot=%Ankle UpperArm=%Shoulder "
             "LowerArm=%Arm Hand=%Hand"},
            {"", "L", "R",
             "hips=hips spine=DEF-spine neck=neck head=head UpperLeg=DEF-thigh.% LowerLeg=DEF-shin.% "
             "Foot=DEF-foot.% Toes=DEF-toe.% Shoulder=DEF-shoulder.% UpperArm=DEF-upper_arm.% "
             "LowerArm=DEF-forearm.% Hand=DEF-hand.% IndexProximal=DEF-f_index.01.%"},
        };
        for (const Case& c : rigs) {
            const Names names = namesOf(c.names, c.left, c.right);
            const Figure figure = figureOf(names);
            const auto mapping = motion::mapHumanoid(figure.skeleton);
            CHECK(mapping.scheme == "by name and topology");
            for (const auto& named : names) {
                const Bone bone = named.first;
                CAPTURE(named.second);
                CHECK(mapping.map[bone] == figure.truth[bone]);
            }
        }
    }

    TEST_CASE("A figure whose names say nothing is mapped by its shape, in any size and either up axis") {
        const Quat z_up = glm::angleAxis(pi / 2, Vec3(1, 0, 0));
        for (const std::uint64_t seed : {1U, 2U, 3U})
            for (const bool upright : {true, false}) {
                Figure figure = nameless(seed);
                turn(figure.skeleton, upright ? no_rotation : z_up, seed == 1 ? 1.0 : 39.37);
                const auto mapping = motion::mapHumanoid(figure.skeleton);
                REQUIRE_FALSE(mapping.remarks.empty());
                CHECK(mapping.remarks[0].find("shape") != std::string::npos);
                for (std::size_t b = 0; b < motion::bone_count; ++b) {
                    const auto bone = static_cast<Bone>(b);
                    CAPTURE(std::string(motion::boneName(bone)));
                    if (bone == Bone::jaw || bone == Bone::leftEye || bone == Bone::rightEye) {
                        CHECK_FALSE(mapping.map.has(bone));
                    } else {
                        CHECK(mapping.map[bone] == figure.truth[bone]);
                        CHECK(mapping.foundBy(bone) == FoundBy::place);
                    }
                }
            }
    }

    TEST_CASE("Sides in names win over sides by place") {
        Names names;
        for (std::size_t b = 0; b < motion::bone_count; ++b) {
            const auto bone = static_cast<Bone>(b);
            // The avatar's left side is called right: somebody's figure faces -z.
            const auto name = motion::boneName(motion::mirroredBone(bone));
            names[bone] = (name.starts_with("left")    ? "L_"
                           : name.starts_with("right") ? "R_"
                                                       : "") +
                          std::string("n") + std::to_string(b);
        }
        const Figure figure = figureOf(names);
        const auto map = motion::detectHumanoid(figure.skeleton);
        CHECK(map[Bone::rightHand] == figure.truth[Bone::leftHand]);
        CHECK(map[Bone::leftFoot] == figure.truth[Bone::rightFoot]);
    }

    TEST_CASE("A map that the file brings wins, and is filled only where it lacks what is needed") {
        const Figure figure = figureOf(namesOf(cases[2].names, cases[2].left, cases[2].right));
        motion::HumanoidMap given = figure.truth;
        given[Bone::leftToes] = -1;
        auto mapping = motion::mapHumanoid(figure.skeleton, &given);
        CHECK(mapping.map.joint == given.joint);
        CHECK(mapping.scheme == "VRM");
        CHECK(mapping.foundBy(Bone::hips) == FoundBy::file);
        given[Bone::leftHand] = -1;
        mapping = motion::mapHumanoid(figure.skeleton, &given);
        CHECK(mapping.map[Bone::leftHand] == figure.truth[Bone::leftHand]);
        CHECK(mapping.foundBy(Bone::leftHand) == FoundBy::scheme);
    }

    TEST_CASE("A joint that has a bone's name but hangs elsewhere is passed over, with a remark") {
        Names names = namesOf(cases[5].names, cases[5].left, cases[5].right);
        Figure figure = figureOf(names);
        for (auto& joint : figure.skeleton.joints)
            if (joint.name == "LeftElbow") joint.name = "LeftCubitus";
        figure.skeleton.joints.push_back({"LeftElbow", figure.truth[Bone::head], {}, std::nullopt});
        const auto mapping = motion::mapHumanoid(figure.skeleton);
        CHECK(mapping.map[Bone::leftLowerArm] == figure.truth[Bone::leftLowerArm]);
        CHECK(mapping.foundBy(Bone::leftLowerArm) == FoundBy::place);
        REQUIRE(mapping.remarks.size() == 1);
        CHECK(mapping.remarks[0].find("LeftElbow") != std::string::npos);
    }

    TEST_CASE("What is no figure has no map") {
        motion::Skeleton chain;
        for (int i = 0; i < 20; ++i)
            chain.joints.push_back({"b" + std::to_string(i), i - 1, {{0, 1, 0}, no_rotation}, std::nullopt});
        CHECK(motion::mapHumanoid(chain).missing().size() == motion::bone_count);
        motion::Skeleton star;
        star.joints.push_back({"b", -1, {}, std::nullopt});
        for (int i = 0; i < 9; ++i)
            star.joints.push_back({"s" + std::to_string(i), 0, {{0, 1, 0}, no_rotation}, std::nullopt});
        CHECK(motion::mapHumanoid(star).missing().size() == motion::bone_count);
    }

    TEST_CASE("Fingers may be counted from 2; a thumb from 2 lacks its first bone") {
        // Quaternius' people. With two fingers only, their place in the hand does not tell them.
        const auto figure = figureOf(
            namesOf("hips=Hips spine=Abdomen chest=Torso neck=Neck head=Head UpperLeg=UpperLeg.% "
                    "LowerLeg=LowerLeg.% Foot=Foot.% UpperArm=UpperArm.% LowerArm=LowerArm.% Hand=Hand.% "
                    "ThumbProximal=Thumb2.% ThumbDistal=Thumb3.% IndexProximal=Index2.% "
                    "IndexIntermediate=Index3.% IndexDistal=Index4.%",
                    "L", "R"));
        const auto mapping = motion::mapHumanoid(figure.skeleton);
        for (const Bone bone :
             {Bone::leftThumbMetacarpal, Bone::leftThumbProximal, Bone::leftThumbDistal,
              Bone::leftIndexProximal, Bone::leftIndexIntermediate, Bone::rightIndexDistal}) {
            CAPTURE(motion::boneName(bone));
            CHECK(mapping.map[bone] == figure.truth[bone]);
        }
        CHECK(mapping.foundBy(Bone::leftIndexProximal) == FoundBy::name);
        // A finger that has a first bone is counted from there.
        const auto usual = figureOf(
            namesOf("hips=Hips spine=Abdomen chest=Torso neck=Neck head=Head UpperLeg=UpperLeg.% "
                    "LowerLeg=LowerLeg.% Foot=Foot.% UpperArm=UpperArm.% LowerArm=LowerArm.% Hand=Hand.% "
                    "IndexProximal=Index1.% IndexIntermediate=Index2.% IndexDistal=Index3.%",
                    "L", "R"));
        CHECK(motion::mapHumanoid(usual.skeleton).map[Bone::leftIndexDistal] ==
              usual.truth[Bone::leftIndexDistal]);
    }
}
