// Several studies in analysis.json; private to it.
#pragma once

#include <nlohmann/json.hpp>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// Each of several studies by itself, with where its answers come from; empty of one study.
[[nodiscard]] nlohmann::ordered_json byStudyJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json mediansJson(const AnalysisResult& result);

// Of any analysis.
[[nodiscard]] nlohmann::ordered_json systemsJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json omnibusJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json pairwiseJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json preferencesJson(const AnalysisResult& result);

}  // namespace deixis::results
