#include "names.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/text.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

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
    {neck, "neck neck01 necktwist01 neck0 neck1 necklower lowerneck"},
    {jaw, "jaw jawroot"},
    {leftEye, "eye"},
    {leftUpperLeg, "upperleg upperleg01 upleg thigh thighbend hip"},
    {leftLowerLeg, "lowerleg lowerleg01 loleg calf shin knee leg"},
    {leftFoot, "foot ankle"},
    {leftToes, "toes toebase toe toe0 toe31 ball"},
    {leftUpperArm, "upperarm upperarm01 uparm uarm shldr shldrbend arm shoulder"},
    {leftLowerArm, "lowerarm lowerarm01 loarm forearm forearmbend farm elbow"},
    {leftHand, "hand wrist"},
    {leftShoulder, "collar collarbone clavicle shoulder"},
    {leftThumbMetacarpal, "thumbmetacarpal thumb1 thumb01 finger11 thumb"},
    {leftThumbProximal, "thumbproximal thumb2 thumb02 finger12"},
    {leftThumbDistal, "thumbdistal thumb3 thumb03 finger13"},
    {leftIndexProximal, "indexproximal index1 index01 findex01 finger21"},
    {leftIndexIntermediate, "indexintermediate indexmedial index2 index02 findex02 finger22"},
    {leftIndexDistal, "indexdistal index3 index03 findex03 finger23"},
    {leftMiddleProximal, "middleproximal middle1 middle01 fmiddle01 mid1 finger31"},
    {leftMiddleIntermediate, "middleintermediate middlemedial middle2 middle02 fmiddle02 mid2 finger32"},
    {leftMiddleDistal, "middledistal middle3 middle03 fmiddle03 mid3 finger33"},
    {leftRingProximal, "ringproximal ring1 ring01 fring01 finger41"},
    {leftRingIntermediate, "ringintermediate ringmedial ring2 ring02 fring02 finger42"},
    {leftRingDistal, "ringdistal ring3 ring03 fring03 finger43"},
    {leftLittleProximal, "littleproximal pinky1 pinky01 fpinky01 little1 finger51"},
    {leftLittleIntermediate, "littleintermediate littlemedial pinky2 pinky02 fpinky02 little2 finger52"},
    {leftLittleDistal, "littledistal pinky3 pinky03 fpinky03 little3 finger53"},
};

/// Words of rigs' prefixes that say nothing about the bone.
constexpr std::string_view noise[] = {"cc",     "base", "rl",   "j",   "bip",  "c",     "bip01",
                                      "bip001", "def",  "skel", "org", "bone", "joint", "b"};

bool isLower(char c) {
    return std::islower(static_cast<unsigned char>(c)) != 0;
}
bool isUpper(char c) {
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

bool takePrefix(std::string& text, std::string_view prefix) {
    if (text.size() <= prefix.size() || !text.starts_with(prefix)) return false;
    text.erase(0, prefix.size());
    return true;
}

PlainName plainName(std::string_view name) {
    const bool leads = leadsToBone(name);
    if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
    PlainName plain;
    const bool one_word = name.find_first_of("_ .") == std::string_view::npos;
    if (one_word && name.size() > 2 && std::string_view("LRlr").find(name[0]) != std::string_view::npos &&
        isUpper(name[1])) {  // "LThumb", "rShldr"
        plain.side = name[0] == 'L' || name[0] == 'l' ? Side::left : Side::right;
        name.remove_prefix(1);
    }
    std::string word;
    const auto finishWord = [&] {
        if (word == "l" || word == "left")
            plain.side = Side::left;
        else if (word == "r" || word == "right")
            plain.side = Side::right;
        else if (std::find(std::begin(noise), std::end(noise), word) == std::end(noise))
            plain.core += word;
        word.clear();
    };
    for (const char c : lowerCase(name)) {
        if (c == '_' || c == ' ' || c == '.' || c == '-')
            finishWord();
        else
            word += c;
    }
    finishWord();
    if (takePrefix(plain.core, "mixamorig"))
        while (!plain.core.empty() && isDigit(plain.core.front())) plain.core.erase(0, 1);
    if (takePrefix(plain.core, "left"))
        plain.side = Side::left;
    else if (takePrefix(plain.core, "right"))
        plain.side = Side::right;
    // "UpLegLeft", "upLegL"
    const auto takeEnd = [&](std::string_view end, Side side) {
        if (plain.side || plain.core.size() <= end.size() || !plain.core.ends_with(end)) return;
        plain.core.erase(plain.core.size() - end.size());
        plain.side = side;
    };
    takeEnd("left", Side::left);
    takeEnd("right", Side::right);
    if (name.size() > 2 && isLower(name[name.size() - 2]) && name.back() == 'L') takeEnd("l", Side::left);
    if (name.size() > 2 && isLower(name[name.size() - 2]) && name.back() == 'R') takeEnd("r", Side::right);
    takePrefix(plain.core, "hand");  // "LeftHandIndex1"
    const auto says = [&](std::string_view what) { return plain.core.find(what) != std::string::npos; };
    plain.helper = leads || (plain.side && (says("twist") || says("roll")));
    return plain;
}

bool has(const std::vector<PlainName>& names, Side side, std::string_view cores) {
    return std::any_of(names.begin(), names.end(), [&](const PlainName& name) {
        const auto at = cores.find(name.core);
        return name.side == side && !name.core.empty() && at != std::string_view::npos &&
               (at == 0 || cores[at - 1] == ' ') &&
               (at + name.core.size() == cores.size() || cores[at + name.core.size()] == ' ');
    });
}

/// The number at the end of a name such as "index2" or "index02", if that is what is left of it behind
/// `finger`.
std::optional<int> numberOf(std::string_view core, std::string_view finger) {
    if (!core.starts_with(finger)) return std::nullopt;
    core.remove_prefix(finger.size());
    if (core.size() == 2 && core.front() == '0') core.remove_prefix(1);
    if (core.size() != 1 || core.front() < '1' || core.front() > '9') return std::nullopt;
    return core.front() - '0';
}

/// Rigs that count a hand's bones in may begin their fingers with 2. The thumb keeps its numbers: what such
/// rigs lack is its metacarpal, which is its first bone.
void countFingersFromOne(std::vector<PlainName>& names, Side side) {
    for (const std::string_view finger :
         {"index", "findex", "middle", "fmiddle", "mid", "ring", "fring", "pinky", "fpinky", "little"}) {
        std::vector<std::pair<PlainName*, int>> bones;
        int first = 9;
        for (PlainName& name : names)
            if (const auto number = name.side == side ? numberOf(name.core, finger) : std::nullopt) {
                bones.emplace_back(&name, *number);
                first = std::min(first, *number);
            }
        if (first != 2) continue;
        for (const auto& [name, number] : bones)
            name->core = std::string(finger) + std::to_string(number - 1);
    }
}

}  // namespace

