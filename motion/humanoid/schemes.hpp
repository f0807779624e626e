// The naming schemes of humanoid rigs; private to humanoid mapping.
#pragma once

#include <optional>
#include <string>

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

struct SchemeMatch {
    std::string scheme;
    HumanoidMap map;
    int bones = 0;
};

/// The scheme that names most of the skeleton's joints, out of those that name all that a humanoid needs.
[[nodiscard]] std::optional<SchemeMatch> matchScheme(const Skeleton& skeleton);

}  // namespace deixis::motion
