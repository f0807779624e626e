// Groups of participants in the analysis' JSON; private to it.
#pragma once

#include <nlohmann/json.hpp>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

[[nodiscard]] nlohmann::ordered_json groupInteractionsJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json betweenJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json preferencesBetweenJson(const AnalysisResult& result);

[[nodiscard]] nlohmann::ordered_json scoreGroupsJson(const AnalysisResult& result);
[[nodiscard]] nlohmann::ordered_json timeGroupsJson(const AnalysisResult& result);

}  // namespace deixis::results
