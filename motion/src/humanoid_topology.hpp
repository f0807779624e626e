// Bones by the shape of a figure: chains from hips to feet, shoulders to hands and fingers; private to
// humanoid mapping.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "humanoid_names.hpp"

namespace deixis::motion {

/// A skeleton's tree with its lengths at rest.
class FigureTree {
  public:
    explicit FigureTree(const Skeleton& skeleton);

    [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
    [[nodiscard]] int parent(int joint) const { return skeleton_.joints[at(joint)].parent; }
    [[nodiscard]] const std::vector<int>& children(int joint) const { return children_[at(joint)]; }
    [[nodiscard]] const Vec3& position(int joint) const { return world_[at(joint)].position; }
    [[nodiscard]] Vec3 tip(int joint) const { return tipPosition(skeleton_, world_, joint); }
    /// From a joint's parent on to the farthest end below the joint, along the bones.
    [[nodiscard]] double reach(int joint) const { return reach_[at(joint)]; }
    /// Joints from this one down, each time on to the child that reaches farthest.
    [[nodiscard]] std::vector<int> mainChain(int joint) const;
    [[nodiscard]] bool isAbove(int ancestor, int joint) const;  ///< or the same
    [[nodiscard]] int jointsBelow(int joint) const { return below_[at(joint)]; }
    [[nodiscard]] double boneLength(int joint) const;  ///< from its parent

  private:
    [[nodiscard]] static std::size_t at(int joint) { return static_cast<std::size_t>(joint); }

    const Skeleton& skeleton_;
    std::vector<Pose> world_;
    std::vector<std::vector<int>> children_;
    std::vector<double> reach_;
    std::vector<int> below_;  // joints, itself counted
};

/// Maps a figure of which names tell nothing but perhaps sides: a pair of like branches at the hips and
/// another above it. None where the figure has no such shape. `guessed_front`: it has no toes that point
/// ahead, so that its front was taken to be +z (-y where z is up).
[[nodiscard]] std::optional<HumanoidMap> mapByShape(const FigureTree& tree,
                                                    const std::vector<PlainName>& names, bool& guessed_front);

/// Fills in what follows from the neighbours: a limb's missing bones out of the joints above its hand or
/// foot, neck, collar bones, single toes, and fingers where three or more chains leave a hand.
void addByPlace(const FigureTree& tree, HumanoidMap& map);

}  // namespace deixis::motion
