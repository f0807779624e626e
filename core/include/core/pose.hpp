// Positions, rotations and rays.
//
// Coordinates everywhere: metres, right-handed, y up; the avatar stands at the origin and faces +z, so its
// left is +x. A pose named `a_from_b` maps points from b to a; `a_from_b * b_from_c` is `a_from_c`.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace deixis {

using Vec3 = glm::dvec3;  ///< metres, or a direction
using Quat = glm::dquat;  ///< unit length, w first in the constructor

constexpr double pi = 3.14159265358979323846;
[[nodiscard]] constexpr double radiansFromDegrees(double degrees) {
    return degrees * pi / 180.0;
}
[[nodiscard]] constexpr double degreesFromRadians(double radians) {
    return radians * 180.0 / pi;
}

inline const Vec3 up{0.0, 1.0, 0.0};
inline const Quat no_rotation{1.0, 0.0, 0.0, 0.0};

/// A rigid transform: first the rotation, then the translation.
struct Pose {
    Vec3 position{0.0};
    Quat orientation{1.0, 0.0, 0.0, 0.0};
};

[[nodiscard]] Pose operator*(const Pose& a_from_b, const Pose& b_from_c);
[[nodiscard]] Vec3 transformPoint(const Pose& a_from_b, const Vec3& point_in_b);
[[nodiscard]] Pose inverse(const Pose& a_from_b);

/// A half-line. `direction` has unit length.
struct Ray {
    Vec3 origin{0.0};
    Vec3 direction{0.0, 0.0, 1.0};
};

/// Angle between two directions of any length but zero, radians in [0, pi]; accurate for small angles too.
[[nodiscard]] double angleBetween(const Vec3& a, const Vec3& b);

/// The shortest rotation that takes direction `from` to direction `to` (any length but zero).
[[nodiscard]] Quat rotationBetween(const Vec3& from, const Vec3& to);

/// Axis times angle; its length is below pi where w of the rotation is not negative, else beyond it. And
/// back.
[[nodiscard]] Vec3 rotationVector(const Quat& rotation);
[[nodiscard]] Quat rotationBy(const Vec3& rotation_vector);

/// Rotation about +y that turns +z towards +x by `angle_rad`.
[[nodiscard]] Quat yawRotation(double angle_rad);

/// Distance along the ray (>= 0) at which it first meets the sphere, or a negative number where it misses.
[[nodiscard]] double distanceToSphere(const Ray& ray, const Vec3& centre, double radius_m);

}  // namespace deixis
