// The tables of an export: what stands in each column and where it comes from.
#pragma once

#include <string>
#include <vector>

#include "results/tables/csv_table.hpp"

namespace deixis::results {

/// What becomes of a column where an export is anonymised.
enum class Privacy : unsigned char {
    kept,
    participant,  ///< another id stands for it
    session,      ///< likewise
    clock,        ///< seconds since the session's start stand for it
    left_out
};

struct ExportColumn {
    ColumnSpec spec;
    std::string sql;  ///< in the query of the table
    Privacy privacy = Privacy::kept;
    std::string anonymous_sql{};  ///< in the place of `sql`, anonymised; empty: `sql` stays
};

/// One CSV file. The query is "SELECT <columns> <from>" for one participant, ?1; a column named `session`
/// must stand before any clock.
struct ExportTable {
    const char* file;
    const char* description;
    const char* from;
    std::vector<ExportColumn> columns;
};

/// responses.csv with the participants' groups and fields beside each row, trials.csv, sessions.csv and
/// events.csv.
[[nodiscard]] std::vector<ExportTable> exportTables(SQLite::Database& database);

}  // namespace deixis::results
