#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

#include "motion/retarget.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

/// A joint's name without prefixes, separators and side: "mixamorig:LeftUpLeg" -> left, "upleg".
struct PlainName {
    enum class Where : unsigned char { middle, left, right } where = Where::middle;
    std::string core;
};

/// Names in use for a bone (of the left side, or in the middle), best first; plain. A joint plays one bone
/// only, so the order of the rows matters: Mixamo's "LeftShoulder" is a collar bone because "LeftArm" is
/// there, OptiTrack's is an upper arm.
struct Row {
    Bone bone;
    std::string_view names;
};
constexpr Row rows[] = {
    {hips, "hips hip pelvis root"},
    {head, "head"},
    {neck, "neck neck01 necktwist01 neck1"},
    {jaw, "jaw jawroot"},
    {leftEye, "eye"},
    {leftUpperLeg, "upperleg upperleg01 upleg thigh hip"},
    {leftLowerLeg, "lowerleg lowerleg01 leg calf shin knee"},
    {leftFoot, "foot ankle"},
    {leftToes, "toes toebase toe toe31 ball"},
    {leftUpperArm, "upperarm upperarm01 uparm arm shoulder"},
    {leftLowerArm, "lowerarm lowerarm01 forearm elbow"},
    {leftHand, "hand wrist"},
    {leftShoulder, "collar clavicle shoulder"},
    {leftThumbMetacarpal, "thumbmetacarpal thumb1 thumb01 finger11 thumb"},
    {leftThumbProximal, "thumbproximal thumb2 thumb02 finger12"},
    {leftThumbDistal, "thumbdistal thumb3 thumb03 finger13"},
    {leftIndexProximal, "indexproximal index1 index01 finger21"},
    {leftIndexIntermediate, "indexintermediate index2 index02 finger22"},
    {leftIndexDistal, "indexdistal index3 index03 finger23"},
    {leftMiddleProximal, "middleproximal middle1 middle01 mid1 finger31"},
    {leftMiddleIntermediate, "middleintermediate middle2 middle02 mid2 finger32"},
    {leftMiddleDistal, "middledistal middle3 middle03 mid3 finger33"},
    {leftRingProximal, "ringproximal ring1 ring01 finger41"},
    {leftRingIntermediate, "ringintermediate ring2 ring02 finger42"},
    {leftRingDistal, "ringdistal ring3 ring03 finger43"},
    {leftLittleProximal, "littleproximal pinky1 pinky01 little1 finger51"},
    {leftLittleIntermediate, "littleintermediate pinky2 pinky02 little2 finger52"},
    {leftLittleDistal, "littledistal pinky3 pinky03 little3 finger53"},
};

/// Words of rigs' prefixes that say nothing about the bone.
constexpr std::string_view noise[] = {"cc", "base", "rl", "j", "bip", "c", "bip01", "bip001", "def"};

bool takePrefix(std::string& text, std::string_view prefix) {
    if (text.size() <= prefix.size() || !text.starts_with(prefix)) return false;
    text.erase(0, prefix.size());
    return true;
}

PlainName plainName(std::string_view name) {
    using Where = PlainName::Where;
    if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
    PlainName plain;
    if (name.size() > 1 && (name[0] == 'L' || name[0] == 'R') && name[1] >= 'A' && name[1] <= 'Z' &&
        name.find_first_of("_ .") == std::string_view::npos) {  // "LThumb"
        plain.where = name[0] == 'L' ? Where::left : Where::right;
        name.remove_prefix(1);
    }
    std::string word;
    const auto finishWord = [&] {
        if (word == "l" || word == "left")
            plain.where = Where::left;
        else if (word == "r" || word == "right")
            plain.where = Where::right;
        else if (std::find(std::begin(noise), std::end(noise), word) == std::end(noise))
            plain.core += word;
        word.clear();
    };
    for (const char c : name) {
        if (c == '_' || c == ' ' || c == '.' || c == '-')
            finishWord();
        else
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    finishWord();
    takePrefix(plain.core, "mixamorig");
    if (takePrefix(plain.core, "left"))
        plain.where = Where::left;
    else if (takePrefix(plain.core, "right"))
        plain.where = Where::right;
    takePrefix(plain.core, "hand");  // "LeftHandIndex1"
    return plain;
}

/// The joints between hips and neck, from below, shared out over the three bones of the spine.
void mapSpine(const Skeleton& skeleton, HumanoidMap& map) {
    std::vector<int> chain;
    int joint = map.has(neck) ? map[neck] : map[head];
    if (joint < 0 || !map.has(hips)) return;
    for (joint = skeleton.joints[static_cast<std::size_t>(joint)].parent; joint >= 0 && joint != map[hips];
         joint = skeleton.joints[static_cast<std::size_t>(joint)].parent)
        chain.insert(chain.begin(), joint);
    if (joint < 0 || chain.empty()) return;
    map[spine] = chain.front();
    if (chain.size() == 2) map[chest] = chain.back();
    if (chain.size() < 3) return;
    map[chest] = chain[chain.size() / 2];
    map[upperChest] = chain.back();
}

}  // namespace

HumanoidMap detectHumanoid(const Skeleton& skeleton) {
    std::vector<PlainName> names;
    names.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) names.push_back(plainName(joint.name));

    HumanoidMap map;
    std::vector<bool> used(names.size(), false);
    const auto find = [&](PlainName::Where where, std::string_view alternatives) {
        while (!alternatives.empty()) {
            const auto end = std::min(alternatives.find(' '), alternatives.size());
            const auto wanted = alternatives.substr(0, end);
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (used[i] || names[i].where != where || names[i].core != wanted) continue;
                used[i] = true;
                return static_cast<int>(i);
            }
            alternatives.remove_prefix(std::min(end + 1, alternatives.size()));
        }
        return -1;
    };
    for (const Row& row : rows) {
        const Bone other = mirroredBone(row.bone);
        if (other == row.bone) {
            map[row.bone] = find(PlainName::Where::middle, row.names);
        } else {
            map[row.bone] = find(PlainName::Where::left, row.names);
            map[other] = find(PlainName::Where::right, row.names);
        }
    }
    mapSpine(skeleton, map);
    return map;
}

}  // namespace deixis::motion
