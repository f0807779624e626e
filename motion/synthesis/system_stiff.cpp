// `stiff`: an accurate arm and nothing else, every joint at a steady speed.
#include <utility>

#include "motion/pointing/stretched_arm.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

class Stiff : public Generator {
  public:
    Stiff(PointingBody body, const DemonstrationParameters& parameters)
        : body_(std::move(body)), parameters_(parameters) {}

    std::string_view name() const override { return "stiff"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const StiffParameters& stiff = parameters_.stiff;
        PostureRequest request;
        request.hand = handFor(asked.target);
        request.aim = asked.target;
        request.extension = stiff.extension;
        request.wrist_limit_rad = radiansFromDegrees(parameters_.line.wrist_limit_deg);
        request.knuckle_limit_rad = radiansFromDegrees(parameters_.line.knuckle_limit_deg);
        PointingMotion motion;
        motion.hand = request.hand;
        motion.peak = solvePosture(body_, request, parameters_.arm);
        motion.hold_end = motion.peak;
        motion.rest_before_s = motion.rest_after_s = stiff.rest_s;
        motion.raise_s = stiff.raise_s;
        motion.hold_s = stiff.hold_s;
        motion.retract_s = stiff.retract_s;
        motion.linear = true;
        return perform(body_, heldAs(motion, asked.settings, body_), parameters_, asked.seed);
    }

  private:
    PointingBody body_;
    DemonstrationParameters parameters_;
};

}  // namespace

std::unique_ptr<Generator> makeStiff(const PointingBody& body, const DemonstrationParameters& parameters) {
    return std::make_unique<Stiff>(body, parameters);
}

}  // namespace deixis::motion
