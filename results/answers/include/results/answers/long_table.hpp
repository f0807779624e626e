// Answers from any lab as a tidy table: one line per answer.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/answers/response_table.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::results {

/// How a CSV file of answers is to be read. Columns are named in any case.
struct LongTableOptions {
    std::vector<std::string> between{};  ///< columns that hold factors, constant within each participant
    std::vector<std::string> within{};   ///< likewise, others
    /// What the file calls a column: "rating" -> "slider.response".
    std::map<std::string, std::string> columns{};
    std::map<std::string, studies::Range> scales{};  ///< of ratings, by measure; else the range found
};

/// Reads a CSV file, as readForeignCsv() takes one, whose first line names its columns: participant and
/// system, and at least one of correct, rating and response; optional: other_system, with which a rating is a
/// preference from -2 (clearly for the system) to 2 (clearly for the other one), and those of
/// docs/analysis.md; and the factors named. responses.csv of an export is known by its columns. Systems and
/// levels stand in the order in which they appear. Ratings are named by their measure, else by their stage,
/// else "rating". What a reader may doubt is a note. Errors name file, line and column.
[[nodiscard]] Result<ResponseTable> loadLongTable(const std::filesystem::path& file,
                                                  const LongTableOptions& options = {});

/// loadResponses of a database, loadLongTable of any other file. A file of no bytes is an error, and so are
/// options for a database, whose study names its factors and scales.
[[nodiscard]] Result<ResponseTable> loadAnswers(const std::filesystem::path& file,
                                                const LongTableOptions& options = {});

}  // namespace deixis::results
