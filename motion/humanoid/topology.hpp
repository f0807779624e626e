// Bones by the shape of a figure: chains from hips to feet, shoulders to hands and fingers; private to
// humanoid mapping.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "names.hpp"

namespace deixis::motion {

/// A skeleton's tree with its lengths at rest.
class FigureTree {
  public:
    /// `names`: of the skeleton's joints. Both must outlive this.
    FigureTree(const Skeleton& skeleton, const std::vector<PlainName>& names);

    [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
    [[nodiscard]] const std::vector<PlainName>& names() const { return names_; }
    [[nodiscard]] int parent(int joint) const { return skeleton_.joints[at(joint)].parent; }
    [[nodiscard]] const std::vector<int>& children(int joint) const { return children_[at(joint)]; }
    [[nodiscard]] const Vec3& position(int joint) const { return world_[at(joint)].position; }
    [[nodiscard]] Vec3 tip(int joint) const { return tipPosition(skeleton_, world_, joint); }
    /// From a joint's parent on to the farthest end below the joint, along the bones.
    [[nodiscard]] double reach(int joint) const { return reach_[at(joint)]; }
    [[nodiscard]] double wholeReach() const { return whole_; }  ///< of the root that reaches farthest
    /// Joints from this one down, each time on to the child that reaches farthest.
    [[nodiscard]] std::vector<int> mainChain(int joint) const;
    /// Of a chain the joints that can be a limb's bones: no helpers, and of joints in one place the lowest,
    /// which moves what comes next.
    [[nodiscard]] std::vector<int> bonesOf(const std::vector<int>& chain) const;
    [[nodiscard]] bool isAbove(int ancestor, int joint) const;  ///< or the same
    [[nodiscard]] int jointsBelow(int joint) const { return below_[at(joint)]; }
    [[nodiscard]] double boneLength(int joint) const;           ///< from its parent
    [[nodiscard]] double wayTo(int joint, int ancestor) const;  ///< along the bones

  private:
    [[nodiscard]] static std::size_t at(int joint) { return static_cast<std::size_t>(joint); }

    const Skeleton& skeleton_;
    const std::vector<PlainName>& names_;
    std::vector<Pose> world_;
    std::vector<std::vector<int>> children_;
    std::vector<double> reach_;
    std::vector<int> below_;  // joints, itself counted
    double whole_ = 0.0;      // the farthest that any root reaches
};

/// Maps a figure of which names tell nothing but perhaps sides: a pair of like branches at the hips and
/// another above it. None where the figure has no such shape. `guessed_front`: it has no toes that point
/// ahead, so that its front was taken to be +z (-y where z is up).
[[nodiscard]] std::optional<HumanoidMap> mapByShape(const FigureTree& tree, bool& guessed_front);

/// Fills in what follows from the neighbours: a limb's missing bones out of the joints above its hand or
/// foot, neck, collar bones, single toes, and fingers where three or more chains leave a hand.
void addByPlace(const FigureTree& tree, HumanoidMap& map);

}  // namespace deixis::motion
