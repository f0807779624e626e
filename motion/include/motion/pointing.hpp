// Pointing geometry: the rays that people may read from a pointing arm, and the paper's measure. Pure
// functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton.hpp"

namespace deixis::motion {

enum class PointingRay : unsigned char { eye_fingertip, index_finger, forearm, shoulder_hand };
[[nodiscard]] std::string_view pointingRayName(PointingRay ray);  ///< "eye-fingertip", "index-finger", ...
[[nodiscard]] Result<PointingRay> pointingRayFromName(std::string_view name);

/// The ray read from a world pose; it starts at its farther point (the fingertip or the hand).
[[nodiscard]] Ray pointingRay(const Skeleton& skeleton, const HumanoidMap& map,
                              const std::vector<Pose>& world, Side side, PointingRay kind);

/// Midpoint between the eyes (the head joint where there are none).
[[nodiscard]] Vec3 eyePosition(const HumanoidMap& map, const std::vector<Pose>& world);

/// Tip of the index finger; the hand joint where there are no fingers.
[[nodiscard]] Vec3 fingertipPosition(const Skeleton& skeleton, const HumanoidMap& map,
                                     const std::vector<Pose>& world, Side side);

/// Angle between a ray and the direction from its origin to a point, radians.
[[nodiscard]] double angularError(const Ray& ray, const Vec3& target);

/// Equation 2 of Deichler et al. (2023): theta = 1 - angle(hand->target, elbow->hand)/pi; (e^theta - 1)/e. In
/// [0, 0.632].
[[nodiscard]] double pointingReward(const Vec3& elbow, const Vec3& hand, const Vec3& target);

}  // namespace deixis::motion
