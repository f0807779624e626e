// An arm as it would point at a target, without a clip: where it will be seen, and what it may hide.
#pragma once

#include <vector>

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// The hand on the target's side; the right one straight ahead.
[[nodiscard]] Side handFor(const Vec3& target);

struct StretchedArm {
    Vec3 shoulder{0.0};  ///< joint of the upper arm
    Vec3 fingertip{0.0};
};

/// The arm of a standing body (`world`: its pose at ease), stretched to its full length, with the fingertip
/// on the line from between the eyes to the target, as people point (Herbort & Kunde 2015); no farther than
/// the target. Where that line lies out of the arm's reach, straight from the shoulder. The body must have
/// both arms and a head.
[[nodiscard]] StretchedArm stretchedArm(const Skeleton& skeleton, const HumanoidMap& map,
                                        const std::vector<Pose>& world, Side side, const Vec3& target);

}  // namespace deixis::motion
