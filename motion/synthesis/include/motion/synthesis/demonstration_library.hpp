// The library of synthetic demonstrations: pointing gestures as one right-handed actor might make them, at
// targets on a half-cylinder. Formulas and values: docs/systems.md, assets/data/demonstrations.toml.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"
#include "motion/synthesis/generator.hpp"

namespace deixis::motion {

struct Demonstration {
    Vec3 target{0.0};  ///< metres, in the avatar's frame
    GeneratedClip gesture;
};

/// left_count left-handed demonstrations, then right_count right-handed ones. Depends on the avatar's
/// skeleton and the parameters alone. Fails on an avatar without the needed bones.
[[nodiscard]] Result<std::vector<Demonstration>> makeDemonstrations(
    const Skeleton& avatar, const DemonstrationParameters& parameters);

/// The gesture seen in a mirror: the other hand, the target on the other side. The skeleton carries VRM
/// names.
[[nodiscard]] Demonstration mirrored(const Demonstration& demonstration);

/// The demonstrations followed by their mirror images: twice as many.
[[nodiscard]] std::vector<Demonstration> withMirrored(std::vector<Demonstration> demonstrations);

}  // namespace deixis::motion
