// What trainings have in common: the demonstrations that they learn from and choose by, what they report
// while they run, and how clips that are generated meanwhile are measured.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "motion/networks/weights_file.hpp"
#include "motion/skeleton/humanoid.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::learning {

/// The sets that a training knows. The targets of a study and of the evaluation's grid are a third set, which
/// it never sees.
struct DemonstrationSets {
    std::vector<motion::Demonstration> training;
    /// Held out: the weights that are kept are chosen by what is generated for their targets.
    std::vector<motion::Demonstration> validation;
    /// Of all demonstrations that were given, before any was mirrored.
    std::vector<Vec3> targets_m{};
    std::string sha256;     ///< of what they were made from
    bool synthetic = true;  ///< whether they were
};

/// Of 13 demonstrations the seventh is held out, and of fewer than 13 the middle one. With `mirrored` each is
/// followed by its mirror image in the same set.
[[nodiscard]] DemonstrationSets splitDemonstrations(std::vector<motion::Demonstration> demonstrations,
                                                    bool mirrored);

/// What the weights' file says of the program.
struct Provenance {
    std::string version;
    std::string commit;
};
/// Where they come from, into the file's header; the hash is of what they were trained on.
void setProvenance(motion::NetworkWeights& weights, const std::string& sha256, bool synthetic,
                   std::uint64_t seed, const Provenance& provenance);
void setProvenance(motion::NetworkWeights& weights, const DemonstrationSets& data, std::uint64_t seed,
                   const Provenance& provenance);

/// This process among several that share one training, as launchers tell it in RANK, WORLD_SIZE, MASTER_ADDR
/// and MASTER_PORT.
struct RankPlace {
    int rank = 0;                       ///< from 0
    int count = 1;                      ///< of processes
    std::string address = "127.0.0.1";  ///< of rank 0
    std::uint16_t port = 0;
};

/// How well a pose points at a target, higher is better. The map is of the skeleton.
using PoseReward = std::function<double(const motion::Skeleton&, const motion::HumanoidMap&,
                                        const std::vector<Pose>& world, motion::Side, const Vec3& target_m)>;

/// Of clips that are generated for some targets.
struct ClipMeasures {
    /// Equation 2 as pointingAccuracy() has it, mean; 0 where the hand is never slow. Or what a PoseReward
    /// says of the first posture of the hold.
    double reward = 0.0;
    std::string reward_name = "Eq. 2";  ///< what the reward is
    double error_rad = 0.0;             ///< of the forearm's line, mean over the clips in which it points
    /// Share of clips at whose end both hands are within 3 cm of the height they began at.
    double at_rest = 0.0;
    double end_height_m = 0.0;  ///< of the pointing hand at the end above where it began, mean
    double jerk_ratio = 0.0;    ///< mean jerk of the pointing hand over that of demonstrations
    /// Mean distance of the pointing elbow and wrist from the demonstration's; only where there are some.
    double arm_error_m = 0.0;
    /// What the weights that are kept are chosen by: reward - 0.3 (1 - at_rest) - 0.05 max(0, jerk_ratio -
    /// 1.5), without the second where a system cannot know when to go back to rest.
    [[nodiscard]] double score(bool can_know_end = true) const;
};
/// Clips for the demonstrations' own targets.
[[nodiscard]] ClipMeasures measureGenerated(const motion::Generator& system,
                                            const std::vector<motion::Demonstration>& demonstrations,
                                            std::uint64_t seed, const PoseReward& reward = {});
/// Clips for targets without demonstrations. `demonstrated_jerk`: meanJerk() of demonstrations.
[[nodiscard]] ClipMeasures measureAtTargets(const motion::Generator& system,
                                            const std::vector<Vec3>& targets_m, double demonstrated_jerk,
                                            std::uint64_t seed, const PoseReward& reward = {});
/// Of the pointing hands, m/s^3.
[[nodiscard]] double meanJerk(const std::vector<motion::Demonstration>& demonstrations);

/// Where a training is.
struct TrainingProgress {
    std::string part{};  ///< such as "cluster 2 of 8"; empty where there is one alone
    int update = 0;      ///< of that part
    int updates = 0;
    double done = 0.0;  ///< share of the whole training, 0 to 1
    /// Names and means since the last report, such as {"bits a frame", 12.1}.
    std::vector<std::pair<std::string, double>> numbers{};
    std::optional<ClipMeasures> validation{};  ///< where the model was tried out
    bool best = false;                         ///< it is the best one yet, and was written
};
/// Called every some updates, from one thread at a time. False: stop here.
using TrainingReport = std::function<bool(const TrainingProgress&)>;

struct TrainingOutcome {
    bool stopped = false;  ///< before all updates, as the report asked
    int updates = 0;       ///< of the whole, also those of earlier runs
    int best_update = 0;   ///< the file's; of several parts the last part's
    ClipMeasures best{};   ///< likewise the mean of the parts'
};

}  // namespace deixis::learning
