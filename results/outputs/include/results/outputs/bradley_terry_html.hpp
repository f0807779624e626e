// Abilities from preferences in the analysis's outputs; private to them.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// Empty if there are no preferences.
[[nodiscard]] std::string bradleyTerryHtml(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
