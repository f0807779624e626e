// The humanoid bones that a skeleton may have, by their VRM 1.0 names (VRMC_vrm-1.0, humanoid), and a map
// from them to a skeleton's joints.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace deixis::motion {

// clang-format off
enum class Bone : unsigned char {
    hips, spine, chest, upperChest, neck, head, jaw, leftEye, rightEye,
    leftUpperLeg, leftLowerLeg, leftFoot, leftToes,
    rightUpperLeg, rightLowerLeg, rightFoot, rightToes,
    leftShoulder, leftUpperArm, leftLowerArm, leftHand,
    rightShoulder, rightUpperArm, rightLowerArm, rightHand,
    leftThumbMetacarpal, leftThumbProximal, leftThumbDistal,
    leftIndexProximal, leftIndexIntermediate, leftIndexDistal,
    leftMiddleProximal, leftMiddleIntermediate, leftMiddleDistal,
    leftRingProximal, leftRingIntermediate, leftRingDistal,
    leftLittleProximal, leftLittleIntermediate, leftLittleDistal,
    rightThumbMetacarpal, rightThumbProximal, rightThumbDistal,
    rightIndexProximal, rightIndexIntermediate, rightIndexDistal,
    rightMiddleProximal, rightMiddleIntermediate, rightMiddleDistal,
    rightRingProximal, rightRingIntermediate, rightRingDistal,
    rightLittleProximal, rightLittleIntermediate, rightLittleDistal,
};
// clang-format on
constexpr std::size_t bone_count = 55;

/// The VRM name, such as "leftUpperArm".
[[nodiscard]] std::string_view boneName(Bone bone);
[[nodiscard]] std::optional<Bone> boneFromName(std::string_view vrm_name);

/// The bone above in VRM's hierarchy; none for hips.
[[nodiscard]] std::optional<Bone> parentBone(Bone bone);

/// The same bone on the other side; the bone itself where it lies in the middle.
[[nodiscard]] Bone mirroredBone(Bone bone);

/// Which joint of a skeleton plays each bone; -1 where it has none.
struct HumanoidMap {
    std::array<int, bone_count> joint;
    HumanoidMap() { joint.fill(-1); }
    [[nodiscard]] int operator[](Bone bone) const { return joint[static_cast<std::size_t>(bone)]; }
    int& operator[](Bone bone) { return joint[static_cast<std::size_t>(bone)]; }
    [[nodiscard]] bool has(Bone bone) const { return (*this)[bone] >= 0; }
};

/// The bones that retargeting cannot do without: hips, head, upper and lower arms, hands; legs and feet.
[[nodiscard]] std::span<const Bone> requiredBones();
/// Those of them that pointing is measured by: all but the legs.
[[nodiscard]] std::span<const Bone> pointingBones();
/// Names of those that a map lacks.
[[nodiscard]] std::vector<std::string> missingBones(const HumanoidMap& map,
                                                    std::span<const Bone> bones = requiredBones());

enum class Side : unsigned char { left, right };
[[nodiscard]] std::string_view sideName(Side side);  ///< "left" or "right"
[[nodiscard]] constexpr Side opposite(Side side) {
    return side == Side::left ? Side::right : Side::left;
}

/// Bones of one arm, for code that works on either.
struct ArmBones {
    Bone shoulder, upper_arm, lower_arm, hand, index_proximal, index_intermediate, index_distal;
};
[[nodiscard]] ArmBones armBones(Side side);

}  // namespace deixis::motion
