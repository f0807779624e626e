#include "core/pose.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace deixis {

Pose operator*(const Pose& a_from_b, const Pose& b_from_c) {
    return {a_from_b.position + a_from_b.orientation * b_from_c.position,
            a_from_b.orientation * b_from_c.orientation};
}

Vec3 transformPoint(const Pose& a_from_b, const Vec3& point_in_b) {
    return a_from_b.position + a_from_b.orientation * point_in_b;
}

Pose inverse(const Pose& a_from_b) {
    const Quat b_from_a = glm::conjugate(a_from_b.orientation);
    return {b_from_a * -a_from_b.position, b_from_a};
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

Quat rotationBetween(const Vec3& from, const Vec3& to) {
    const Vec3 a = glm::normalize(from);
    const Vec3 b = glm::normalize(to);
    const double cosine = glm::dot(a, b);
    if (cosine < -1.0 + 1e-12) {
        // Opposite directions: any axis across will do.
        const Vec3 helper = std::abs(a.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        const Vec3 axis = glm::normalize(glm::cross(a, helper));
        return Quat(0.0, axis.x, axis.y, axis.z);
    }
    const Vec3 axis = glm::cross(a, b);
    return glm::normalize(Quat(1.0 + cosine, axis.x, axis.y, axis.z));
}

Vec3 rotationVector(const Quat& rotation) {
    const Vec3 v(rotation.x, rotation.y, rotation.z);
    const double sine = glm::length(v);
    if (sine < 1e-12) return Vec3(0.0);
    return v * (2.0 * std::atan2(sine, rotation.w) / sine);
}

Quat rotationBy(const Vec3& rotation_vector) {
    const double angle = glm::length(rotation_vector);
    if (angle < 1e-12) return no_rotation;
    return glm::angleAxis(angle, rotation_vector / angle);
}

Quat yawRotation(double angle_rad) {
    return {std::cos(angle_rad / 2.0), 0.0, std::sin(angle_rad / 2.0), 0.0};
}

double distanceToSphere(const Ray& ray, const Vec3& centre, double radius_m) {
    const Vec3 to_centre = centre - ray.origin;
    const double along = glm::dot(to_centre, ray.direction);
    const double across2 = glm::dot(to_centre, to_centre) - along * along;
    const double half_chord2 = radius_m * radius_m - across2;
    if (half_chord2 < 0.0) return -1.0;
    const double half_chord = std::sqrt(half_chord2);
    if (along + half_chord < 0.0) return -1.0;
    return along >= half_chord ? along - half_chord : 0.0;
}

}  // namespace deixis
