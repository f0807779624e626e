// The joints of a figure in a glTF file: which bones they play, and the turns that bring the file's rest pose
// to the T pose; private to reading avatars.
#pragma once

#include <string>
#include <vector>

#include "assets/tables/humanoid_file.hpp"
#include "motion/skeleton/humanoid.hpp"
#include "nodes.hpp"

namespace deixis::assets {

/// One joint. Positions are in the avatar's axes (y up, facing +z) and the file's unit.
struct RigJoint {
    int node = -1;
    int parent = -1;          ///< index in Rig::joints; not necessarily smaller
    std::string name;         ///< the node's
    Vec3 rest{0.0};           ///< in the file's rest pose
    Vec3 placed{0.0};         ///< in the T pose
    Quat turn = no_rotation;  ///< T pose from rest pose, about the joint
};

struct Rig {
    std::vector<RigJoint> joints;
    std::vector<int> joint_of_node;  ///< the joint that each node is or follows; -1 for none
    motion::HumanoidMap humanoid;    ///< indices in `joints`
    Quat avatar_from_file = no_rotation;
};

/// Joints are those of the skins that are drawn and those that VRM's map or a person (`said`, or null) names;
/// where these make no humanoid, all nodes. Refuses what is no humanoid, naming the bones that lack. Remarks
/// go to `remarks`.
[[nodiscard]] Rig readRig(const gltf::Document& document, const NodeTree& tree, const HumanoidWords* said,
                          std::vector<std::string>& remarks);

/// Turns the limbs to the T pose: arms along +-x with the palms down, legs down with the feet as they stood.
void turnToTPose(Rig& rig, std::vector<std::string>& remarks);

}  // namespace deixis::assets
