// The columns of a test, which many of the analysis' tables have; private to its tables.
#pragma once

#include <string>

#include "results/outputs/analysis_tables.hpp"

namespace deixis::results {

/// Behind all columns of a test in JSON.
inline constexpr int behind_test = 1000;

/// A signed-rank test. `missing`: who has not both of `participants`.
[[nodiscard]] Fields<AdjustedTest> testFields(const AnalysisResult& result);
/// A rank-sum test.
[[nodiscard]] Fields<GroupTest> groupFields(const AnalysisResult& result);

/// "not significant", "A higher".
[[nodiscard]] std::string decisionText(const AdjustedTest& one, const char* without_pairs);

/// A column of JSON alone with the same text in each row.
template <typename Row>
[[nodiscard]] Field<Row> noteField(const char* text) {
    return {"note", [text](const Row&) { return std::string(text); }, {.in = in_json, .place = behind_test}};
}

}  // namespace deixis::results
