// Correct choices against angles in the report; private to it.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// A figure for the avatar's eyes and one for each layout, and their table; empty where no angle was kept.
[[nodiscard]] std::string anglesHtml(const AnalysisResult& result, Numbering& figures, Numbering& tables);

}  // namespace deixis::results
