// How much room a standing body takes: what it may hide from an observer.
#pragma once

#include <optional>
#include <vector>

#include "motion/pointing/body_checks.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// A body as capsules around its bones, as thick as those of the reference humanoid for its height (clothes
/// and hair of Deixis's own avatar lie within them; skirts and hats of others may not). Ends are rounded
/// to 0.1 mm, so that they are the same on every machine. `world` is its pose at ease; with `pointing_at` the
/// arm on that side is stretched at it, see stretchedArm(). Bones that the skeleton lacks are left out.
[[nodiscard]] std::vector<Capsule> bodyShape(const Skeleton& skeleton, const HumanoidMap& map,
                                             const std::vector<Pose>& world,
                                             const std::optional<Vec3>& pointing_at = {});

}  // namespace deixis::motion
