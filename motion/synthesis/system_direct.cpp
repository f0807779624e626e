// `direct`: inverse kinematics straight to the target, in human timing.
#include <utility>

#include "body_noise.hpp"
#include "motion/pointing/stretched_arm.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

class Direct : public Generator {
  public:
    Direct(PointingBody body, const DemonstrationParameters& parameters)
        : body_(std::move(body)), parameters_(parameters) {}

    std::string_view name() const override { return "direct"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        Random random(asked.seed, "direct");
        const PointingLineParameters& line = parameters_.line;
        PostureRequest request = bodyTakingPart(body_, asked.target, handFor(asked.target), parameters_.body);
        request.aim = asked.target;
        request.extension = parameters_.direct.extension;
        request.index_alignment = parameters_.direct.index_alignment;
        request.wrist_limit_rad = radiansFromDegrees(line.wrist_limit_deg);
        request.knuckle_limit_rad = radiansFromDegrees(line.knuckle_limit_deg);
        request.swivel_offset_rad = radiansFromDegrees(parameters_.arm.swivel_sd_deg) * random.normal();
        request.palm_inward_rad = radiansFromDegrees(drawn(line.palm_inward_deg, random));
        PointingMotion motion = humanTiming(asked.target, request.hand, parameters_.timing, random);
        motion.peak = solvePosture(body_, request, parameters_.arm);
        motion.hold_end = motion.peak;
        motion.noise_share = parameters_.direct.noise_share;
        return perform(body_, heldAs(motion, asked.settings, body_), parameters_, random.next());
    }

  private:
    PointingBody body_;
    DemonstrationParameters parameters_;
};

}  // namespace

std::unique_ptr<Generator> makeDirect(const PointingBody& body, const DemonstrationParameters& parameters) {
    return std::make_unique<Direct>(body, parameters);
}

}  // namespace deixis::motion
