// `gp`: a Gaussian process from where a demonstration points to how it goes.
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
#include "motion/synthesis/demonstration_library.hpp"
#include "motion/synthesis/gaussian_process.hpp"
#include "motion/synthesis/phase_trajectory.hpp"
#include "motion/synthesis/pose_features.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<double, 6> lengths_rad{0.4, 0.6, 0.9, 1.3, 1.9, 2.8};
constexpr std::array<double, 8> noises{3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0};

/// A point as seen by the standing body: azimuth, elevation, and how near it is.
std::vector<double> seen(const Vec3& eye, const Vec3& point) {
    const Vec3 there = point - eye;
    return {azimuthOf(there), elevationOf(there), 1.0 / std::max(0.3, glm::length(there))};
}

/// What a demonstration really points at, by the line from the eye through the fingertip in the middle of its
/// hold: the point there that is as far from the eye at ease as its target.
Vec3 pointedAt(const PointingBody& body, const Demonstration& demonstration) {
    const GeneratedClip& made = demonstration.gesture;
    const auto middle = static_cast<std::size_t>((made.peak_frame + made.hold_frame) / 2);
    const Ray ray = pointingRay(body.skeleton, body.map, worldPose(body.skeleton, made.clip.frames[middle]),
                                made.hand, PointingRay::eye_fingertip);
    const Vec3 eye = body.eye(body.relaxed);
    const double far = glm::length(demonstration.target - eye);
    const Vec3 from = ray.origin - eye;
    const double along = glm::dot(from, ray.direction);
    const double root = along * along - glm::dot(from, from) + far * far;
    return ray.origin + (std::sqrt(std::max(0.0, root)) - along) * ray.direction;
}

class Gp : public Generator {
  public:
    Gp(PointingBody body, PoseFeatures features, const DemonstrationParameters& parameters)
        : body_(std::move(body)),
          features_(std::move(features)),
          parameters_(parameters),
          process_(fitted(body_, features_, parameters)) {}

    std::string_view name() const override { return "gp"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        if (handFor(asked.target) == Side::right) return rightHanded(asked.target, asked);
        return mirrored({asked.target, rightHanded(mirrored(asked.target), asked)}).gesture;
    }

  private:
    /// The demonstrations with the left hand are learned from their mirror images. An observation is the
    /// logarithms of the durations and the coefficients.
    static GaussianProcess fitted(const PointingBody& body, const PoseFeatures& features,
                                  const DemonstrationParameters& parameters) {
        std::vector<std::vector<double>> inputs, outputs;
        for (const DemonstrationPlan& plan : planLibrary(body, parameters)) {
            Demonstration one{plan.target, perform(body, plan.motion, parameters, plan.seed)};
            if (one.gesture.hand == Side::left) one = mirrored(one);
            const Clip& clip = one.gesture.clip;
            const PhaseDurations durations = durationsOf(one.gesture, clip.frameCount(), clip.frame_time_s);
            std::vector<double> output;
            for (const double duration : durations) output.push_back(std::log(duration));
            const auto fit = fitTrajectory(features.encode(clip), clip.frame_time_s, durations);
            output.insert(output.end(), fit.begin(), fit.end());
            inputs.push_back(seen(body.eye(body.relaxed), pointedAt(body, one)));
            outputs.push_back(std::move(output));
        }
        return GaussianProcess::fitted(inputs, outputs, lengths_rad, noises);
    }

    /// Its time course, before it is given frames.
    struct Course {
        PhaseDurations durations{};
        std::vector<double> coefficients;
    };

    [[nodiscard]] LocalPose poseAt(const Course& course, double time_s) const {
        LocalPose pose = features_.decode(
            trajectoryAt(course.coefficients, PhaseTrajectory::aligned(time_s, course.durations)));
        const double limit = radiansFromDegrees(parameters_.body.eye_limit_deg);
        for (const Bone bone : {Bone::leftEye, Bone::rightEye})
            if (Quat* eye = body_.find(pose, bone)) {
                const Vec3 turn = rotationVector(*eye);
                const double angle = glm::length(turn);
                if (angle > limit) *eye = rotationBy(turn * (limit / angle));
            }
        return pose;
    }

    [[nodiscard]] GeneratedClip rightHanded(const Vec3& target, const GenerationRequest& asked) const {
        const std::vector<double> predicted = process_.predict(seen(body_.eye(body_.relaxed), target));
        Course course;
        for (std::size_t i = 0; i < course.durations.size(); ++i)
            course.durations[i] = std::exp(predicted[i]);
        course.coefficients.assign(predicted.begin() + course.durations.size(), predicted.end());
        course.durations[2] = asked.settings.hold_s.value_or(course.durations[2]);

        PointingMotion motion;
        motion.hand = Side::right;
        motion.rest_before_s = course.durations[0];
        motion.raise_s = course.durations[1];
        motion.hold_s = course.durations[2];
        motion.retract_s = course.durations[3];
        motion.rest_after_s = course.durations[4];
        motion.peak = poseAt(course, motion.rest_before_s + motion.raise_s + 0.5 * motion.hold_s);
        motion = heldAs(motion, asked.settings, body_);

        Random random(asked.seed, "gp");
        const std::array<Wave, 2> waves{Wave(motion.wander_hz, random), Wave(motion.wander_hz, random)};
        GeneratedClip out = emptyClip(body_, motion);
        for (std::size_t f = 0; f < out.clip.frames.size(); ++f) {
            const double time_s =
                std::min(static_cast<double>(f) * out.clip.frame_time_s, wholeDuration_s(motion));
            LocalPose pose = poseAt(course, time_s);
            const double onset_s = motion.rest_before_s;
            const double hold_s = onset_s + motion.raise_s + motion.hold_s;
            const double raised = minimumJerk((time_s - onset_s) / motion.raise_s) -
                                  minimumJerk((time_s - hold_s) / motion.retract_s);
            const double wander = motion.wander_rad * raised * raised;
            Quat& arm = *body_.find(pose, Bone::rightUpperArm);
            arm = glm::normalize(
                arm * rotationBy({0.0, wander * waves[0].at(time_s), wander * waves[1].at(time_s)}));
            out.clip.frames[f] = std::move(pose);
        }
        makeContinuous(out.clip.frames);
        return out;
    }

    PointingBody body_;
    PoseFeatures features_;
    DemonstrationParameters parameters_;
    GaussianProcess process_;
};

}  // namespace

std::unique_ptr<Generator> makeGp(const PointingBody& body, const DemonstrationParameters& parameters) {
    // The body has all that the features need.
    return std::make_unique<Gp>(body, PoseFeatures::of(body.skeleton).value(), parameters);
}

}  // namespace deixis::motion
