#include "app/window/picture_point.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::app {

namespace {

constexpr double nearest_m = 1e-6;

}  // namespace

Ray rayThrough(const Pose& stage_from_eye, double vertical_view_rad, double aspect, const PicturePoint& at) {
    const double half = std::tan(0.5 * vertical_view_rad);
    const Vec3 direction = stage_from_eye.orientation * Vec3(at.x * half * aspect, at.y * half, -1.0);
    return {stage_from_eye.position, glm::normalize(direction)};
}

std::optional<PicturePoint> inPicture(const Pose& stage_from_eye, double vertical_view_rad, double aspect,
                                      const Vec3& point) {
    const Vec3 seen = transformPoint(inverse(stage_from_eye), point);
    if (seen.z > -nearest_m) return std::nullopt;
    const double half = std::tan(0.5 * vertical_view_rad);
    return PicturePoint{seen.x / -seen.z / (half * aspect), seen.y / -seen.z / half};
}

}  // namespace deixis::app
