// Systems in which a trained policy moves the simulated body: adversarial motion priors (Peng et al. 2021) as
// Deichler et al. (2023), sections 2.2.1 and 2.2.2, train them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/networks/weights_file.hpp"
#include "motion/synthesis/generator.hpp"
#include "motion/synthesis/phase_trajectory.hpp"
#include "physics/figure/figure.hpp"

namespace deixis::physics {

inline constexpr const char* amp_architecture = "amp";

/// A demonstration as a file of weights remembers it: a target is pointed at by the policy of the cluster of
/// the nearest one, with its hand and for as long as it.
struct AmpTarget {
    Vec3 target_m{0.0};
    motion::Side hand = motion::Side::right;
    motion::PhaseDurations durations_s{};
    int cluster = 0;
};

/// The one that a place is pointed at as. `targets` are not empty.
[[nodiscard]] const AmpTarget& nearestTarget(const std::vector<AmpTarget>& targets, const Vec3& place_m);

/// What a file of weights of this architecture is made of, apart from the policies' arrays: policy0, policy1,
/// ..., one a cluster (policy.hpp).
struct AmpModel {
    std::string system;  ///< such as "amp-pfnn-8"
    Stance stance = Stance::pinned;
    bool with_phase = true;
    int clusters = 1;
    std::vector<int> hidden;
    std::vector<AmpTarget> targets{};
    std::vector<double> base;  ///< coefficients of the BaseMotion
    std::string features;      ///< PoseFeatures::names(), which they are of
};
/// Adds all but the policies to weights.
void writeModel(const AmpModel& model, motion::NetworkWeights& weights);
[[nodiscard]] Result<AmpModel> readModel(const motion::NetworkWeights& weights);

/// Makes the system. Fails where the weights are of another architecture or another body, and without
/// MuJoCo. A hold that a request asks for is the gesture's hold played slower or faster; `unsteadiness_m` is
/// not in the policy's control and is left. Phases are found in the clip, as for other learned systems.
[[nodiscard]] Result<std::unique_ptr<motion::Generator>> makeAmp(const motion::NetworkWeights& weights,
                                                                 const motion::Skeleton& avatar);

}  // namespace deixis::physics
