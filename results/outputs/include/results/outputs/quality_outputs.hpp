// The quality of the data on the page, in JSON and as tables; private to the analysis' outputs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/report_text.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

/// A section: how far the ratings agree, whose answers stand out, and the study's rule.
[[nodiscard]] std::string qualityHtml(const AnalysisResult& result, Numbering& numbering);
[[nodiscard]] nlohmann::ordered_json qualityJson(const AnalysisResult& result);
[[nodiscard]] PlainTable reliabilityTable(const AnalysisResult& result);
[[nodiscard]] PlainTable qualityTable(const AnalysisResult& result);  ///< every participant

}  // namespace deixis::results
