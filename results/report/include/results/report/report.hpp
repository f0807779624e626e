// The report: the page that presents the results of an analysis in words, tables and figures.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// A whole, self-contained HTML page (also well-formed XML), without outside file or date: the same table
/// gives the same bytes. Its figures are Vega-Lite specifications, which the script in it draws.
[[nodiscard]] std::string renderReport(const AnalysisResult& result);

}  // namespace deixis::results
