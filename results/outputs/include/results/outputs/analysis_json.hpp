// The analysis as JSON: analysis.json, with the keys described in docs/analysis.md.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// One JSON object; its keys stand in docs/analysis.md. Numbers in full precision, fixed order: the same
/// table gives the same bytes. What is not defined is null.
[[nodiscard]] std::string analysisJson(const AnalysisResult& result);

}  // namespace deixis::results
