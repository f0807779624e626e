// Answers of questionnaires that rate systems as a whole; private to the reading of a database.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Adds what the study says of such questions to the table: measures, systems and rows. `people`: SQL in
/// place of the table `participants`.
void readSurveyRatings(SQLite::Database& database, const std::string& people, ResponseTable& table);

}  // namespace deixis::results
