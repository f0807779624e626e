// What VRM's versions call bones, and how they list those that a figure lacks.
#pragma once

#include <optional>
#include <string_view>

#include "motion/skeleton/humanoid.hpp"

namespace deixis::assets {

/// Some exporters list the bones that a figure lacks, with this node.
inline constexpr int vrm_absent_node = -1;

/// VRM 0.x calls the thumb's bones proximal, intermediate and distal (VRM 1.0: metacarpal, proximal, distal).
[[nodiscard]] inline std::optional<motion::Bone> boneOfVrm0(std::string_view name) {
    using enum motion::Bone;
    if (name == "leftThumbProximal") return leftThumbMetacarpal;
    if (name == "leftThumbIntermediate") return leftThumbProximal;
    if (name == "rightThumbProximal") return rightThumbMetacarpal;
    if (name == "rightThumbIntermediate") return rightThumbProximal;
    return motion::boneFromName(name);
}

}  // namespace deixis::assets
