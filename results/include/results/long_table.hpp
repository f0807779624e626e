// Answers from any lab as a tidy table: one line an answer.
#pragma once

#include <filesystem>

#include "core/error.hpp"
#include "results/response_table.hpp"

namespace deixis::results {

/// Reads a CSV file whose first line names its columns: participant and system, and at least one of correct,
/// rating and response; optional: stage, measure, layout, distance, trial, order, item, rt, attention,
/// practice, synthetic, balls (docs/analysis.md). Systems, layouts and distances stand in the order in which
/// they appear. Ratings are named by their measure, else by their stage, else "rating"; their scale is the
/// range that was found. Errors name file, line and column.
[[nodiscard]] Result<ResponseTable> loadLongTable(const std::filesystem::path& file);

/// loadResponses of a database, loadLongTable of any other file.
[[nodiscard]] Result<ResponseTable> loadAnswers(const std::filesystem::path& file);

}  // namespace deixis::results
