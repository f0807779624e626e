// The two cues before they are weighed: what does not change while weights and noise are fitted.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "studies/observers/observer.hpp"

namespace deixis::studies {

struct Cues {
    /// Of each ball: the angles by which the pointer's eye line, the arm's line and the line from the
    /// observer's eye miss it, radians.
    std::vector<std::array<double, 3>> missed{};
    double along = 0.0;  ///< cosine of the angle between gaze and arm, 0 from a right angle on
};

[[nodiscard]] Cues cuesOf(const SeenArm& arm, const std::vector<Vec3>& balls);

[[nodiscard]] std::array<double, 3> cueWeights(const ObserverModel& model, double along);

/// Of each ball the logarithm of how much the cues together speak for it.
[[nodiscard]] std::vector<double> logEvidence(const ObserverModel& model, const Cues& cues);

/// ballChance() of two cues, from these.
[[nodiscard]] double cueChance(const std::vector<double>& evidence, std::size_t ball);
[[nodiscard]] double cueChance(const ObserverModel& model, const Cues& cues, std::size_t ball);

/// misses() of two cues, likewise.
[[nodiscard]] std::vector<double> cueMisses(const ObserverModel& model, const std::vector<double>& evidence);

}  // namespace deixis::studies
