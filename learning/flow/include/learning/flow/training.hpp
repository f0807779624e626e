// Training of the system flow from demonstrations: a minute or two, so that it begins anew where it was
// stopped.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/error.hpp"
#include "learning/training/training.hpp"
#include "motion/learned/flow_matching.hpp"

namespace deixis::learning {

struct FlowSettings {
    motion::FlowMatchingShape shape{};
    double eye_limit_rad = radiansFromDegrees(25.0);
    int updates = 20'000;
    int batch = 128;
    double learning_rate = 1e-3;  ///< Adam's at the begin; falls as a cosine to a hundredth
    /// SD of noise on what is seen of a target (radians, 1/m). There is one demonstration of a target:
    /// without it the network would learn that there is one way to point at it.
    double blur = 0.3;
    /// Share of noise in what is learned to be drawn, an SD: a few dozen demonstrations in as many directions
    /// are points far from each other, and what is between them is as likely.
    double smoothing = 0.5;
    int validate_every = 2'000;
    std::uint64_t seed = 1;
};

/// Trains, and writes the weights to `file` in float32 whenever they are better. `data` is without
/// mirror images, which would be its demonstrations twice: the left hand is learned mirrored. Fails with
/// fewer than eight demonstrations to train on or none held out, and where the training diverges. Reports
/// "squared error", as a share of the variance of what is predicted, and where the model was tried out its
/// measures.
[[nodiscard]] Result<TrainingOutcome> trainFlow(const DemonstrationSets& data, const FlowSettings& settings,
                                                const Provenance& provenance,
                                                const std::filesystem::path& file,
                                                const TrainingReport& report);

/// How much gestures for one target differ, metres: the root mean square distance of elbow, wrist and
/// fingertip from where they are on average, over gestures and the times of a gesture as it is aligned.
struct Spread {
    double demonstrated_m = 0.0;  ///< of demonstrations, from what the others predict where they point
    double drawn_m = 0.0;         ///< of the system's draws for the same places
    double unguided_m = 0.0;      ///< likewise, without guidance
};
/// `demonstrations`: those that the model was trained on.
[[nodiscard]] Spread flowSpread(const motion::FlowMatching& model,
                                const std::vector<motion::Demonstration>& demonstrations, std::uint64_t seed);

}  // namespace deixis::learning
