// Abilities from preferences in the analysis' outputs; private to them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/report_text.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

/// Null where there are no preferences.
[[nodiscard]] nlohmann::ordered_json bradleyTerryJson(const AnalysisResult& result);
[[nodiscard]] PlainTable bradleyTerryTable(const AnalysisResult& result);
/// Empty where there are no preferences.
[[nodiscard]] std::string bradleyTerryHtml(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
