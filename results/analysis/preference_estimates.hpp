// Assumed preferences for a power analysis, estimated from preferences that were given; private to
// estimateEffects().
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "results/answers/response_table.hpp"
#include "studies/study_file/assumed_effects.hpp"

namespace deixis::results {

/// Strengths and zones by maximum likelihood of the answers taken one by one (ordered probit); the
/// participants' own part by the method of moments, from the covariance of a participant's answers to pairs
/// that have a system in common, over `systems`. Only ratios are in the answers: noise_sd is 1. Text: why
/// there is no estimate.
[[nodiscard]] std::variant<studies::AssumedPreference, std::string> estimatePreference(
    const ResponseTable& table, const std::vector<std::string>& systems);

}  // namespace deixis::results
