// Which nodes of a glTF file play which bones; private to reading avatars.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::assets {

/// Node of each bone, -1 for none.
using BoneNodes = std::array<int, motion::bone_count>;

/// The map of VRMC_vrm (1.0) or VRM (0.x); none where the file has neither.
[[nodiscard]] Result<std::optional<BoneNodes>> vrmHumanoid(const tinygltf::Model& model,
                                                           const std::string& file);

/// The map by the joints' own names.
[[nodiscard]] motion::HumanoidMap humanoidByNames(const motion::Skeleton& skeleton);

}  // namespace deixis::assets
