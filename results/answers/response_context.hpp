// What a database tells of answers besides their values; private to the response table.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Fills in groups, further factors, marks, failed checks and the choices with their balls; takes out of
/// left_out_rows who declined consent. Needs the rows. `people`: SQL in place of the table `participants`.
void readResponseContext(SQLite::Database& database, const std::string& people, ResponseTable& table);

}  // namespace deixis::results
