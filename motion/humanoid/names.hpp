// Bones by the words in joints' names, whatever the scheme; private to humanoid mapping.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// A joint's name without prefixes, separators and side: "mixamorig:LeftUpLeg" -> left, "upleg".
struct PlainName {
    std::string core;
    std::optional<Side> side{};
    /// A joint beside the bones: one that shares a limb's twist ("b_l_arm_twist", "LeftForeArmRoll"), or that
    /// only leads to a bone of its name ("__UpLeg_L", as MakeHuman's older rigs have it).
    bool helper = false;
};
/// Whether a name as the file has it begins as those of joints that only lead to a bone.
[[nodiscard]] bool leadsToBone(std::string_view name);
[[nodiscard]] std::vector<PlainName> plainNames(const Skeleton& skeleton);

/// Fills in bones that `map` lacks and a name tells, each joint once; helpers only where no other joint has
/// the name. `names`: of the skeleton's joints.
void addByName(const std::vector<PlainName>& names, HumanoidMap& map);

}  // namespace deixis::motion
