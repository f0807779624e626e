#include "pointing_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "body_noise.hpp"
#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/axes.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "pointing_posture.hpp"

namespace deixis::motion {

namespace {

/// 0 at rest, 1 in the pointing posture.
struct Trajectory {
    double arm = 0.0;
    double trunk = 0.0;
    double head = 0.0;
    double gaze = 0.0;
    double fingers = 0.0;
    double held = 0.0;    ///< share of the hold that has passed
    double moving = 0.0;  ///< 1 at the peak speed of the hand, 0 still
};

struct Times {
    double onset, peak, hold, end, whole;
};

Times timesOf(const PointingMotion& m) {
    const double onset = m.rest_before_s;
    const double peak = onset + m.raise_s;
    const double hold = peak + m.hold_s;
    const double end = hold + m.retract_s;
    return {onset, peak, hold, end, end + m.rest_after_s};
}

class Performance {
  public:
    Performance(const PointingBody& body, const PointingMotion& motion,
                const DemonstrationParameters& parameters, Random& random)
        : body_(body),
          motion_(motion),
          parameters_(parameters),
          random_(random),
          times_(timesOf(motion)),
          bones_(armBones(motion.hand)),
          noise_(channels, SmoothNoise(parameters.noise)),
          drift_{Wave(parameters.noise.hold_drift_hz, random), Wave(parameters.noise.hold_drift_hz, random)},
          sway_{Wave(parameters.noise.sway_hz, random), Wave(parameters.noise.sway_hz, random)},
          wander_{Wave(motion.wander_hz, random), Wave(motion.wander_hz, random)},
          breath_angular_(2.0 * pi * drawn(parameters.noise.breathing_hz, random)),
          breath_phase_(random.uniform(0.0, 2.0 * pi)) {
        raise_flexion_ = passingFlexion(motion.peak, motion.raise_bulge);
        retract_flexion_ = passingFlexion(motion.hold_end, motion.retract_bulge);
        for (const Bone bone : {Bone::neck, Bone::head})
            if (body.map.has(bone)) head_joints_.push_back(body.joint(bone));
        for (const Bone bone : {bones_.shoulder, bones_.upper_arm, bones_.lower_arm, bones_.hand})
            if (body.map.has(bone)) arm_joints_.push_back(body.joint(bone));
        for (const Bone bone : {Bone::spine, Bone::chest, Bone::upperChest})
            if (body.map.has(bone)) trunk_joints_.push_back(body.joint(bone));
        const auto& fingers = body.fingers[static_cast<std::size_t>(motion.hand)];
        finger_joints_.assign(fingers.begin(), fingers.end());
    }

    /// The pose at a time; to be asked for frame by frame, as the noise continues with each.
    LocalPose at(double time_s) {
        const Trajectory trajectory = trajectoryAt(time_s);
        LocalPose pose = body_.relaxed;
        turn(pose, trunk_joints_, trajectory.trunk, trajectory.held);
        turn(pose, head_joints_, trajectory.head, trajectory.held);
        turn(pose, arm_joints_, trajectory.arm, trajectory.held);
        turn(pose, finger_joints_, trajectory.fingers, trajectory.held);
        bendInPassing(pose, trajectory.arm, time_s < times_.peak ? raise_flexion_ : retract_flexion_);
        // A clip begins and ends in the stance at ease itself.
        const double presence = minimumJerk(std::min(time_s, times_.whole - time_s) / fade_s);
        if (motion_.noise_share > 0.0 || motion_.wander_rad > 0.0)
            addNoise(pose, trajectory, time_s, presence);
        if (motion_.gaze) turnEyes(pose, trajectory.gaze);
        return pose;
    }

  private:
    static constexpr std::size_t channels = 15;
    static constexpr double fade_s = 0.3;

    [[nodiscard]] double progress(double time_s, double lead_s) const {
        const double warp = parameters_.timing.warp;
        const double raised = (time_s - times_.onset + lead_s) / motion_.raise_s;
        const double lowered = (time_s - times_.hold) / motion_.retract_s;
        if (motion_.linear) return std::clamp(raised, 0.0, 1.0) - std::clamp(lowered, 0.0, 1.0);
        return warpedMinimumJerk(raised, warp) - warpedMinimumJerk(lowered, warp);
    }

