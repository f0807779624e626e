// Which joint of a skeleton is which humanoid bone: found by known naming schemes, otherwise by names in
// general and by the shape of the figure.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// How a bone was found.
enum class FoundBy : unsigned char {
    nothing,   ///< it was not
    file,      ///< the clip's or avatar's file says so (VRM)
    scheme,    ///< its name is that of the naming scheme
    name,      ///< by words of its name
    place,     ///< by its place in the figure
    override_  ///< a person says so
};
[[nodiscard]] std::string_view foundByName(FoundBy found);  ///< "scheme", "name", ... ; "" for nothing

struct HumanoidMapping {
    HumanoidMap map;
    /// "VRM", "Unity", "Mixamo", "CMU/cgspeed", "OptiTrack", "Xsens", "MakeHuman", "Rokoko", "UE", "Biped",
    /// "iClone"; "by name and topology" where no scheme has all bones that a humanoid needs.
    std::string scheme;
    std::array<FoundBy, bone_count> found{};
    std::vector<std::string> remarks;

    [[nodiscard]] FoundBy foundBy(Bone bone) const { return found[static_cast<std::size_t>(bone)]; }
    [[nodiscard]] std::vector<Bone> missing() const;
};

/// Maps a skeleton. `given`, where it is not null, is a map that the file brings: its bones stand, and others
/// are looked for only where it lacks required ones. Sides come from names, else from the rest pose, in which
/// toes point ahead. The joints between hips and neck are shared out over spine, chest and upper chest. Of a
/// mere list of joints (all of them roots) the names alone tell.
[[nodiscard]] HumanoidMapping mapHumanoid(const Skeleton& skeleton, const HumanoidMap* given = nullptr);

/// What is doubtful about a map, in words: shoulders or arms less than half as wide or long as the reference
/// humanoid's would be with such legs. `world`: the figure as it stands, in metres (worldPose()). Empty where
/// bones that are required lack.
[[nodiscard]] std::vector<std::string> mappingWarnings(const Skeleton& skeleton, const HumanoidMap& map,
                                                       const std::vector<Pose>& world);

/// The map alone. Bones that are not found stay -1.
[[nodiscard]] HumanoidMap detectHumanoid(const Skeleton& skeleton);

}  // namespace deixis::motion
