// Answers from any lab as a tidy table: one line an answer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/response_table.hpp"

namespace deixis::results {

/// Columns of a CSV file that hold factors, in any case.
struct FactorColumns {
    std::vector<std::string> between{};  ///< constant within each participant
    std::vector<std::string> within{};
};

/// Reads a CSV file whose first line names its columns: participant and system, and at least one of correct,
/// rating and response; optional: stage, measure, layout, distance, trial, order, item, rt, attention,
/// practice, synthetic, balls, excluded, marked (docs/analysis.md), and the factors named. Systems and levels
/// stand in the order in which they appear. Ratings are named by their measure, else by their stage, else
/// "rating"; their scale is the range that was found. Errors name file, line and column.
[[nodiscard]] Result<ResponseTable> loadLongTable(const std::filesystem::path& file,
                                                  const FactorColumns& factors = {});

/// loadResponses of a database, loadLongTable of any other file. A file of no bytes is an error, and so are
/// factors' columns for a database, whose study names its factors.
[[nodiscard]] Result<ResponseTable> loadAnswers(const std::filesystem::path& file,
                                                const FactorColumns& factors = {});

}  // namespace deixis::results
