#include "pointing_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "body_noise.hpp"

namespace deixis::motion {

namespace {

/// The target as an actor sees it who errs by these angles.
Vec3 misjudged(const Vec3& target, const Vec3& eye, double azimuth_rad, double elevation_rad) {
    const Vec3 sight = target - eye;
    const double azimuth = azimuthOf(sight) + azimuth_rad;
    const double elevation = elevationOf(sight) + elevation_rad;
    const double across = std::cos(elevation);
    return eye + glm::length(sight) *
                     Vec3(across * std::sin(azimuth), std::sin(elevation), across * std::cos(azimuth));
}

Vec3 drawTarget(const TargetDraw& draw, Side hand, Random& random) {
    for (;;) {
        const double azimuth_deg = drawn(draw.azimuth_deg, random);
        const double radius = drawn(draw.radius_m, random);
        const double height = drawn(draw.height_m, random);
        const double outward_deg = hand == Side::left ? azimuth_deg : -azimuth_deg;
        if (outward_deg < -draw.crossing_deg) continue;
        // Within the crossing either hand serves, so each takes its half of those targets.
        if (std::abs(outward_deg) < draw.crossing_deg && random.uniform() < 0.5) continue;
        const double azimuth = radiansFromDegrees(azimuth_deg);
        return {radius * std::sin(azimuth), height, radius * std::cos(azimuth)};
    }
}

}  // namespace

PostureRequest bodyTakingPart(const PointingBody& body, const Vec3& target, Side hand,
                              const BodyShareParameters& shares) {
    PostureRequest request;
    request.hand = hand;
    const double azimuth = azimuthOf(target);
    const double elevation = elevationOf(target - body.eye(body.relaxed));
    request.torso_yaw_rad = shares.torso_yaw_share * azimuth;
    request.torso_pitch_rad = -shares.torso_pitch_share * elevation;
    request.torso_roll_rad = -shares.torso_roll_share * azimuth;
    request.head_yaw_rad = std::clamp(shares.head_yaw_share * (azimuth - request.torso_yaw_rad),
                                      -shares.head_yaw_limit_rad, shares.head_yaw_limit_rad);
    request.head_pitch_rad = -shares.head_pitch_share * elevation;
    request.shoulder_raise_share = shares.shoulder_raise_share;
    request.shoulder_forward_rad = radiansFromDegrees(shares.shoulder_forward_deg);
    return request;
}

PointingMotion humanTiming(const Vec3& target, Side hand, const TimingParameters& timing, Random& random) {
    PointingMotion motion;
    motion.hand = hand;
    motion.rest_before_s = drawn(timing.rest_s, random);
    motion.raise_s = timing.emphasis * drawn(timing.raise_s, random);
    motion.hold_s = timing.emphasis * drawn(timing.hold_s, random);
    motion.retract_s = drawn(timing.retract_s, random);
    motion.rest_after_s = drawn(timing.rest_s, random);
    motion.raise_bulge = drawn(timing.bulge, random);
    motion.retract_bulge = drawn(timing.bulge, random);
    motion.gaze = true;
    motion.gaze_at = target;
    return motion;
}

DemonstrationPlan planDemonstration(const PointingBody& body, const Vec3& target, Side hand,
                                    const DemonstrationParameters& parameters, std::uint64_t seed) {
    const PointingLineParameters& line = parameters.line;
    Random actor(parameters.library_seed, "actor");
    const double actor_bias = radiansFromDegrees(line.actor_bias_sd_deg);
    const double actor_azimuth = actor_bias * actor.normal();
    const double actor_elevation = actor_bias * actor.normal();

    Random random(seed, "demonstration");
    DemonstrationPlan plan;
    plan.target = target;
    plan.seed = seed;
    PostureRequest request = bodyTakingPart(body, target, hand, parameters.body);
    request.torso_yaw_rad += parameters.body.torso_yaw_sd_rad * random.normal();
    const double trial_bias = radiansFromDegrees(line.trial_bias_sd_deg);
    const double azimuth_error = actor_azimuth + trial_bias * random.normal();
    const double elevation_error = actor_elevation + trial_bias * random.normal();
    request.aim = misjudged(target, body.eye(body.relaxed), azimuth_error, elevation_error);
    request.origin_k = line.origin_k;
    request.extension = drawn(line.extension, random);
    request.index_alignment = line.index_alignment;
    request.wrist_limit_rad = radiansFromDegrees(line.wrist_limit_deg);
    request.knuckle_limit_rad = radiansFromDegrees(line.knuckle_limit_deg);
    request.swivel_offset_rad = radiansFromDegrees(parameters.arm.swivel_sd_deg) * random.normal();
    request.palm_inward_rad = radiansFromDegrees(drawn(line.palm_inward_deg, random));
    plan.motion = humanTiming(target, hand, parameters.timing, random);
    plan.motion.peak = solvePosture(body, request, parameters.arm);
    plan.motion.hold_end = plan.motion.peak;
    plan.motion.noise_share = 1.0;
    return plan;
}

std::vector<DemonstrationPlan> planLibrary(const PointingBody& body,
                                           const DemonstrationParameters& parameters) {
    std::vector<DemonstrationPlan> plans;
    Random random(parameters.library_seed, "library");
    const auto add = [&](Side hand, int count) {
        for (int i = 0; i < count; ++i) {
            const Vec3 target = drawTarget(parameters.targets, hand, random);
            plans.push_back(planDemonstration(body, target, hand, parameters, random.next()));
        }
    };
    add(Side::left, parameters.left_count);
    add(Side::right, parameters.right_count);
    return plans;
}

}  // namespace deixis::motion