    [[nodiscard]] Trajectory trajectoryAt(double time_s) const {
        Trajectory trajectory;
        const BodyShareParameters& share = parameters_.body;
        trajectory.arm = progress(time_s, 0.0);
        trajectory.trunk = trajectory.arm;
        trajectory.head = progress(time_s, motion_.gaze ? share.head_lead_s : 0.0);
        trajectory.gaze = minimumJerk((time_s - times_.onset + share.gaze_lead_s) / share.gaze_shift_s) -
                          minimumJerk((time_s - times_.hold + 0.5 * share.gaze_lead_s) / share.gaze_shift_s);
        // The hand is shaped before the arm arrives and opens once it is on its way down.
        trajectory.fingers = motion_.linear
                                 ? trajectory.arm
                                 : minimumJerk((time_s - times_.onset) / (0.75 * motion_.raise_s)) -
                                       minimumJerk((time_s - times_.hold - 0.1 * motion_.retract_s) /
                                                   (0.75 * motion_.retract_s));
        trajectory.held = minimumJerk((time_s - times_.peak) / motion_.hold_s);
        const double remaining = trajectory.arm * (1.0 - trajectory.arm);
        trajectory.moving = std::min(1.0, 4.0 * remaining);
        return trajectory;
    }

    void turn(LocalPose& pose, const std::vector<std::size_t>& joints, double share, double held) const {
        for (const std::size_t j : joints) {
            const Quat& peak = motion_.peak.joints[j].orientation;
            const Quat& end = motion_.hold_end.joints[j].orientation;
            const Quat there = held > 0.0 ? glm::slerp(peak, end, held) : peak;
            pose.joints[j].orientation = glm::slerp(pose.joints[j].orientation, there, share);
        }
    }

    /// Fingertip in the upper arm's frame.
    [[nodiscard]] Vec3 tipFromShoulder(const Quat& lower_arm, const Quat& hand) const {
        return body_.offset(bones_.lower_arm) +
               lower_arm * (body_.offset(bones_.hand) +
                            hand * body_.fingertip_in_hand[static_cast<std::size_t>(motion_.hand)]);
    }

    [[nodiscard]] Quat orientation(const LocalPose& pose, Bone bone) const {
        return pose.joints[body_.joint(bone)].orientation;
    }

    /// Elbow flexion to add half-way, so that the fingertip cuts the corner of the arc that a stiff arm would
    /// draw: it leaves the straight way by the bulge, but keeps its distance from the body.
    [[nodiscard]] double passingFlexion(const LocalPose& posture, double bulge) const {
        if (motion_.linear) return 0.0;
        const auto tip_of = [&](const LocalPose& pose) {
            return orientation(pose, bones_.upper_arm) *
                   tipFromShoulder(orientation(pose, bones_.lower_arm), orientation(pose, bones_.hand));
        };
        const Vec3 from = tip_of(body_.relaxed);
        const Vec3 to = tip_of(posture);
        const double straight_way = glm::length(to - from);
        const TwoLinkArm links{
            motion_.hand, body_.offset(bones_.lower_arm),
            body_.offset(bones_.hand) + body_.fingertip_in_hand[static_cast<std::size_t>(motion_.hand)]};
        const double longest = glm::length(links.elbow) + glm::length(links.tip);
        const double reach = std::max(glm::length(0.5 * (from + to)) + bulge * straight_way,
                                      parameters_.timing.min_reach * longest);
        const double without = flexionForReach(links, 0.5 * (glm::length(from) + glm::length(to)));
        return std::max(0.0, flexionForReach(links, reach) - without);
    }

    /// Bends the elbow on the way, the fingertip kept in its direction from the shoulder.
    void bendInPassing(LocalPose& pose, double arm, double flexion) const {
        const double bend = flexion * 4.0 * arm * (1.0 - arm);
        if (bend <= 0.0) return;
        Quat& upper = pose.joints[body_.joint(bones_.upper_arm)].orientation;
        Quat& lower = pose.joints[body_.joint(bones_.lower_arm)].orientation;
        const Quat hand = orientation(pose, bones_.hand);
        const Vec3 before = tipFromShoulder(lower, hand);
        lower = elbowRotation(motion_.hand, bend) * lower;
        const Vec3 after = tipFromShoulder(lower, hand);
        const double turned = std::atan2(-after.z, after.x) - std::atan2(-before.z, before.x);
        upper = upper * glm::angleAxis(-std::remainder(turned, 2.0 * pi), y_axis);
    }

