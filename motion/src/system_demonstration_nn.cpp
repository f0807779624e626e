// `demonstration-nn`: plays the demonstration whose target lies nearest (the paper's GT-NN, section 2.4.1.2).
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "motion/demonstration_library.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

class DemonstrationNn : public Generator {
  public:
    explicit DemonstrationNn(std::vector<Demonstration> library) : library_(std::move(library)) {}

    std::string_view name() const override { return "demonstration-nn"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const auto distance = [&](const Demonstration& d) { return glm::length(d.target - asked.target); };
        return std::min_element(
                   library_.begin(), library_.end(),
                   [&](const Demonstration& a, const Demonstration& b) { return distance(a) < distance(b); })
            ->gesture;
    }

  private:
    std::vector<Demonstration> library_;
};

}  // namespace

std::unique_ptr<Generator> makeDemonstrationNn(const PointingBody& body,
                                               const DemonstrationParameters& parameters) {
    std::vector<Demonstration> library;
    for (const DemonstrationPlan& plan : planLibrary(body, parameters))
        library.push_back({plan.target, perform(body, plan.motion, parameters, plan.seed)});
    return std::make_unique<DemonstrationNn>(withMirrored(std::move(library)));
}

}  // namespace deixis::motion
