// Assumed effects for a power analysis, estimated from collected answers. How: docs/power.md.
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/answers/response_table.hpp"
#include "studies/study_file/assumed_effects.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::results {

struct EffectEstimates {
    studies::AssumedEffects effects;
    std::vector<std::string> notes{};  ///< what a reader must know of them
};

/// Means of the study's systems, and SDs by the method of moments: the SDs with which the model's covariances
/// of two answers (of one participant, of one participant on one system, on one item) and variance are those
/// of the answers. A negative covariance counts as none. Lapses are not estimated, nor preferences in which
/// systems were not all preferred to each other, which the notes tell. Fails if the answers have no
/// measure of the study, or lack a system of it, or where all answers to a system are alike.
[[nodiscard]] Result<EffectEstimates> estimateEffects(const ResponseTable& table,
                                                      const studies::Study& study);

}  // namespace deixis::results
