// A rigid skeleton from glTF nodes, which may scale.
#pragma once

#include <glm/mat3x3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "assets/gltf/gltf_document.hpp"
#include "gltf_tracks.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::assets::gltf {

/// Which nodes become joints: in the file's order where parents stand before children there, else depth
/// first.
struct JointNodes {
    std::vector<int> nodes;                      ///< of each joint; -1 for a root that joins several
    std::vector<int> parents;                    ///< of each joint, a joint; -1 for the root
    std::vector<std::string> names;              ///< unique
    std::vector<std::pair<int, int>> end_sites;  ///< joint and the node that is its tip

    [[nodiscard]] int jointOf(int node) const;  ///< -1 where the node is no joint
};

/// With a skin: its joints, the nodes that move, humanoid bones, and all above them. Without: all nodes under
/// the roots of those that move; without such: all nodes. A leaf named as its parent and "_End" is its end
/// site. Throws Rejection where the file has no nodes.
[[nodiscard]] JointNodes chooseJoints(const Document& document, const std::vector<Track>& tracks,
                                      std::vector<std::string>& remarks);

/// Poses of those joints at any time.
class Poser {
  public:
    /// Positions are multiplied by `metres`; `turn` turns the whole figure about the origin.
    Poser(const Document& document, const JointNodes& joints, const std::vector<Track>& tracks, double metres,
          const Quat& turn);

    [[nodiscard]] motion::Skeleton skeleton() const;
    [[nodiscard]] motion::LocalPose at(double time_s, double snap_s) const;
    /// What was done about scale that a rigid skeleton does not have; empty where nothing is lost.
    [[nodiscard]] std::string scaleRemark() const;

  private:
    struct Transform {
        Vec3 translation{0.0}, scale{1.0};
        Quat rotation{1.0, 0.0, 0.0, 0.0};
    };

    [[nodiscard]] std::vector<Transform> restTransforms() const;
    void findScales(const std::vector<Track>& tracks);
    [[nodiscard]] motion::LocalPose pose(const std::vector<Transform>& transforms) const;
    [[nodiscard]] motion::LocalPose rigidPose(const std::vector<Transform>& transforms) const;
    [[nodiscard]] motion::LocalPose nearestPose(const std::vector<Transform>& transforms) const;
    /// Each joint's exact linear map to the world, and the nearest rigid pose there.
    struct Nearest {
        std::vector<glm::dmat3> linear;
        std::vector<Pose> world;
    };
    [[nodiscard]] Nearest nearest(const std::vector<Transform>& transforms) const;

    const Document& document_;
    const JointNodes& joints_;
    std::vector<std::pair<std::size_t, Track>> tracks_;  // joint and track
    double metres_;
    Quat turn_;
    // Where every node scales evenly and always by the same, the product of the scales above each joint, with
    // and without its own; else scales are kept and poses are the nearest rigid ones.
    bool even_ = true;
    std::vector<double> scale_above_, scale_below_;
    std::string uneven_node_;
    bool mirrors_ = false;
};

}  // namespace deixis::assets::gltf
