// Single ratings and authors' trials as tables; private to the analysis' tables.
#pragma once

#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

[[nodiscard]] PlainTable ratingPairsTable(const AnalysisResult& result);
[[nodiscard]] PlainTable authorTrialsTable(const AnalysisResult& result);
[[nodiscard]] PlainTable authorTrialsPairedTable(const AnalysisResult& result);
/// These.
[[nodiscard]] std::vector<PlainTable> ratingTables(const AnalysisResult& result);

}  // namespace deixis::results
