// What a database holds of its participants beside their answers.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Fills in fields, session_minutes and repeated_questionnaires. `people`: SQL in place of the table
/// `participants`.
void readParticipantFields(SQLite::Database& database, const std::string& people, ResponseTable& table);

}  // namespace deixis::results
