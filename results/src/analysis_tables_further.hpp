// The analysis' tables of sensitivity, groups, choices and questionnaires; private to its tables.
#pragma once

#include <vector>

#include "plain_table.hpp"
#include "results/analysis.hpp"

namespace deixis::results {

[[nodiscard]] std::vector<PlainTable> furtherTables(const AnalysisResult& result);

}  // namespace deixis::results
