// Abilities from preferences in the analysis's outputs; private to them.
#pragma once

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// Empty if there are no preferences.
[[nodiscard]] Section bradleyTerrySection(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
