#include "motion/pointing/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace deixis::motion {

namespace {

using enum Bone;

std::vector<Pose> worldOf(const Clip& clip, int frame) {
    return worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(frame)]);
}

}  // namespace

Pose figureFromClip(const Clip& clip, const HumanoidMap& map, int frame) {
    const auto world = worldOf(clip, frame);
    const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(map[bone])].position; };
    if (!map.has(hips)) return {};
    for (const auto& [left, right] :
         {std::pair{leftUpperLeg, rightUpperLeg}, std::pair{leftUpperArm, rightUpperArm}}) {
        if (!map.has(left) || !map.has(right)) continue;
        const Vec3 ahead = glm::cross(at(left) - at(right), up);
        return inverse(Pose{{at(hips).x, 0.0, at(hips).z}, yawRotation(std::atan2(ahead.x, ahead.z))});
    }
    return {};
}

Pose figureOnFloorFromClip(const Clip& clip, const HumanoidMap& map) {
    constexpr double ankle_of_leg = 0.104;  // as in the reference humanoid
    Pose pose = figureFromClip(clip, map, 0);
    const auto world = worldOf(clip, 0);
    const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(map[bone])].position; };
    std::optional<double> floor;
    for (const auto& [thigh, shin, foot] : {std::array{leftUpperLeg, leftLowerLeg, leftFoot},
                                            std::array{rightUpperLeg, rightLowerLeg, rightFoot}}) {
        if (!map.has(thigh) || !map.has(shin) || !map.has(foot)) continue;
        const double leg_m = glm::length(at(shin) - at(thigh)) + glm::length(at(foot) - at(shin));
        const double below = at(foot).y - ankle_of_leg * leg_m;
        floor = std::min(floor.value_or(below), below);
    }
    pose.position.y -= floor.value_or(0.0);
    return pose;
}

bool standsAway(const Clip& clip, const HumanoidMap& map) {
    constexpr double near_m = 0.5;
    constexpr double facing_rad = radiansFromDegrees(30.0);
    const Pose clip_from_figure = inverse(figureFromClip(clip, map, 0));
    return glm::length(clip_from_figure.position) >= near_m ||
           glm::angle(clip_from_figure.orientation) >= facing_rad;
}

}  // namespace deixis::motion