    void rotate(LocalPose& pose, Bone bone, const Vec3& by) const {
        Quat* joint = body_.find(pose, bone);
        const double angle = glm::length(by);
        if (joint == nullptr || angle < 1e-12) return;
        *joint = *joint * glm::angleAxis(angle, by / angle);
    }

    void addNoise(LocalPose& pose, const Trajectory& trajectory, double time_s, double presence) {
        const NoiseParameters& n = parameters_.noise;
        const double share = motion_.noise_share * presence;
        std::array<double, channels> noise{};
        for (std::size_t i = 0; i < channels; ++i) noise[i] = share * noise_[i].step(random_);
        // What is still shakes less (noise grows with the effort of moving).
        const double arm = n.hold_share + (1.0 - n.hold_share) * trajectory.moving;
        const double drift = share * radiansFromDegrees(n.hold_drift_deg) * trajectory.arm;
        const double wander = presence * motion_.wander_rad * trajectory.arm * trajectory.arm;
        const Vec3 slow{0.0, drift * drift_[0].at(time_s) + wander * wander_[0].at(time_s),
                        drift * drift_[1].at(time_s) + wander * wander_[1].at(time_s)};
        rotate(pose, bones_.upper_arm, arm * Vec3(noise[0], noise[1], noise[2]) + slow);
        rotate(pose, bones_.lower_arm, arm * Vec3(noise[3], noise[4], 0.0));
        rotate(pose, bones_.hand, arm * Vec3(0.0, noise[5], noise[6]));
        if (motion_.jitter_rad > 0.0) shake(pose, presence * trajectory.arm);

        const ArmBones idle = armBones(opposite(motion_.hand));
        rotate(pose, idle.upper_arm, 0.4 * Vec3(noise[7], noise[8], noise[9]));
        rotate(pose, idle.lower_arm, 0.4 * Vec3(0.0, noise[10], 0.0));
        rotate(pose, Bone::head, 0.35 * Vec3(noise[11], noise[12], 0.0));
        rotate(pose, Bone::spine, 0.15 * Vec3(noise[13], noise[14], 0.0));
        const double breath = std::sin(breath_angular_ * time_s + breath_phase_);
        rotate(pose, body_.map.has(Bone::chest) ? Bone::chest : Bone::spine,
               Vec3(-share * radiansFromDegrees(n.breathing_deg) * breath, 0.0, 0.0));
        sway(pose, share * n.sway_m * sway_[0].at(time_s), share * n.sway_m * sway_[1].at(time_s));
    }

    /// Shaking without inertia, as of a model that forgets its last frame.
    void shake(LocalPose& pose, double amount) {
        for (const Bone bone : {bones_.upper_arm, bones_.lower_arm, bones_.hand}) {
            const double a = random_.normal(), b = random_.normal();
            rotate(pose, bone, amount * motion_.jitter_rad * Vec3(0.0, a, b));
        }
    }

    /// Moves the hips over planted feet: the legs lean, the feet stay flat.
    void sway(LocalPose& pose, double left_m, double forward_m) const {
        const Bone feet[2][2] = {{Bone::leftUpperLeg, Bone::leftFoot},
                                 {Bone::rightUpperLeg, Bone::rightFoot}};
        const std::size_t hips = body_.joint(Bone::hips);
        pose.joints[hips].position += Vec3(left_m, 0.0, forward_m);
        for (const auto& [leg, foot] : feet) {
            if (!body_.map.has(leg) || !body_.map.has(foot)) continue;
            const double length = body_.world(body_.relaxed, body_.joint(leg)).position.y -
                                  body_.world(body_.relaxed, body_.joint(foot)).position.y;
            const Vec3 lean{forward_m / length, 0.0, -left_m / length};
            rotate(pose, leg, lean);
            rotate(pose, foot, -lean);
        }
    }

