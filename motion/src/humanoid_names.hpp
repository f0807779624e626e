// Bones by the words in joints' names, whatever the scheme; private to humanoid mapping.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton.hpp"

namespace deixis::motion {

/// A joint's name without prefixes, separators and side: "mixamorig:LeftUpLeg" -> left, "upleg".
struct PlainName {
    std::string core;
    std::optional<Side> side{};
};
[[nodiscard]] std::vector<PlainName> plainNames(const Skeleton& skeleton);

/// Fills in bones that `map` lacks and a name tells, each joint once. `names`: of the skeleton's joints.
void addByName(const std::vector<PlainName>& names, HumanoidMap& map);

}  // namespace deixis::motion
