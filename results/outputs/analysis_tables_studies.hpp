// The analysis' tables of several studies; private to its tables.
#pragma once

#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

/// Each study by itself, medians in order, and where the answers come from; without rows of one study.
[[nodiscard]] std::vector<PlainTable> studyTables(const AnalysisResult& result);

// Of any analysis.
[[nodiscard]] PlainTable meansTable(const AnalysisResult& result);
[[nodiscard]] PlainTable omnibusTable(const AnalysisResult& result);
[[nodiscard]] PlainTable pairwiseTable(const AnalysisResult& result);
[[nodiscard]] PlainTable betweenTable(const AnalysisResult& result);
[[nodiscard]] PlainTable preferencesTable(const AnalysisResult& result);

}  // namespace deixis::results
