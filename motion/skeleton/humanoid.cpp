#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

namespace {

struct BoneInfo {
    std::string_view name;
    int parent;
    int mirrored;
};

constexpr int b(Bone bone) {
    return static_cast<int>(bone);
}

// In the order of Bone.
constexpr std::array<BoneInfo, bone_count> infos = [] {
    using enum Bone;
    std::array<BoneInfo, bone_count> t{};
    const auto middle = [&](Bone bone, std::string_view name, int parent) {
        t[static_cast<std::size_t>(bone)] = {name, parent, b(bone)};
    };
    const auto pair = [&](Bone left, std::string_view left_name, Bone right, std::string_view right_name,
                          int left_parent, int right_parent) {
        t[static_cast<std::size_t>(left)] = {left_name, left_parent, b(right)};
        t[static_cast<std::size_t>(right)] = {right_name, right_parent, b(left)};
    };
#define DEIXIS_PAIR(Name, left_parent, right_parent) \
    pair(left##Name, "left" #Name, right##Name, "right" #Name, left_parent, right_parent)
#define DEIXIS_CHAIN(Name, parent) DEIXIS_PAIR(Name, b(left##parent), b(right##parent))
    middle(hips, "hips", -1);
    middle(spine, "spine", b(hips));
    middle(chest, "chest", b(spine));
    middle(upperChest, "upperChest", b(chest));
    middle(neck, "neck", b(upperChest));
    middle(head, "head", b(neck));
    middle(jaw, "jaw", b(head));
    DEIXIS_PAIR(Eye, b(head), b(head));
    DEIXIS_PAIR(UpperLeg, b(hips), b(hips));
    DEIXIS_CHAIN(LowerLeg, UpperLeg);
    DEIXIS_CHAIN(Foot, LowerLeg);
    DEIXIS_CHAIN(Toes, Foot);
    DEIXIS_PAIR(Shoulder, b(upperChest), b(upperChest));
    DEIXIS_CHAIN(UpperArm, Shoulder);
    DEIXIS_CHAIN(LowerArm, UpperArm);
    DEIXIS_CHAIN(Hand, LowerArm);
    DEIXIS_CHAIN(ThumbMetacarpal, Hand);
    DEIXIS_CHAIN(ThumbProximal, ThumbMetacarpal);
    DEIXIS_CHAIN(ThumbDistal, ThumbProximal);
    DEIXIS_CHAIN(IndexProximal, Hand);
    DEIXIS_CHAIN(IndexIntermediate, IndexProximal);
    DEIXIS_CHAIN(IndexDistal, IndexIntermediate);
    DEIXIS_CHAIN(MiddleProximal, Hand);
    DEIXIS_CHAIN(MiddleIntermediate, MiddleProximal);
    DEIXIS_CHAIN(MiddleDistal, MiddleIntermediate);
    DEIXIS_CHAIN(RingProximal, Hand);
    DEIXIS_CHAIN(RingIntermediate, RingProximal);
    DEIXIS_CHAIN(RingDistal, RingIntermediate);
    DEIXIS_CHAIN(LittleProximal, Hand);
    DEIXIS_CHAIN(LittleIntermediate, LittleProximal);
    DEIXIS_CHAIN(LittleDistal, LittleIntermediate);
#undef DEIXIS_CHAIN
#undef DEIXIS_PAIR
    return t;
}();

const BoneInfo& info(Bone bone) {
    return infos[static_cast<std::size_t>(bone)];
}

}  // namespace

std::string_view boneName(Bone bone) {
    return info(bone).name;
}

std::optional<Bone> boneFromName(std::string_view vrm_name) {
    for (std::size_t i = 0; i < bone_count; ++i)
        if (infos[i].name == vrm_name) return static_cast<Bone>(i);
    return std::nullopt;
}

std::optional<Bone> parentBone(Bone bone) {
    const int parent = info(bone).parent;
    if (parent < 0) return std::nullopt;
    return static_cast<Bone>(parent);
}

Bone mirroredBone(Bone bone) {
    return static_cast<Bone>(info(bone).mirrored);
}

std::span<const Bone> requiredBones() {
    using enum Bone;
    static constexpr std::array bones{hips,          head,          leftUpperArm,  leftLowerArm, leftHand,
                                      rightUpperArm, rightLowerArm, rightHand,     leftUpperLeg, leftLowerLeg,
                                      leftFoot,      rightUpperLeg, rightLowerLeg, rightFoot};
    return bones;
}

std::span<const Bone> pointingBones() {
    return requiredBones().first(8);
}

std::vector<std::string> missingBones(const HumanoidMap& map, std::span<const Bone> bones) {
    std::vector<std::string> names;
    for (const Bone bone : bones)
        if (!map.has(bone)) names.emplace_back(boneName(bone));
    return names;
}

std::string_view sideName(Side side) {
    return side == Side::left ? "left" : "right";
}

ArmBones armBones(Side side) {
    using enum Bone;
    if (side == Side::left)
        return {leftShoulder,      leftUpperArm,          leftLowerArm,   leftHand,
                leftIndexProximal, leftIndexIntermediate, leftIndexDistal};
    return {rightShoulder,      rightUpperArm,          rightLowerArm,   rightHand,
            rightIndexProximal, rightIndexIntermediate, rightIndexDistal};
}

}  // namespace deixis::motion
