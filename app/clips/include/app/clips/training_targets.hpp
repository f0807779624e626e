// The targets that systems were trained on, as used by the objective evaluation and its grid.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "results/evaluation/evaluation.hpp"

namespace deixis::app {

struct TrainingTargets {
    std::vector<Vec3> targets;  ///< metres, in the avatar's frame
    std::string source;         ///< for people
    bool synthetic = false;
    results::InputFile file;  ///< what they were read or made from
};

/// From a manifest (each target once) or a list of targets; without a file those of the library of synthetic
/// demonstrations and of their mirror images.
[[nodiscard]] Result<TrainingTargets> loadTrainingTargets(const std::string& file);

}  // namespace deixis::app
