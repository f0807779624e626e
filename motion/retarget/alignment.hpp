// Turning the avatar's bones so that it stands as another figure does; private to retargeting.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

/// Where a figure's bones start, and where those that have no bone behind them end.
struct BodyShape {
    std::array<std::optional<Vec3>, bone_count> start{};
    std::array<std::optional<Vec3>, bone_count> tip{};

    [[nodiscard]] const std::optional<Vec3>& at(Bone bone) const {
        return start[static_cast<std::size_t>(bone)];
    }
    /// From the start to the next bone's start or the tip, unit length; none where the figure does not tell.
    [[nodiscard]] std::optional<Vec3> direction(Bone bone) const;
};

[[nodiscard]] BodyShape shapeOf(const Skeleton& skeleton, const HumanoidMap& map,
                                const std::vector<Pose>& world);

/// The trunk's axes. Lines run from right to left.
struct TrunkAxes {
    Vec3 hip_line, hips_up, shoulder_line, chest_up;
};
/// With the line from between the feet to the head as up. Requires head, upper legs, feet, upper arms.
[[nodiscard]] TrunkAxes standingAxes(const BodyShape& shape);

/// Rotations, or angles, one for each bone.
using BoneTurns = std::array<Quat, bone_count>;
using BoneTwists = std::array<double, bone_count>;

/// For each bone the world rotation that takes the avatar's T pose to the shape: bones point the same way,
/// twisted as little as can be against the bone above, and then by `twist` (radians) about their own
/// direction.
[[nodiscard]] BoneTurns alignBody(const BodyShape& avatar, const TrunkAxes& avatar_axes,
                                  const BodyShape& shape, const TrunkAxes& axes, const BoneTwists& twist);

/// Limb bones with a hinge at one end: the plane in which elbow or knee bends tells their twist.
struct Hinge {
    Bone upper, lower, end;
    Vec3 bend;  ///< in the avatar's T pose, the way in which the lower bone bends
};
[[nodiscard]] const std::array<Hinge, 4>& hinges();

/// Collects how far limb bones are twisted from where their hinge bends in the avatar.
class HingeFit {
  public:
    /// `prior`: the weight of no twist at all; one look at a bend by a right angle weighs 0.83, by 10 degrees
    /// 0.
    HingeFit(const BodyShape& avatar, double prior) : avatar_(avatar), prior_(prior) {}

    /// One look at the body: the bones' world rotations as aligned so far, and where they are.
    void add(const BoneTurns& rotation, const BodyShape& shape);
    [[nodiscard]] double twist(Bone bone) const;

  private:
    const BodyShape& avatar_;
    double prior_;
    std::array<double, bone_count> cosine_{};
    std::array<double, bone_count> sine_{};
};

}  // namespace deixis::motion
