// The simulated participant's way of choosing a ball, fitted to recorded choices: its noise and its lapse
// rate, and the weights of two cues, by maximum likelihood. The probability of a choice is choiceChance().
// docs/simulated-participant.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/pose.hpp"
#include "motion/skeleton/skeleton.hpp"
#include "studies/observers/observer.hpp"
#include "studies/session/replay.hpp"

namespace deixis::studies {

/// One choice of the game, and what there was to see.
struct SeenChoice {
    SeenArm arm{};            ///< as the simulated participant reads it
    std::vector<Vec3> balls;  ///< two and more, as shown
    std::size_t chosen = 0;
};

/// Watches a recorded trial of the game at `frame_rate_hz` as a simulated participant does, from where the
/// participant's head was in the hold. None if no ball was chosen, there was but one, or no arm was seen
/// to point.
[[nodiscard]] std::optional<SeenChoice> seenChoice(const RecordedTrial& recorded, const ClipSource& clips,
                                                   const motion::Skeleton& avatar,
                                                   const motion::LocalPose& idle_pose, const Reading& reading,
                                                   double elevation_bias_deg, double frame_rate_hz);

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
    std::optional<FittedParameter> eye_line_share{};  ///< where the weights were fitted, too
    std::optional<FittedParameter> visual_weight{};
    double log_likelihood = 0.0;
    double aic = 0.0;  ///< 2 parameters, with the weights 4
};

/// One noise and one lapse rate for all, with the weights of `model`; its own noise and lapse rate do not
/// matter. There must be choices. `level` of the intervals, in (0, 1).
[[nodiscard]] ObserverFit fitObserver(std::span<const SeenChoice> choices, const ObserverModel& model,
                                      double level);

/// The weights of two cues as well; `model` reads two cues.
[[nodiscard]] ObserverFit fitWeights(std::span<const SeenChoice> choices, const ObserverModel& model,
                                     double level);

/// What the fits maximise.
[[nodiscard]] double observerLogLikelihood(std::span<const SeenChoice> choices, const ObserverModel& model);

/// As participants differ in SimulatedParameters: each has noise_deg times max(0.2, 1 + noise_between z), z
/// standard normal, and all have the same lapse rate and the weights of `model`.
struct PopulationFit {
    double noise_deg = 0.0;
    double noise_between = 0.0;
    double lapse_rate = 0.0;
    double log_likelihood = 0.0;  ///< participants' noise integrated out
    double aic = 0.0;             ///< 3 parameters
};

/// `by_participant`: two and more participants, each with choices.
[[nodiscard]] PopulationFit fitPopulation(std::span<const std::vector<SeenChoice>> by_participant,
                                          const ObserverModel& model);

}  // namespace deixis::studies
