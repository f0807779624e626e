#include "motion/synthesis/gesture_trajectories.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "body_noise.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/pointing/stretched_arm.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "pointing_motion.hpp"
#include "pointing_posture.hpp"

namespace deixis::motion {

namespace {

constexpr std::size_t phase_count = std::tuple_size_v<PhaseDurations>;

Ray fingertipRay(const PointingBody& body, const LocalPose& pose, Side hand) {
    return pointingRay(body.skeleton, body.map, worldPose(body.skeleton, pose), hand,
                       PointingRay::eye_fingertip);
}

Vec3 pointedAt(const PointingBody& body, const Demonstration& demonstration) {
    const GeneratedClip& made = demonstration.gesture;
    const auto middle = static_cast<std::size_t>((made.peak_frame + made.hold_frame) / 2);
    const Ray ray = fingertipRay(body, made.clip.frames[middle], made.hand);
    const Vec3 eye = body.eye(body.relaxed);
    const double far = glm::length(demonstration.target - eye);
    const Vec3 from = ray.origin - eye;
    const double along = glm::dot(from, ray.direction);
    const double root = along * along - glm::dot(from, from) + far * far;
    return ray.origin + (std::sqrt(std::max(0.0, root)) - along) * ray.direction;
}

}  // namespace

Result<GestureTrajectories> GestureTrajectories::of(const Skeleton& avatar, double eye_limit_rad) {
    auto body = makePointingBody(avatar);
    if (!body) return tl::unexpected(body.error());
    return GestureTrajectories(std::move(*body), eye_limit_rad);
}

GestureTrajectories::GestureTrajectories(PointingBody body, double eye_limit_rad)
    : body_(std::make_shared<const PointingBody>(std::move(body))),
      features_(*body_),
      eye_limit_rad_(eye_limit_rad) {}

std::size_t GestureTrajectories::size() const {
    return phase_count + features_.size() * PhaseTrajectory::coefficient_count;
}

std::vector<double> GestureTrajectories::seen(const Vec3& place_m) const {
    const Vec3 there = place_m - body_->eye(body_->relaxed);
    return {azimuthOf(there), elevationOf(there), 1.0 / std::max(0.3, glm::length(there))};
}

GestureTrajectories::Observation GestureTrajectories::observe(const Demonstration& demonstration) const {
    const bool left = demonstration.gesture.hand == Side::left;
    const Demonstration one = left ? mirrored(demonstration) : demonstration;
    const Clip& clip = one.gesture.clip;
    const PhaseDurations durations = durationsOf(one.gesture, clip.frameCount(), clip.frame_time_s);
    Observation out;
    out.place_m = pointedAt(*body_, one);
    out.seen = seen(out.place_m);
    for (const double duration : durations) out.trajectory.push_back(std::log(duration));
    const auto fit = fitTrajectory(features_.encode(clip), clip.frame_time_s, durations);
    out.trajectory.insert(out.trajectory.end(), fit.begin(), fit.end());
    return out;
}

PhaseDurations GestureTrajectories::durations(std::span<const double> trajectory) const {
    PhaseDurations out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::clamp(std::exp(trajectory[i]), 0.05, 10.0);
    return out;
}

LocalPose GestureTrajectories::poseAt(std::span<const double> trajectory, double aligned_time) const {
    LocalPose pose = features_.decode(trajectoryAt(trajectory.subspan(phase_count), aligned_time));
    for (const Bone bone : {Bone::leftEye, Bone::rightEye})
        if (Quat* eye = body_->find(pose, bone)) *eye = turnedAtMost(*eye, eye_limit_rad_);
    return pose;
}

LocalPose GestureTrajectories::pointingPose(std::span<const double> trajectory) const {
    const PhaseDurations lasting = durations(trajectory);
    return poseAt(trajectory, PhaseTrajectory::aligned(lasting[0] + lasting[1] + 0.5 * lasting[2], lasting));
}

std::array<double, 2> GestureTrajectories::missed_rad(std::span<const double> trajectory,
                                                      const Vec3& place_m) const {
    const Ray ray = fingertipRay(*body_, pointingPose(trajectory), Side::right);
    const Vec3 there = place_m - ray.origin;
    const double azimuth = azimuthOf(ray.direction) - azimuthOf(there);
    return {std::remainder(azimuth, 2.0 * pi) * std::cos(elevationOf(there)),
            elevationOf(ray.direction) - elevationOf(there)};
}

std::array<Vec3, 3> GestureTrajectories::arm_m(std::span<const double> trajectory,
                                               double aligned_time) const {
    const auto world = worldPose(body_->skeleton, poseAt(trajectory, aligned_time));
    return {world[body_->joint(Bone::rightLowerArm)].position, world[body_->joint(Bone::rightHand)].position,
            fingertipPosition(body_->skeleton, body_->map, world, Side::right)};
}

GeneratedClip GestureTrajectories::perform(
    const GenerationRequest& asked, std::string_view stream,
    const std::function<std::vector<double>(const Vec3&)>& trajectoryTo) const {
    if (handFor(asked.target) == Side::right) return rightHanded(trajectoryTo(asked.target), asked, stream);
    return mirrored({asked.target, rightHanded(trajectoryTo(mirrored(asked.target)), asked, stream)}).gesture;
}

GeneratedClip GestureTrajectories::rightHanded(const std::vector<double>& trajectory,
                                               const GenerationRequest& asked,
                                               std::string_view stream) const {
    PhaseDurations lasting = durations(trajectory);
    lasting[2] = asked.settings.hold_s.value_or(lasting[2]);

    PointingMotion motion;
    motion.hand = Side::right;
    motion.rest_before_s = lasting[0];
    motion.raise_s = lasting[1];
    motion.hold_s = lasting[2];
    motion.retract_s = lasting[3];
    motion.rest_after_s = lasting[4];
    const auto poseAfter = [&](double time_s) {
        return poseAt(trajectory, PhaseTrajectory::aligned(time_s, lasting));
    };
    motion.peak = poseAfter(motion.rest_before_s + motion.raise_s + 0.5 * motion.hold_s);
    motion = heldAs(motion, asked.settings, *body_);

    Random random(asked.seed, stream);
    const std::array<Wave, 2> waves{Wave(motion.wander_hz, random), Wave(motion.wander_hz, random)};
    GeneratedClip out = emptyClip(*body_, motion);
    for (std::size_t f = 0; f < out.clip.frames.size(); ++f) {
        const double time_s =
            std::min(static_cast<double>(f) * out.clip.frame_time_s, wholeDuration_s(motion));
        LocalPose pose = poseAfter(time_s);
        const double onset_s = motion.rest_before_s;
        const double hold_s = onset_s + motion.raise_s + motion.hold_s;
        const double raised = minimumJerk((time_s - onset_s) / motion.raise_s) -
                              minimumJerk((time_s - hold_s) / motion.retract_s);
        const double wander = motion.wander_rad * raised * raised;
        Quat& arm = *body_->find(pose, Bone::rightUpperArm);
        arm = glm::normalize(arm *
                             rotationBy({0.0, wander * waves[0].at(time_s), wander * waves[1].at(time_s)}));
        out.clip.frames[f] = std::move(pose);
    }
    makeContinuous(out.clip.frames);
    return out;
}

std::vector<double> asNearAs(const GaussianProcess& process, std::vector<double> seen) {
    const auto [farthest, nearest] =
        std::minmax_element(process.inputs().begin(), process.inputs().end(),
                            [](const auto& one, const auto& other) { return one.back() < other.back(); });
    seen.back() = std::clamp(seen.back(), farthest->back(), nearest->back());
    return seen;
}

GaussianProcess trajectoryRegression(const std::vector<GestureTrajectories::Observation>& observations) {
    constexpr std::array<double, 6> lengths_rad{0.4, 0.6, 0.9, 1.3, 1.9, 2.8};
    constexpr std::array<double, 8> noises{3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0};
    std::vector<std::vector<double>> inputs, outputs;
    for (const auto& one : observations) {
        inputs.push_back(one.seen);
        outputs.push_back(one.trajectory);
    }
    return GaussianProcess::fitted(inputs, outputs, lengths_rad, noises);
}

}  // namespace deixis::motion
