// Training of the systems amp-no-runtime, amp-base and amp-pfnn: one policy for each cluster of targets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "learning/amp/clusters.hpp"
#include "learning/amp/settings.hpp"
#include "learning/training/training.hpp"

namespace deixis::learning {

/// What is trained, and how the work is shared.
struct AmpTraining {
    std::string system;  ///< the name that the file gives it, such as "amp-pfnn-8"
    AmpSettings settings{};
    AmpClusters clusters{};
    std::optional<int> only_cluster{};  ///< of them, for a file that joinAmp() puts together with others
    int threads = 1;                    ///< that many clusters at the same time
    std::optional<RankPlace> rank{};    ///< where several processes share the training
};

/// Trains, and writes `file` (float16): when each policy has learned what the demonstrations do, before any
/// has tried out anything, and then whenever there is a better one. Beside it stands the folder
/// FILE.training, from which a training of the same settings and data goes on after it was stopped or killed,
/// from where the policies were last tried out; it is removed after the last iteration. Of several ranks the
/// first alone writes. Fails where the body cannot follow a demonstration, where FILE.training is of another
/// training, and where the training diverges: the last good policies are kept. Reports after every tenth
/// iteration: "task reward", "style reward" (means over the controls), "logit of agent" and "of
/// demonstrations", and "samples a second"; and where a policy was tried out.
[[nodiscard]] Result<TrainingOutcome> trainAmp(const DemonstrationSets& data, const AmpTraining& training,
                                               const Provenance& provenance,
                                               const std::filesystem::path& file,
                                               const TrainingReport& report);

/// Puts together what was trained with `only_cluster`, one file a cluster. Fails where a cluster is missing
/// or there twice, and where files are of different trainings.
[[nodiscard]] Result<void> joinAmp(const std::vector<std::filesystem::path>& parts,
                                   const std::filesystem::path& file);

}  // namespace deixis::learning
