// What a paper says of the study: its design, its methods in a paragraph, and its limits.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// A section: systems, measures, factors, participants and answers.
[[nodiscard]] std::string designHtml(const AnalysisResult& result);

/// A section: a paragraph on methods to be copied, and what the numbers cannot tell.
[[nodiscard]] std::string paperHtml(const AnalysisResult& result);

}  // namespace deixis::results
