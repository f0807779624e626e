// Which axis of a file's coordinates is up, and turning what was read so that it is y.
#pragma once

#include <vector>

#include "assets/joints/clip_import.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::assets {

/// The rotation that takes the axis to y.
[[nodiscard]] Quat yFromUp(UpAxis axis);

/// As given, else the axis along which the figure's head stands above its feet (without feet its hips), on
/// the mean over its frames; y is assumed where there are no such joints, or they lie at more than 45 degrees
/// from every axis.
[[nodiscard]] FoundUp findUp(const motion::Clip& clip, const motion::HumanoidMap& map,
                             const std::optional<UpAxis>& given);
/// The same for joint positions; without hips the neck above the spine.
[[nodiscard]] FoundUp findUp(const std::vector<motion::BonePositions>& frames,
                             const std::optional<UpAxis>& given);

/// Turns a clip at its roots.
void turnUp(motion::Clip& clip, UpAxis axis);

}  // namespace deixis::assets
