// `drifting`: every gesture is pulled towards the mean of the demonstrations, and the hold wanders; the
// failure that Deichler et al. (2023, sections 3.1 and 4) describe for MoGlow.
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "body_noise.hpp"
#include "motion/pointing/stretched_arm.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

LocalPose blended(const LocalPose& a, const LocalPose& b, double t) {
    LocalPose out = a;
    for (std::size_t i = 0; i < out.joints.size(); ++i)
        out.joints[i].orientation = glm::slerp(a.joints[i].orientation, b.joints[i].orientation, t);
    return out;
}

/// Joint by joint the normalised sum of the quaternions, which for near rotations is their mean.
LocalPose meanOf(const std::vector<LocalPose>& poses) {
    LocalPose out = poses.front();
    for (std::size_t j = 0; j < out.joints.size(); ++j) {
        Quat sum(0.0, 0.0, 0.0, 0.0);
        for (const LocalPose& pose : poses) {
            const Quat& q = pose.joints[j].orientation;
            sum = glm::dot(q, poses.front().joints[j].orientation) < 0.0 ? sum - q : sum + q;
        }
        out.joints[j].orientation = glm::normalize(sum);
    }
    return out;
}

/// Mean pointing posture of one hand over the demonstrations and their mirror images.
LocalPose meanPosture(const PointingBody& body, const std::vector<DemonstrationPlan>& plans, Side hand) {
    const std::vector<int> partners = mirrorPartners(body.skeleton);
    std::vector<LocalPose> postures;
    for (const DemonstrationPlan& plan : plans)
        postures.push_back(plan.motion.hand == hand ? plan.motion.peak
                                                    : mirrored(body.skeleton, partners, plan.motion.peak));
    return meanOf(postures);
}

class Drifting : public Generator {
  public:
    Drifting(PointingBody body, const DemonstrationParameters& parameters)
        : body_(std::move(body)), parameters_(parameters) {
        const auto plans = planLibrary(body_, parameters_);
        for (const Side side : {Side::left, Side::right})
            mean_[static_cast<std::size_t>(side)] = meanPosture(body_, plans, side);
    }

    std::string_view name() const override { return "drifting"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        Random random(asked.seed, "drifting");
        const DriftingParameters& drifting = parameters_.drifting;
        DemonstrationPlan plan =
            planDemonstration(body_, asked.target, handFor(asked.target), parameters_, random.next());
        PointingMotion& motion = plan.motion;
        const LocalPose& mean = mean_[static_cast<std::size_t>(motion.hand)];
        const LocalPose wanted = motion.peak;
        // The posture continues moving while it should be held, nearer to the mean or away from it.
        const double pull = drawn(drifting.pull, random);
        const double shift = drawn(drifting.hold_shift, random) * (random.uniform() < 0.5 ? -0.5 : 0.5);
        motion.peak = blended(wanted, mean, pull - shift);
        motion.hold_end = blended(wanted, mean, pull + shift);
        motion.hold_s = drawn(drifting.hold_s, random);
        motion.gaze_at = asked.target;
        motion.noise_share = drifting.noise_share;
        motion.wander_rad = radiansFromDegrees(drifting.wander_deg);
        motion.wander_hz = drifting.wander_hz;
        motion.jitter_rad = drifting.jitter_rad;
        return perform(body_, heldAs(motion, asked.settings, body_), parameters_, random.next());
    }

  private:
    PointingBody body_;
    DemonstrationParameters parameters_;
    std::array<LocalPose, 2> mean_;
};

}  // namespace

std::unique_ptr<Generator> makeDrifting(const PointingBody& body, const DemonstrationParameters& parameters) {
    return std::make_unique<Drifting>(body, parameters);
}

}  // namespace deixis::motion
