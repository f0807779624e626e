// What a paper says of the study: its design, its methods in a paragraph, and its limits.
#pragma once

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// Systems, measures, factors, participants and answers, with the figures of the head (figuresHtml()).
[[nodiscard]] Section designSection(const AnalysisResult& result, Numbering& figures);

/// A paragraph on methods to be copied, and what the numbers cannot tell.
[[nodiscard]] Section paperSection(const AnalysisResult& result);

}  // namespace deixis::results
