// Training of the system moglow from demonstrations: their frames, the loss, when it is good enough, and how
// it goes on after an interruption.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/learned/moglow.hpp"
#include "motion/synthesis/demonstration_library.hpp"

namespace deixis::learning {

/// Windows and rates are the paper's (section 2.4.1.1) and MoGlow's; the size is cut to what two cores train
/// in an hour: the paper's K 16, H 512 takes a minute for every three updates.
struct MoglowSettings {
    motion::MoglowShape shape{};
    double window_s = 6.0;
    double window_step_s = 0.5;
    double rest_before_s = 2.5;  ///< added at ease before each demonstration, the pointing bit off
    double rest_after_s = 3.5;
    int updates = 4000;
    int batch = 8;                ///< windows an update
    double learning_rate = 1e-3;  ///< Adam's, at the end of the warm-up
    int warm_up = 1000;  ///< updates in which it rises; then it falls with the root of their number (Noam)
    double max_gradient = 5.0;
    double max_gradient_norm = 100.0;
    double dropout = 0.5;      ///< share of the past poses that are blanked, whole ones, without rescaling
    double noise = 0.02;       ///< SD of noise on the standardised numbers, without which rest has no density
    double temperature = 0.1;  ///< SD of the latents that are drawn: with 1 the noise comes back as shaking
    int validate_every = 200;  ///< updates
    std::uint64_t seed = 1;
    int threads = 1;
};

struct MoglowData {
    std::vector<motion::Demonstration> training;
    /// Held out: the model is chosen by what it generates for their targets.
    std::vector<motion::Demonstration> validation;
    std::string sha256;     ///< of what both were made from
    bool synthetic = true;  ///< whether they were
};

/// What the weights' file says of the program.
struct Provenance {
    std::string version;
    std::string commit;
};

/// Of clips that are generated for the targets of demonstrations.
struct MoglowMeasures {
    double reward = 0.0;  ///< Equation 2 as pointingAccuracy() has it, mean; 0 where the hand is never slow
    double at_rest =
        0.0;  ///< share of clips at whose end both hands are within 3 cm of the height they began at
    double jerk_ratio = 0.0;  ///< mean jerk of the pointing hand over that of the demonstrations
    /// What the best weights are chosen by: reward - 0.1 (1 - at_rest) - 0.02 max(0, jerk_ratio - 1.5).
    [[nodiscard]] double score() const;
};
[[nodiscard]] MoglowMeasures measureGenerated(const motion::Generator& system,
                                              const std::vector<motion::Demonstration>& demonstrations,
                                              std::uint64_t seed);

struct MoglowProgress {
    int update = 0;
    int updates = 0;
    double bits = 0.0;  ///< negative log-likelihood, bits a frame, mean since the last report
    double seconds_an_update = 0.0;
    /// Where the model was tried out.
    std::optional<MoglowMeasures> validation{};
    double validation_bits = 0.0;
    bool best = false;  ///< it is the best one yet, and was written
};
/// Called after every tenth update. False: stop here.
using MoglowReport = std::function<bool(const MoglowProgress&)>;

struct MoglowOutcome {
    int updates = 0;
    bool stopped = false;  ///< before all updates, as the report asked
    int best_update = 0;
    MoglowMeasures best{};
};

/// Trains, and writes the best weights to `file` whenever there are better ones, in float16. Beside it stands
/// FILE.training, from which a training of the same settings and data goes on after it was stopped or killed;
/// it is removed after the last update. Fails without demonstrations, where FILE.training is of another
/// training, and where the training diverges: the last good weights are kept.
[[nodiscard]] Result<MoglowOutcome> trainMoglow(const MoglowData& data, const MoglowSettings& settings,
                                                const Provenance& provenance,
                                                const std::filesystem::path& file,
                                                const MoglowReport& report);

}  // namespace deixis::learning
