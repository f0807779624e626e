// The analysis' tables of sensitivity, groups, choices and questionnaires; private to its tables.
#pragma once

#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/tables/plain_table.hpp"

namespace deixis::results {

[[nodiscard]] std::vector<PlainTable> furtherTables(const AnalysisResult& result);

}  // namespace deixis::results
