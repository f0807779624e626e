// The keys of a test in analysis.json; private to it.
#pragma once

#include <nlohmann/json.hpp>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// A signed-rank test's, behind those that are there.
void addTest(nlohmann::ordered_json& out, const AdjustedTest& adjusted, const AnalysisResult& result);

/// A rank-sum test's.
void addGroupTest(nlohmann::ordered_json& out, const GroupTest& one, double alpha);

[[nodiscard]] nlohmann::ordered_json equivalenceJson(const Equivalence& one);

}  // namespace deixis::results
