// The report's tables of tests; private to the report.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// The section with its heading: Friedman's test over all systems, all pairs of systems, the levels within
/// systems, preferences. Empty where nothing can be compared.
[[nodiscard]] Section testsSection(const AnalysisResult& result, Numbering& numbering);

/// The tests of one of several studies: all systems, their pairs, preferences. Empty where nothing can be
/// compared.
[[nodiscard]] std::string studyTestsHtml(const AnalysisResult& study, Numbering& numbering);

}  // namespace deixis::results
