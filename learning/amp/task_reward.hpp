// What a policy is rewarded for as its task: how well a pose points at a target.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "learning/amp/settings.hpp"
#include "motion/pointing/rays.hpp"

namespace deixis::learning {

/// The line that is rewarded; none for an observer.
[[nodiscard]] std::optional<motion::PointingRay> rayOf(AmpTask task);

/// "Eq. 2", "Eq. 2 by eye-fingertip", "observer": the reward in ClipMeasures.
[[nodiscard]] std::string rewardName(AmpTask task);

/// What is pointed at, and for an observer two other balls, 20 to 40 cm away from it as in the game.
[[nodiscard]] std::vector<Vec3> ballsAround(AmpTask task, const Vec3& target_m, Random& random);

/// In [0, highest_pointing_reward]. Of a line Equation 2, with the line in the forearm's place. Of the
/// observer that chance, of highest_pointing_reward, with which the two-cue observer picks the first ball:
/// the mean of one who stands across and one who stands beside, where the paper's study has them. The map has
/// head and arms.
[[nodiscard]] double taskReward(AmpTask task, const motion::Skeleton& skeleton,
                                const motion::HumanoidMap& map, const std::vector<Pose>& world,
                                motion::Side hand, const std::vector<Vec3>& balls_m);

}  // namespace deixis::learning
