// The simulated participant's way of choosing a ball, fitted to choices that were made: its angular noise and
// its lapse rate by maximum likelihood. A choice has the probability (1 - lapse) P(ball | noise) + lapse /
// balls. docs/simulated-participant.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "motion/pointing.hpp"
#include "motion/skeleton.hpp"
#include "studies/replay.hpp"

namespace deixis::studies {

/// One choice of the game, and what there was to see.
struct SeenChoice {
    Ray ray{};                ///< of the pointing arm, as the simulated participant reads it
    std::vector<Vec3> balls;  ///< two and more, as shown
    std::size_t chosen = 0;
};

/// Watches a recorded trial of the game at `frame_rate_hz` as a simulated participant does. None where no
/// ball was chosen, there was but one, or no arm was seen to point.
[[nodiscard]] std::optional<SeenChoice> seenChoice(const RecordedTrial& recorded, const ClipSource& clips,
                                                   const motion::Skeleton& avatar,
                                                   const motion::LocalPose& idle_pose,
                                                   motion::PointingRay kind, double frame_rate_hz);

/// The probability that BallChooser without lapses takes that ball; `noise_rad` in (0, 0.7]. Of one angle
/// exact, over the other by the trapezoid rule: right to about 0.001.
[[nodiscard]] double ballProbability(const SeenChoice& seen, std::size_t ball, double noise_rad);

/// With its profile likelihood interval; an end is missing where the likelihood does not fall far enough
/// before the end of what is tried: noise from 0.05 to 40 degrees, lapses from 0 to 1.
struct FittedParameter {
    double value = 0.0;
    std::optional<double> lower{};
    std::optional<double> upper{};
};

struct ObserverFit {
    int choices = 0;
    FittedParameter noise_deg{};
    FittedParameter lapse_rate{};
    double log_likelihood = 0.0;
    double aic = 0.0;  ///< 2 parameters
};

/// One noise and one lapse rate for all. There must be choices. `level` of the intervals, in (0, 1).
[[nodiscard]] ObserverFit fitObserver(std::span<const SeenChoice> choices, double level);

/// The log-likelihood that fitObserver() maximises, computed directly.
[[nodiscard]] double observerLogLikelihood(std::span<const SeenChoice> choices, double noise_deg,
                                           double lapse_rate);

/// As participants differ in SimulatedParameters: each has noise_deg times max(0.2, 1 + noise_between z), z
/// standard normal, and all have the same lapse rate.
struct PopulationFit {
    double noise_deg = 0.0;
    double noise_between = 0.0;
    double lapse_rate = 0.0;
    double log_likelihood = 0.0;  ///< participants' noise integrated out
    double aic = 0.0;             ///< 3 parameters
};

/// `by_participant`: two and more participants, each with choices.
[[nodiscard]] PopulationFit fitPopulation(std::span<const std::vector<SeenChoice>> by_participant);

}  // namespace deixis::studies
