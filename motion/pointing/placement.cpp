// Where a clip's figure stands in its first frame, and how it comes to the origin.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "motion/pointing/pointing_accuracy.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr double near_origin_m = 0.25;
constexpr double near_floor_m = 0.2;
constexpr double facing_rad = radiansFromDegrees(20.0);

struct Figure {
    const HumanoidMap& map;
    std::vector<Pose> world;

    [[nodiscard]] std::optional<Vec3> at(Bone bone) const {
        if (!map.has(bone)) return std::nullopt;
        return world[static_cast<std::size_t>(map[bone])].position;
    }

    /// From right to left, where the figure tells.
    [[nodiscard]] std::optional<Vec3> lateral() const {
        for (const auto& [left, right] :
             {std::pair{leftUpperLeg, rightUpperLeg}, std::pair{leftUpperArm, rightUpperArm}})
            if (at(left) && at(right)) return *at(left) - *at(right);
        return std::nullopt;
    }
};

/// The axis of the coordinates that a direction is nearest to.
Vec3 nearestAxis(const Vec3& direction) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
    Vec3 nearest(0.0);
    nearest[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
    return nearest;
}

}  // namespace

Placement placementOf(const Clip& clip, const HumanoidMap& map) {
    const Figure figure{map, worldPose(clip.skeleton, clip.frames.front())};
    const auto hips_at = figure.at(hips);
    const auto head_at = figure.at(head) ? figure.at(head) : figure.at(neck);
    const auto lateral = figure.lateral();
    Placement placement;
    if (!hips_at || !head_at || !lateral || glm::length(*head_at - *hips_at) < 1e-6) return placement;

    Pose& pose = placement.stage_from_clip;
    if (const Vec3 axis = nearestAxis(*head_at - *hips_at); axis.y < 0.5) {
        pose.orientation = rotationBetween(axis, up);
        placement.moved = true;
    }
    const Vec3 forward = glm::cross(pose.orientation * *lateral, up);
    if (const double yaw = std::atan2(forward.x, forward.z);
        glm::length(forward) > 1e-6 && std::abs(yaw) > facing_rad) {
        pose.orientation = yawRotation(-yaw) * pose.orientation;
        placement.moved = true;
    }
    const Vec3 turned_hips = pose.orientation * *hips_at;
    if (std::hypot(turned_hips.x, turned_hips.z) > near_origin_m) {
        pose.position -= Vec3(turned_hips.x, 0.0, turned_hips.z);
        placement.moved = true;
    }
    std::optional<double> lowest;
    for (const Bone bone : {leftFoot, rightFoot, leftToes, rightToes})
        if (const auto foot = figure.at(bone)) {
            const double height = (pose.orientation * *foot).y;
            lowest = std::min(lowest.value_or(height), height);
        }
    if (lowest && std::abs(*lowest) > near_floor_m) {
        pose.position.y -= *lowest;
        placement.moved = true;
    }
    return placement;
}

}  // namespace deixis::motion
