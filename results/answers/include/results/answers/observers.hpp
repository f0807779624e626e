// What simulated observers of several kinds choose after the same arms: how far a system's accuracy
// depends on how pointing is read. They are no evidence about people. docs/evaluation.md.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "studies/observers/observer.hpp"

namespace deixis::results {

/// An arm that was held out, and the balls that it may mean.
struct ReadTrial {
    std::string system;
    std::string layout;
    studies::SeenArm arm{};
    std::vector<Vec3> balls{};  ///< two and more, the target first
    double answers = 1.0;       ///< how many such trials this one stands for
};

/// A choice of the game, and the arm that it was made after.
struct ObservedChoice {
    ReadTrial seen{};
    int chosen = 0;             ///< of the balls
    studies::ArmLines first{};  ///< of the arm when the hold began
    studies::ArmLines last{};   ///< and when it ended
    std::string participant{};  ///< who chose
};

/// Choices where an arm continues moving while it is held: of the ball nearest to a line when the hold began,
/// or when it ended (Deichler et al. 2023, section 4).
struct DriftResult {
    std::string system;
    std::string line;  ///< "arm-finger", "eye-fingertip"
    int choices = 0;
    int of_first = 0;  ///< of the ball that is nearest when the hold begins
    int of_last = 0;   ///< when it ends
    int moved = 0;     ///< choices after arms at whose end another ball is nearest than at the beginning;
    int moved_first = 0, moved_last = 0;  ///< of those, of the first one, of the last one
};

/// By system in the order given, for each line.
[[nodiscard]] std::vector<DriftResult> countDrift(const std::vector<ObservedChoice>& choices,
                                                  const std::vector<std::string>& systems);

/// The observers compared, in the order of the tables: two-cue, arm-finger, eye-fingertip.
inline constexpr std::array<const char*, 3> observer_names{"two-cue", "arm-finger", "eye-fingertip"};

struct ObserverReading {
    std::string system;
    std::string layout;  ///< "all": over the layouts' trials
    double trials = 0.0;
    /// Of each observer, the expected share of correct choices with the noise and lapses of the parameters
    /// that ship,
    std::array<double, observer_names.size()> accuracy{};
    /// and with neither: the ceiling of that reading, the share in which the target is what is read.
    std::array<double, observer_names.size()> without_error{};
};

/// By system in the order given, over all layouts first where there are several. The arms' `line` is not
/// looked at.
[[nodiscard]] std::vector<ObserverReading> readByObservers(const std::vector<ReadTrial>& trials,
                                                           const std::vector<std::string>& systems);

/// The systems as one observer ranks them, the best first; those within a hundredth of the first of their
/// group are ranked alike, in the order of the readings.
using ObserverRanking = std::vector<std::vector<std::string>>;

/// By observer, over all layouts.
[[nodiscard]] std::array<ObserverRanking, observer_names.size()> observerRankings(
    const std::vector<ObserverReading>& readings);

/// What a system can reach that plays the demonstration whose target is nearest: each ball is read by an
/// observer without any error who sees it from between the pointer's eyes, as the line to the nearest
/// training target would have it.
struct NearestCeiling {
    int targets = 0;
    double median_distance_m = 0.0;  ///< from a target to the nearest training target
    double share_right = 0.0;
};

/// `balls`: of each target, itself first. There must be targets and training targets.
[[nodiscard]] NearestCeiling nearestCeiling(const std::vector<std::vector<Vec3>>& balls,
                                            const std::vector<Vec3>& training, const Vec3& pointer_eye);

}  // namespace deixis::results
