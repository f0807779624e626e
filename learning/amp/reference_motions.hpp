// Demonstrations as the body performs them, in the controls of a training.
#pragma once

#include <cstdint>
#include <vector>

#include "learning/amp/settings.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "physics/body/body.hpp"
#include "physics/policy/base_motion.hpp"
#include "physics/policy/observation.hpp"

namespace deixis::learning {

/// One demonstration. Controls count from 0; a state stands for the begin of a control.
struct ReferenceMotion {
    Vec3 target_m{0.0};
    motion::Side hand = motion::Side::right;
    motion::PhaseDurations durations_s{};
    std::vector<physics::BodyState> states;        ///< one more than controls
    std::vector<std::vector<double>> targets_rad;  ///< of the actuators
    std::vector<motion::LocalPose> base;           ///< BaseMotion's pose for each state
    /// What the body looked like under noise: repeats x states x the observer's numbers.
    std::vector<std::vector<std::vector<float>>> seen;

    [[nodiscard]] std::size_t controls() const { return targets_rad.size(); }
    /// Share of the running time.
    [[nodiscard]] double phase(std::size_t control) const {
        return static_cast<double>(control) / static_cast<double>(controls());
    }
    [[nodiscard]] bool restIsOver(std::size_t control) const;  ///< that before the raise
    [[nodiscard]] bool holdIsOver(std::size_t control) const;
};

/// One for each demonstration. Fails where the body cannot follow a demonstration.
[[nodiscard]] Result<std::vector<ReferenceMotion>> makeReferences(
    const physics::Body& body, const physics::BaseMotion& base,
    const std::vector<motion::Demonstration>& demonstrations, const AmpSettings& settings);

}  // namespace deixis::learning
