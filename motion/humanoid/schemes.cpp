#include "schemes.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "motion/humanoid/mapping.hpp"
#include "names.hpp"

namespace deixis::motion {

namespace {

/// A scheme. In names % is the side as the scheme writes it, $ its first letter, # a finger. Blanks, dots,
/// hyphens and underscores do not count, and a prefix that all names carry is left out ("mixamorig:",
/// "Bip01 ").
struct Scheme {
    std::string_view name;
    std::string_view left, right;
    std::string_view body;           ///< "bone=name"; bones of both sides without "left"
    std::string_view fingers;        ///< thumb to little finger
    std::string_view thumb, finger;  ///< names of their three bones
};

// VRM: VRMC_vrm-1.0 and VRM 0.x, "humanoid". Unity: HumanBodyBones. Mixamo: its auto-rigger's names, which
// are MotionBuilder's. CMU/cgspeed: the conversions of the CMU recordings to BVH by B. Hahne. Rokoko: Newton.
// UE: the mannequin. Xsens: MVN's segments, and its BVH export. OptiTrack: Motive's and Arena's.
constexpr Scheme schemes[] = {
    {"VRM", "left", "right",
     "hips=hips spine=spine chest=chest upperChest=upperChest neck=neck head=head jaw=jaw Eye=%Eye "
     "UpperLeg=%UpperLeg LowerLeg=%LowerLeg Foot=%Foot Toes=%Toes Shoulder=%Shoulder UpperArm=%UpperArm "
     "LowerArm=%LowerArm Hand=%Hand",
     "Thumb Index Middle Ring Little", "%#Metacarpal %#Proximal %#Distal",
     "%#Proximal %#Intermediate %#Distal"},
    {"VRM", "left", "right",
     "hips=hips spine=spine chest=chest upperChest=upperChest neck=neck head=head jaw=jaw Eye=%Eye "
     "UpperLeg=%UpperLeg LowerLeg=%LowerLeg Foot=%Foot Toes=%Toes Shoulder=%Shoulder UpperArm=%UpperArm "
     "LowerArm=%LowerArm Hand=%Hand",
     "Thumb Index Middle Ring Little", "%#Proximal %#Intermediate %#Distal",
     "%#Proximal %#Intermediate %#Distal"},
    {"Unity", "Left", "Right",
     "hips=Hips spine=Spine chest=Chest upperChest=UpperChest neck=Neck head=Head jaw=Jaw Eye=%Eye "
     "UpperLeg=%UpperLeg LowerLeg=%LowerLeg Foot=%Foot Toes=%Toes Shoulder=%Shoulder UpperArm=%UpperArm "
     "LowerArm=%LowerArm Hand=%Hand",
     "Thumb Index Middle Ring Little", "%#Proximal %#Intermediate %#Distal",
     "%#Proximal %#Intermediate %#Distal"},
    {"Mixamo", "Left", "Right",
     "hips=Hips spine=Spine chest=Spine1 upperChest=Spine2 neck=Neck head=Head Eye=%Eye UpperLeg=%UpLeg "
     "LowerLeg=%Leg Foot=%Foot Toes=%ToeBase Shoulder=%Shoulder UpperArm=%Arm LowerArm=%ForeArm Hand=%Hand",
     "Thumb Index Middle Ring Pinky", "%Hand#1 %Hand#2 %Hand#3", "%Hand#1 %Hand#2 %Hand#3"},
    {"CMU/cgspeed", "Left", "Right",
     "hips=Hips spine=LowerBack chest=Spine upperChest=Spine1 neck=Neck head=Head UpperLeg=%UpLeg "
     "LowerLeg=%Leg Foot=%Foot Toes=%ToeBase Shoulder=%Shoulder UpperArm=%Arm LowerArm=%ForeArm Hand=%Hand "
     "ThumbMetacarpal=$Thumb IndexProximal=%HandIndex1",
     "", "", ""},
    {"Rokoko", "Left", "Right",
     "hips=Hips spine=Spine1 chest=Spine3 upperChest=Spine4 neck=Neck head=Head UpperLeg=%Thigh "
     "LowerLeg=%Shin Foot=%Foot Toes=%Toe Shoulder=%Shoulder UpperArm=%Arm LowerArm=%ForeArm Hand=%Hand",
     "1 2 3 4 5", "%Finger#Metacarpal %Finger#Proximal %Finger#Distal",
     "%Finger#Proximal %Finger#Medial %Finger#Distal"},
    {"UE", "l", "r",
     "hips=pelvis spine=spine_01 chest=spine_02 upperChest=spine_03 neck=neck_01 head=head UpperLeg=thigh_% "
     "LowerLeg=calf_% Foot=foot_% Toes=ball_% Shoulder=clavicle_% UpperArm=upperarm_% LowerArm=lowerarm_% "
     "Hand=hand_%",
     "thumb index middle ring pinky", "#_01_% #_02_% #_03_%", "#_01_% #_02_% #_03_%"},
    {"OptiTrack", "L", "R",
     "hips=Hip spine=Ab chest=Chest neck=Neck head=Head UpperLeg=%Thigh LowerLeg=%Shin Foot=%Foot Toes=%Toe "
     "Shoulder=%Shoulder UpperArm=%UArm LowerArm=%FArm Hand=%Hand",
     "Thumb Index Middle Ring Pinky", "%#1 %#2 %#3", "%#1 %#2 %#3"},
    {"OptiTrack", "Left", "Right",
     "hips=Hips spine=Chest neck=Neck head=Head UpperLeg=%Hip LowerLeg=%Knee Foot=%Ankle Toes=%Toe "
     "Shoulder=%Collar UpperArm=%Shoulder LowerArm=%Elbow Hand=%Wrist",
     "", "", ""},
    {"Xsens", "Left", "Right",
     "hips=Pelvis spine=L5 chest=T12 upperChest=T8 neck=Neck head=Head UpperLeg=%UpperLeg LowerLeg=%LowerLeg "
     "Foot=%Foot Toes=%Toe Shoulder=%Shoulder UpperArm=%UpperArm LowerArm=%ForeArm Hand=%Hand",
     "First Second Third Fourth Fifth", "%#MC %#PP %#DP", "%#PP %#MP %#DP"},
    {"Xsens", "Left", "Right",
     "hips=Pelvis spine=L5 chest=T12 upperChest=T8 neck=Neck head=Head UpperLeg=%UpperLeg LowerLeg=%LowerLeg "
     "Foot=%Foot Toes=%Toe Shoulder=%Shoulder UpperArm=%UpperArm LowerArm=%Forearm Hand=%Hand",
     "First Second Third Fourth Fifth", "%#MC %#PP %#DP", "%#PP %#MP %#DP"},
    {"Xsens", "Left", "Right",
     "hips=Hips spine=Chest chest=Chest3 upperChest=Chest4 neck=Neck head=Head UpperLeg=%Hip LowerLeg=%Knee "
     "Foot=%Ankle Toes=%Toe Shoulder=%Collar UpperArm=%Shoulder LowerArm=%Elbow Hand=%Wrist",
     "", "", ""},
    {"MakeHuman", "L", "R",
     "hips=root spine=spine05 chest=spine03 upperChest=spine01 neck=neck01 head=head jaw=jaw Eye=eye.% "
     "UpperLeg=upperleg01.% LowerLeg=lowerleg01.% Foot=foot.% Toes=toe3-1.% Shoulder=clavicle.% "
     "UpperArm=upperarm01.% LowerArm=lowerarm01.% Hand=wrist.%",
     "1 2 3 4 5", "finger#-1.% finger#-2.% finger#-3.%", "finger#-1.% finger#-2.% finger#-3.%"},
    {"iClone", "L", "R",
     "hips=Hip spine=Waist chest=Spine01 upperChest=Spine02 neck=NeckTwist01 head=Head jaw=JawRoot Eye=%_Eye "
     "UpperLeg=%_Thigh LowerLeg=%_Calf Foot=%_Foot Toes=%_ToeBase Shoulder=%_Clavicle UpperArm=%_Upperarm "
     "LowerArm=%_Forearm Hand=%_Hand",
     "Thumb Index Mid Ring Pinky", "%_#1 %_#2 %_#3", "%_#1 %_#2 %_#3"},
    {"Biped", "L", "R",
     "hips=Pelvis spine=Spine chest=Spine1 upperChest=Spine2 neck=Neck head=Head UpperLeg=%Thigh "
     "LowerLeg=%Calf Foot=%Foot Toes=%Toe0 Shoulder=%Clavicle UpperArm=%UpperArm LowerArm=%Forearm "
     "Hand=%Hand",
     "0 1 2 3 4", "%Finger# %Finger#1 %Finger#2", "%Finger# %Finger#1 %Finger#2"},
};

std::string plain(std::string_view name) {
    std::string out;
    for (const char c : name)
        if (c != ' ' && c != '_' && c != '.' && c != '-') out += c;
    return out;
}

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> out;
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        if (end > 0) out.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

struct NamedBone {
    Bone bone;
    std::string name;
};

std::string filled(std::string_view pattern, std::string_view side, std::string_view finger) {
    std::string out;
    for (const char c : pattern) {
        if (c == '%')
            out += side;
        else if (c == '$')
            out += side.substr(0, 1);
        else if (c == '#')
            out += finger;
        else
            out += c;
    }
    return plain(out);
}

std::vector<NamedBone> bonesOf(const Scheme& scheme) {
    std::vector<NamedBone> bones;
    for (const std::string_view row : words(scheme.body)) {
        const auto equals = row.find('=');
        const std::string bone(row.substr(0, equals));
        const std::string_view name = row.substr(equals + 1);
        if (const auto middle = boneFromName(bone)) {
            bones.push_back({*middle, plain(name)});
            continue;
        }
        const Bone left = *boneFromName("left" + bone);
        bones.push_back({left, filled(name, scheme.left, "")});
        bones.push_back({mirroredBone(left), filled(name, scheme.right, "")});
    }
    auto first = static_cast<int>(Bone::leftThumbMetacarpal);
    bool thumb = true;
    for (const std::string_view finger : words(scheme.fingers)) {
        for (const std::string_view pattern : words(thumb ? scheme.thumb : scheme.finger)) {
            const auto left = static_cast<Bone>(first++);
            bones.push_back({left, filled(pattern, scheme.left, finger)});
            bones.push_back({mirroredBone(left), filled(pattern, scheme.right, finger)});
        }
        thumb = false;
    }
    return bones;
}

using JointsByName = std::unordered_map<std::string, int>;

SchemeMatch matchWith(const Scheme& scheme, const std::vector<NamedBone>& bones, const std::string& prefix,
                      const JointsByName& joints) {
    SchemeMatch match{std::string(scheme.name), {}, 0};
    for (const NamedBone& bone : bones) {
        const auto found = joints.find(prefix + bone.name);
        if (found == joints.end()) continue;
        match.map[bone.bone] = found->second;
        ++match.bones;
    }
    return match;
}

}  // namespace

std::optional<SchemeMatch> matchScheme(const Skeleton& skeleton) {
    static const std::vector<std::vector<NamedBone>> tables = [] {
        std::vector<std::vector<NamedBone>> out;
        for (const Scheme& scheme : schemes) out.push_back(bonesOf(scheme));
        return out;
    }();
    constexpr std::size_t max_prefixes = 4;
    JointsByName joints;
    std::vector<std::string> names;
    for (const Joint& joint : skeleton.joints) names.push_back(plain(joint.name));
    for (const bool leading : {false, true})  // a bone comes before what only leads to it
        for (std::size_t j = 0; j < names.size(); ++j)
            if (leadsToBone(skeleton.joints[j].name) == leading)
                joints.emplace(names[j], static_cast<int>(j));
    std::optional<SchemeMatch> best;
    for (std::size_t s = 0; s < tables.size(); ++s) {
        const std::string& root = tables[s].front().name;  // hips
        std::size_t tried = 0;
        for (const std::string& name : names) {
            if (!name.ends_with(root)) continue;
            if (++tried > max_prefixes) break;
            auto match = matchWith(schemes[s], tables[s], name.substr(0, name.size() - root.size()), joints);
            if (missingBones(match.map).empty() && (!best || match.bones > best->bones))
                best = std::move(match);
        }
    }
    return best;
}

}  // namespace deixis::motion
