// The analysis as tables for other programs and for papers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

enum class TableFormat : unsigned char {
    csv,   ///< full precision, all columns; also the answers and the participants' means
    latex  ///< rounded, one tabular a file, for the booktabs package
};

/// File names ("pairwise.csv") and what to write to them; tables without rows are left out. The columns stand
/// in docs/analysis.md. The same analysis gives the same bytes.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> analysisTables(const AnalysisResult& result,
                                                                              TableFormat format);

}  // namespace deixis::results
