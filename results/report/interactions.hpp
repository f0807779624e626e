// Interactions and equivalence on the report's page; private to it.
#pragma once

#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// Empty where no factors cross.
[[nodiscard]] std::string interactionsHtml(const AnalysisResult& result, Numbering& numbering);

/// Empty where no bound was declared.
[[nodiscard]] std::string equivalenceHtml(const AnalysisResult& result, Numbering& numbering);

/// Items of the list at the page's head: the significant ones.
[[nodiscard]] std::vector<std::string> interactionFindings(const AnalysisResult& result);

}  // namespace deixis::results
