// Any humanoid clip onto the avatar: from another skeleton's rotations, or from joint positions alone.
#pragma once

#include <array>
#include <optional>
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

/// Where a person's joints were at one moment: metres, y up, facing anywhere. The neck is the point between
/// the shoulders.
struct BonePositions {
    std::array<std::optional<Vec3>, bone_count> at{};

    [[nodiscard]] const std::optional<Vec3>& operator[](Bone bone) const {
        return at[static_cast<std::size_t>(bone)];
    }
    std::optional<Vec3>& operator[](Bone bone) { return at[static_cast<std::size_t>(bone)]; }
};

/// The clip of an avatar (as for retarget) that holds its bones as the positions say, levelled so that the
/// person on the mean stands upright. What positions do not tell is chosen so: limbs twist as the plane of
/// elbow or knee says, and little where they are straight; the head is level on the mean; hands rest; feet
/// stay flat, and in every frame one is on the floor. Every frame must know hips, neck, head and the bones of
/// both arms (to the hand) and legs (to the foot); fails naming what is missing.
[[nodiscard]] Result<Clip> clipFromPositions(const std::vector<BonePositions>& frames, double frame_time_s,
                                             const Skeleton& avatar, const HumanoidMap& avatar_map,
                                             RetargetReport* report = nullptr);

}  // namespace deixis::motion