    /// The eyes look where the gaze is, whatever the head does, as far as they turn.
    void turnEyes(LocalPose& pose, double gaze) const {
        if (!body_.map.has(Bone::leftEye) || !body_.map.has(Bone::rightEye)) return;
        const Pose head = body_.world(pose, body_.joint(Bone::head));
        const double limit = radiansFromDegrees(parameters_.body.eye_limit_deg);
        for (const Bone bone : {Bone::leftEye, Bone::rightEye}) {
            const Pose eye = head * pose.joints[body_.joint(bone)];
            const Vec3 ahead{0.0, 0.0, 1.0};
            const Vec3 there = glm::normalize(motion_.gaze_at - eye.position);
            const Vec3 looked = glm::slerp(no_rotation, rotationBetween(ahead, there), gaze) * ahead;
            const Quat needed = rotationBetween(ahead, glm::conjugate(head.orientation) * looked);
            *body_.find(pose, bone) = turnedAtMost(needed, limit);
        }
    }

    const PointingBody& body_;
    const PointingMotion& motion_;
    const DemonstrationParameters& parameters_;
    Random& random_;
    Times times_;
    ArmBones bones_;
    std::vector<SmoothNoise> noise_;
    std::array<Wave, 2> drift_;
    std::array<Wave, 2> sway_;
    std::array<Wave, 2> wander_;
    double breath_angular_;
    double breath_phase_;
    double raise_flexion_ = 0.0;
    double retract_flexion_ = 0.0;
    std::vector<std::size_t> head_joints_, arm_joints_, trunk_joints_, finger_joints_;
};

}  // namespace

PointingMotion heldAs(PointingMotion motion, const HoldSettings& settings, const PointingBody& body) {
    constexpr Interval unsteady_hz{0.5, 1.5};
    motion.hold_s = settings.hold_s.value_or(motion.hold_s);
    if (settings.unsteadiness_m) {
        const ArmBones bones = armBones(motion.hand);
        const Vec3 tip = transformPoint(body.world(motion.peak, body.joint(bones.hand)),
                                        body.fingertip_in_hand[static_cast<std::size_t>(motion.hand)]);
        const double reach_m =
            glm::length(body.world(motion.peak, body.joint(bones.upper_arm)).position - tip);
        motion.wander_rad = *settings.unsteadiness_m / reach_m;
        motion.wander_hz = unsteady_hz;
        motion.jitter_rad = 0.0;
        motion.hold_end = motion.peak;
    }
    return motion;
}

double wholeDuration_s(const PointingMotion& motion) {
    return timesOf(motion).whole;
}

GeneratedClip emptyClip(const PointingBody& body, const PointingMotion& motion) {
    const Times times = timesOf(motion);
    GeneratedClip out;
    out.hand = motion.hand;
    out.clip.skeleton = body.skeleton;
    out.clip.frame_time_s = generated_frame_time_s;
    const double fps = 1.0 / generated_frame_time_s;
    const int last = static_cast<int>(std::ceil(times.whole * fps));
    out.clip.frames.resize(static_cast<std::size_t>(last) + 1);
    out.onset_frame = static_cast<int>(std::floor(times.onset * fps));
    out.peak_frame = static_cast<int>(std::ceil(times.peak * fps));
    out.hold_frame = std::max(out.peak_frame, static_cast<int>(std::floor(times.hold * fps)));
    out.end_frame = std::min(last, static_cast<int>(std::ceil(times.end * fps)));
    return out;
}

GeneratedClip perform(const PointingBody& body, const PointingMotion& motion,
                      const DemonstrationParameters& parameters, std::uint64_t seed) {
    Random random(seed, "performance");
    Performance performance(body, motion, parameters, random);
    GeneratedClip out = emptyClip(body, motion);
    const double fps = 1.0 / generated_frame_time_s;
    for (std::size_t i = 0; i < out.clip.frames.size(); ++i)
        out.clip.frames[i] = performance.at(std::min(static_cast<double>(i) / fps, wholeDuration_s(motion)));
    makeContinuous(out.clip.frames);
    return out;
}

}  // namespace deixis::motion
