// What a paper says of the study: its design, its methods in a paragraph, and its limits.
#pragma once

#include "results/analysis/analysis.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// A section: systems, measures, factors, participants and answers.
[[nodiscard]] Section designSection(const AnalysisResult& result);

/// A section: a paragraph on methods to be copied, and what the numbers cannot tell.
[[nodiscard]] Section paperSection(const AnalysisResult& result);

}  // namespace deixis::results
