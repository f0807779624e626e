// Single ratings in analysis.json; private to it.
#pragma once

#include <nlohmann/json.hpp>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// Adds pairwise_ratings, author_trials and author_trials_by_participants.
void addRatings(nlohmann::ordered_json& out, const AnalysisResult& result);

}  // namespace deixis::results
