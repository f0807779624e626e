// What people answered beside the objective evaluation of the same clips (deixis evaluate): whether what is
// pointed at more accurately gets better answers. Deichler et al. (2023), section 3.2, compare systems so, by
// their order.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "results/answers/response_table.hpp"
#include "results/statistics/spearman.hpp"

namespace deixis::results {

/// Equation 2 of the clips, as `deixis evaluate` writes it.
struct ObjectiveAccuracy {
    std::string file;
    std::map<std::string, double> systems{};                         ///< means over each system's clips
    std::map<std::string, std::map<std::string, double>> targets{};  ///< of each system by target
    std::map<std::string, Vec3> positions_m{};                       ///< of the targets
};

/// Reads the JSON. Errors name the file: it cannot be read, is no such JSON, or was written by a program
/// whose evaluations had no accuracy by target.
[[nodiscard]] Result<ObjectiveAccuracy> readObjectiveAccuracy(const std::filesystem::path& file);

/// Whether the clips that were evaluated may be those that were answered about. Error: no system has answers,
/// or a target lies elsewhere than in the study.
[[nodiscard]] Result<void> checkSameClips(const ObjectiveAccuracy& objective, const ResponseTable& table);

/// A system that has both.
struct ObjectiveMean {
    std::string measure;
    std::string system;
    double equation_2 = 0.0;  ///< mean over its clips
    double answers = 0.0;     ///< mean over participants
};

/// Of the mean answers in one measure and Equation 2.
struct ObjectiveCorrelation {
    std::string measure;
    std::string over;  ///< "systems": their means; "targets": those of one system
    std::string system{};
    SpearmanTest test{};
};

/// Of measures but preferences; systems and targets count where both have numbers.
struct ObjectiveComparison {
    std::vector<ObjectiveMean> means{};  ///< by measure
    /// Over the systems' means, and for each system over its targets.
    std::vector<ObjectiveCorrelation> correlations{};
};

}  // namespace deixis::results
