#include "motion/pointing/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/mapping.hpp"

namespace deixis::motion {

namespace {

using World = std::vector<Pose>;

Result<void> checkNumbers(const std::vector<World>& world) {
    for (std::size_t f = 0; f < world.size(); ++f)
        for (const Pose& pose : world[f])
            if (!std::isfinite(pose.position.x + pose.position.y + pose.position.z))
                return fail("", fmt::format("a joint's position in frame {} is not a number", f),
                            "Repair the clip");
    return {};
}

std::vector<Vec3> part(const std::vector<Vec3>& trajectory, int first, int last) {
    return {trajectory.begin() + first, trajectory.begin() + last + 1};
}

std::optional<RayMeasures> measureRay(const Clip& clip, const HumanoidMap& map,
                                      const std::vector<World>& world, const GesturePhases& phases,
                                      PointingRay kind, const Vec3& target) {
    RayMeasures out;
    out.min_error_rad = pi;
    std::vector<Vec3> directions;
    const int middle = (phases.peak_frame + phases.hold_frame) / 2;
    for (int f = phases.peak_frame; f <= phases.hold_frame; ++f) {
        const Ray ray =
            pointingRay(clip.skeleton, map, world[static_cast<std::size_t>(f)], phases.hand, kind);
        if (ray.direction == Vec3(0.0)) return std::nullopt;
        const double error = angularError(ray, target);
        out.min_error_rad = std::min(out.min_error_rad, error);
        directions.push_back(ray.direction);
        if (f != middle) continue;
        out.middle = ray;
        out.error_rad = error;
        const RayDistance distance = distanceToRay(ray, target);
        out.distance_m = distance.distance_m;
        out.points_away = distance.points_away;
    }
    out.steadiness = directionSteadiness(directions, clip.frame_time_s);
    return out;
}

}  // namespace

Result<PointingMeasures> measurePointing(const Clip& clip, const HumanoidMap& map,
                                         const std::optional<Vec3>& target,
                                         const std::optional<GesturePhases>& phases) {
    if (const auto missing = missingBones(map, pointingBones()); !missing.empty())
        return fail("", fmt::format("found no bone '{}' in the clip's skeleton", fmt::join(missing, "', '")),
                    "Pointing is measured on a figure with hips, head and both arms");
    const std::vector<World> world = worldPoses(clip);
    if (auto checked = checkNumbers(world); !checked) return tl::unexpected(checked.error());

    PointingMeasures out;
    const Side side = phases ? phases->hand : recognisedHand(world, map).hand;
    const ArmBones arm = armBones(side);
    const std::vector<Vec3> hand = jointTrajectory(world, map[arm.hand]);
    if (phases) {
        if (auto checked = checkPhases(*phases, clip.frameCount()); !checked)
            return tl::unexpected(checked.error());
        out.phases = *phases;
    } else {
        const auto detected = detectPhases(hand, side, clip.frame_time_s);
        if (!detected) return tl::unexpected(detected.error());
        out.detected = *detected;
        out.phases = detected->phases;
    }
    const GesturePhases& p = out.phases;
    out.hold_s = clip.frame_time_s * (p.hold_frame - p.peak_frame);
    out.time_to_peak_s = clip.frame_time_s * (p.peak_frame - p.onset_frame);
    const auto speed = speeds(hand, clip.frame_time_s);
    const auto onset = speed.begin() + p.onset_frame;
    const auto fastest = std::max_element(onset, speed.begin() + p.peak_frame + 1);
    out.peak_speed_m_s = *fastest;
    out.time_to_peak_speed_s = clip.frame_time_s * static_cast<double>(fastest - onset);
    std::vector<Vec3> fingertip;
    for (int f = p.peak_frame; f <= p.hold_frame; ++f)
        fingertip.push_back(fingertipPosition(clip.skeleton, map, world[static_cast<std::size_t>(f)], side));
    out.fingertip = steadiness(fingertip, clip.frame_time_s);
    const std::vector<Vec3> raise = part(hand, p.onset_frame, p.peak_frame);
    out.log_dimensionless_jerk = logDimensionlessJerk(raise, clip.frame_time_s);
    out.spectral_arc_length = spectralArcLength(speeds(raise, clip.frame_time_s), clip.frame_time_s);
    if (target) {
        for (const PointingRay kind : all_pointing_rays)
            out.rays[static_cast<std::size_t>(kind)] = measureRay(clip, map, world, p, kind, *target);
        const std::vector<Vec3> elbow = jointTrajectory(world, map[arm.lower_arm]);
        const auto reward = [&](int f) {
            const auto i = static_cast<std::size_t>(f);
            return pointingReward(elbow[i], hand[i], *target);
        };
        out.reward = reward((p.peak_frame + p.hold_frame) / 2);
        out.max_reward = 0.0;
        for (int f = p.peak_frame; f <= p.hold_frame; ++f)
            out.max_reward = std::max(*out.max_reward, reward(f));
    }
    out.foot_skate = footSkate(world, map, clip.frame_time_s);
    out.limit_violations = jointLimitViolations(clip.skeleton, map, world);
    out.intersections = selfIntersections(clip.skeleton, map, world);
    return out;
}

}  // namespace deixis::motion
