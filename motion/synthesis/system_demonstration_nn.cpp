// `demonstration-nn`: plays the demonstration whose target lies nearest (the paper's GT-NN, section 2.4.1.2).
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "motion/synthesis/demonstration_library.hpp"
#include "pointing_plan.hpp"
#include "systems.hpp"

namespace deixis::motion {

namespace {

class DemonstrationNn : public Generator {
  public:
    DemonstrationNn(std::string_view name, PointingBody body, const DemonstrationParameters& parameters)
        : name_(name),
          body_(std::move(body)),
          parameters_(parameters),
          plans_(planLibrary(body_, parameters)) {
        std::vector<Demonstration> library;
        for (const DemonstrationPlan& plan : plans_) library.push_back(played(plan, {}));
        library_ = withMirrored(std::move(library));
    }

    std::string_view name() const override { return name_; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const auto distance = [&](const Demonstration& d) { return glm::length(d.target - asked.target); };
        const auto nearest = std::min_element(
            library_.begin(), library_.end(),
            [&](const Demonstration& a, const Demonstration& b) { return distance(a) < distance(b); });
        if (!asked.settings.hold_s && !asked.settings.unsteadiness_m) return nearest->gesture;
        // The mirrored half of the library follows the other one.
        const auto index = static_cast<std::size_t>(nearest - library_.begin());
        Demonstration again = played(plans_[index % plans_.size()], asked.settings);
        return index < plans_.size() ? again.gesture : mirrored(again).gesture;
    }

  private:
    [[nodiscard]] Demonstration played(const DemonstrationPlan& plan, const HoldSettings& settings) const {
        return {plan.target, perform(body_, heldAs(plan.motion, settings, body_), parameters_, plan.seed)};
    }

    std::string_view name_;
    PointingBody body_;
    DemonstrationParameters parameters_;
    std::vector<DemonstrationPlan> plans_;
    std::vector<Demonstration> library_;
};

}  // namespace

std::unique_ptr<Generator> makeDemonstrationNn(const PointingBody& body,
                                               const DemonstrationParameters& parameters) {
    return std::make_unique<DemonstrationNn>("demonstration-nn", body, parameters);
}

std::unique_ptr<Generator> makeGtNn(const PointingBody& body, const DemonstrationParameters& parameters) {
    return std::make_unique<DemonstrationNn>("gt-nn", body, parameters);
}

}  // namespace deixis::motion
