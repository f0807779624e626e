// The tables of an export that are more than a query: participants with their fields, scores, questions,
// tracked frames.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <string>

#include "anonymous_names.hpp"
#include "core/error.hpp"
#include "results/tables/csv_table.hpp"

namespace deixis::results {

struct ExportedFile {
    std::string name;
    std::string description;
    CsvTable table;
};

/// One row a participant; a column for each between-participants factor and each declared field.
[[nodiscard]] ExportedFile participantsFile(SQLite::Database& database, const AnonymousNames& naming,
                                            bool anonymise);
/// The questionnaires' scores, a row each.
[[nodiscard]] ExportedFile scoresFile(SQLite::Database& database, const AnonymousNames& naming);
/// What was asked, with the words that were read: a row for each option or labelled step of a question.
[[nodiscard]] ExportedFile questionsFile(SQLite::Database& database);
/// One row a tracked frame, written to `file` as it is read, for it may be larger than memory; the table that
/// comes back has its columns and number of rows only.
[[nodiscard]] Result<ExportedFile> trackingFile(SQLite::Database& database, const AnonymousNames& naming,
                                                bool anonymise, const std::filesystem::path& file);

}  // namespace deixis::results
