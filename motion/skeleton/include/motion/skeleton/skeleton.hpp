// A skeleton: named joints in a tree, and poses of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pose.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// One joint. `rest` is its pose in its parent at rest (BVH's OFFSET has no rotation; a glTF node may have
/// one).
struct Joint {
    std::string name;
    int parent = -1;  ///< index of the parent joint, smaller than this joint's own; -1 for a root
    Pose rest{};
    std::optional<Vec3> end_site{};  ///< tip of a leaf joint, metres in the joint's frame
};

/// Invariants: 1. parents stand before their children; 2. joint 0 is a root; 3. names are unique.
struct Skeleton {
    std::vector<Joint> joints;

    [[nodiscard]] int size() const { return static_cast<int>(joints.size()); }
    [[nodiscard]] int find(std::string_view name) const;  ///< index, or -1
};

/// A pose of every joint in its parent's frame; sizes equal the skeleton's.
struct LocalPose {
    std::vector<Pose> joints;
};

[[nodiscard]] LocalPose restPose(const Skeleton& skeleton);

/// Forward kinematics: root_from_joint for every joint, in the frame in which the skeleton's root is given.
/// `out` is resized; give the same vector each frame to save the allocation.
void worldPose(const Skeleton& skeleton, const LocalPose& pose, std::vector<Pose>& out);
[[nodiscard]] std::vector<Pose> worldPose(const Skeleton& skeleton, const LocalPose& pose);

/// The map of a skeleton whose joints carry the VRM names themselves, as Deixis's own avatar does.
[[nodiscard]] HumanoidMap mapByVrmNames(const Skeleton& skeleton);

/// The position of a joint's tip: its end site where it has one, else its own position.
[[nodiscard]] Vec3 tipPosition(const Skeleton& skeleton, const std::vector<Pose>& world, int joint);

}  // namespace deixis::motion
