// Pointing geometry: the rays that people may read from a pointing arm, and the paper's measure. Pure
// functions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

enum class PointingRay : unsigned char {
    eye_fingertip,       ///< from between the eyes through the fingertip (Herbort & Kunde 2015)
    index_finger,        ///< along the index finger, from its knuckle
    forearm,             ///< elbow -> hand, the ray of equation 2
    shoulder_hand,       ///< shoulder -> hand joint
    shoulder_fingertip,  ///< shoulder -> fingertip
    elbow_fingertip,     ///< elbow -> fingertip: forearm and hand as one pointer
    head,                ///< where the face points, from between the eyes
};
constexpr std::array<PointingRay, 7> all_pointing_rays{
    PointingRay::eye_fingertip, PointingRay::index_finger,       PointingRay::forearm,
    PointingRay::shoulder_hand, PointingRay::shoulder_fingertip, PointingRay::elbow_fingertip,
    PointingRay::head};

[[nodiscard]] std::string_view pointingRayName(PointingRay ray);  ///< "eye-fingertip", "index-finger", ...
[[nodiscard]] Result<PointingRay> pointingRayFromName(std::string_view name);

/// The ray read from a world pose; it starts at its farther point (the fingertip or the hand), the head's
/// between the eyes. Its direction is zero where the two points that span it fall together.
[[nodiscard]] Ray pointingRay(const Skeleton& skeleton, const HumanoidMap& map,
                              const std::vector<Pose>& world, Side side, PointingRay kind);

/// Where the face points, unit length: the rest pose's direction ahead (across the line of the shoulders, or
/// of the hips), turned as the head is. Works on any skeleton whose rest pose looks straight ahead.
[[nodiscard]] Vec3 headDirection(const Skeleton& skeleton, const HumanoidMap& map,
                                 const std::vector<Pose>& world);

/// Midpoint between the eyes (the head joint if there are none).
[[nodiscard]] Vec3 eyePosition(const HumanoidMap& map, const std::vector<Pose>& world);

/// Tip of the index finger; the hand joint if there are no fingers.
[[nodiscard]] Vec3 fingertipPosition(const Skeleton& skeleton, const HumanoidMap& map,
                                     const std::vector<Pose>& world, Side side);

/// Angle between a ray and the direction from its origin to a point, radians.
[[nodiscard]] double angularError(const Ray& ray, const Vec3& target);

/// How far a point lies from a ray. Behind the ray's origin the nearest point of the ray is the origin
/// itself.
struct RayDistance {
    double distance_m = 0.0;
    bool points_away = false;  ///< the point lies behind the origin: the angular error is above 90 degrees
};
[[nodiscard]] RayDistance distanceToRay(const Ray& ray, const Vec3& point);

/// Which of several balls a reader of the ray would take: the one that the ray misses by the smallest angle,
/// seen from the ray's origin. Of equal ones the first.
struct BallChoice {
    std::size_t ball = 0;
    double error_rad = 0.0;
    /// Angle by which the next best ball is missed more; none if there is but one ball.
    std::optional<double> margin_rad{};
};
/// Empty if there are no balls.
[[nodiscard]] std::optional<BallChoice> chosenBall(const Ray& ray, const std::vector<Vec3>& balls);

/// Equation 2 of Deichler et al. (2023): theta = 1 - angle(hand->target, elbow->hand)/pi; (e^theta - 1)/e. In
/// [0, highest_pointing_reward].
[[nodiscard]] double pointingReward(const Vec3& elbow, const Vec3& hand, const Vec3& target);
/// The same of any line, in the forearm's place.
[[nodiscard]] double pointingReward(const Ray& line, const Vec3& target);
/// Without an error: (e - 1)/e.
constexpr double highest_pointing_reward = 0.63212055882855768;

}  // namespace deixis::motion
