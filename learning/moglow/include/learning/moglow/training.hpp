// Training of the system moglow from demonstrations: their frames, the loss, when it is good enough, and how
// it goes on after an interruption.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/error.hpp"
#include "learning/training/training.hpp"
#include "motion/learned/moglow.hpp"

namespace deixis::learning {

/// Windows and rates are the paper's (section 2.4.1.1) and MoGlow's; the size is cut to what two cores train
/// in an hour: the paper's K 16, H 512 takes a minute for every three updates.
struct MoglowSettings {
    motion::MoglowShape shape{};
    double window_s = 6.0;
    double window_step_s = 0.5;
    double rest_before_s = 2.5;  ///< added at ease before each demonstration, the pointing bit off
    double rest_after_s = 3.5;
    int updates = 2500;
    int batch = 16;               ///< windows an update
    double learning_rate = 1e-3;  ///< Adam's, at the end of the warm-up
    int warm_up = 500;  ///< updates in which it rises; then it falls with the root of their number (Noam)
    double max_gradient = 5.0;
    double max_gradient_norm = 100.0;
    double dropout = 0.5;      ///< share of the past poses that are blanked, whole ones, without rescaling
    double noise = 0.02;       ///< SD of noise on the standardised numbers, without which rest has no density
    double temperature = 0.1;  ///< SD of the latents that are drawn: with 1 the noise comes back as shaking
    int validate_every = 200;  ///< updates
    std::uint64_t seed = 1;
    int threads = 1;
};

/// Trains, and writes the best weights to `file` whenever there are better ones, in float16. Beside it stands
/// FILE.training, from which a training of the same settings and data goes on after it was stopped or killed;
/// it is removed after the last update. Fails without demonstrations, where FILE.training is of another
/// training, and where the training diverges: the last good weights are kept.
/// Reports after every tenth update: "bits a frame" (negative log-likelihood) and "seconds an update", and
/// where the model was tried out "bits a frame held out".
[[nodiscard]] Result<TrainingOutcome> trainMoglow(const DemonstrationSets& data,
                                                  const MoglowSettings& settings,
                                                  const Provenance& provenance,
                                                  const std::filesystem::path& file,
                                                  const TrainingReport& report);

}  // namespace deixis::learning
