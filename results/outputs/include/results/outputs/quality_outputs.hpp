// The quality of the data on the page.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/report_text.hpp"

namespace deixis::results {

/// A section: how far the ratings agree, whose answers stand out, and the study's rule.
[[nodiscard]] std::string qualityHtml(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
