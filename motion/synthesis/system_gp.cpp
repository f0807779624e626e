// `gp`: a Gaussian process from where a demonstration points to how it goes.
#include "motion/synthesis/gesture_trajectories.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

class Gp : public Generator {
  public:
    Gp(const PointingBody& body, const DemonstrationParameters& parameters)
        : trajectories_(body, radiansFromDegrees(parameters.body.eye_limit_deg)),
          process_(fitted(body, trajectories_, parameters)) {}

    std::string_view name() const override { return "gp"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        return trajectories_.perform(asked, name(), [this](const Vec3& target_m) {
            return process_.predict(asNearAs(process_, trajectories_.seen(target_m)));
        });
    }

  private:
    static GaussianProcess fitted(const PointingBody& body, const GestureTrajectories& trajectories,
                                  const DemonstrationParameters& parameters) {
        std::vector<GestureTrajectories::Observation> observations;
        for (const DemonstrationPlan& plan : planLibrary(body, parameters))
            observations.push_back(
                trajectories.observe({plan.target, perform(body, plan.motion, parameters, plan.seed)}));
        return trajectoryRegression(observations);
    }

    GestureTrajectories trajectories_;
    GaussianProcess process_;
};

}  // namespace

std::unique_ptr<Generator> makeGp(const PointingBody& body, const DemonstrationParameters& parameters) {
    return std::make_unique<Gp>(body, parameters);
}

}  // namespace deixis::motion
