// Any humanoid clip onto the avatar.
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/clip.hpp"

namespace deixis::motion {

/// Finds the humanoid bones of a skeleton by the naming schemes in use (VRM, Mixamo, CMU/cgspeed, OptiTrack,
/// iClone, MakeHuman, ...). Bones that are not found stay -1.
[[nodiscard]] HumanoidMap detectHumanoid(const Skeleton& skeleton);

struct RetargetReport {
    double scale = 1.0;  ///< avatar hip height over the source's
    std::vector<std::string> remarks;
};

/// The clip played by the avatar: upright, facing its own way round, feet near the floor; rest poses are
/// corrected (T, A, arms down, z up) by aligning bone directions. `avatar` is a T-pose skeleton without rest
/// rotations. Fails where the source lacks the bones that a humanoid needs, naming them.
[[nodiscard]] Result<Clip> retarget(const Clip& source, const HumanoidMap& source_map, const Skeleton& avatar,
                                    const HumanoidMap& avatar_map, RetargetReport* report = nullptr);

}  // namespace deixis::motion