bool leadsToBone(std::string_view name) {
    if (const auto colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
    return name.starts_with("__");
}

std::vector<PlainName> plainNames(const Skeleton& skeleton) {
    std::vector<PlainName> names;
    names.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) names.push_back(plainName(joint.name));
    for (const Side side : {Side::left, Side::right}) {
        // A "leg" above a knee is a thigh, and one below a thigh a shin; an "arm" over an elbow likewise.
        if (has(names, side, "knee calf shin") && !has(names, side, "upperleg upleg thigh hip thighbend"))
            for (PlainName& name : names)
                if (name.side == side && name.core == "leg") name.core = "upperleg";
        // An "arm" between a shoulder and a hand, with no other name for the forearm, is the forearm.
        if (!has(names, side, "lowerarm lowerarm01 loarm forearm forearmbend farm elbow") &&
            has(names, side, "shoulder") && !has(names, side, "upperarm upperarm01 uparm collar clavicle"))
            for (PlainName& name : names)
                if (name.side == side && name.core == "arm") name.core = "lowerarm";
        countFingersFromOne(names, side);
    }
    return names;
}

void addByName(const std::vector<PlainName>& names, HumanoidMap& map) {
    const auto keyOf = [](std::optional<Side> side, std::string_view core) {
        std::string key = !side ? "" : *side == Side::left ? "l " : "r ";
        return key.append(core);
    };
    std::unordered_map<std::string, std::vector<int>> free;  // joints that play no bone yet
    for (const bool helpers : {false, true})
        for (std::size_t i = 0; i < names.size(); ++i)
            if (const int joint = static_cast<int>(i);
                names[i].helper == helpers &&
                std::find(map.joint.begin(), map.joint.end(), joint) == map.joint.end())
                free[keyOf(names[i].side, names[i].core)].push_back(joint);
    const auto find = [&](std::optional<Side> side, std::string_view alternatives) {
        while (!alternatives.empty()) {
            const auto end = std::min(alternatives.find(' '), alternatives.size());
            const auto found = free.find(keyOf(side, alternatives.substr(0, end)));
            if (found != free.end() && !found->second.empty()) {
                const int joint = found->second.front();
                found->second.erase(found->second.begin());
                return joint;
            }
            alternatives.remove_prefix(std::min(end + 1, alternatives.size()));
        }
        return -1;
    };
    for (const Row& row : rows) {
        const Bone other = mirroredBone(row.bone);
        if (other == row.bone) {
            if (!map.has(row.bone)) map[row.bone] = find(std::nullopt, row.names);
            continue;
        }
        if (!map.has(row.bone)) map[row.bone] = find(Side::left, row.names);
        if (!map.has(other)) map[other] = find(Side::right, row.names);
    }
}

}  // namespace deixis::motion
