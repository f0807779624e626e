// The database's schema and the two numbers by which a file is known to be ours.
#pragma once

namespace deixis::results {

/// "DXIS" in ASCII, as SQLite's application_id.
inline constexpr int application_id = 0x44584953;

/// SQLite's user_version. Raise it with every change of the tables.
inline constexpr int schema_version = 1;

/// Creates all tables and views of schema_version. Column by column in docs/database.md.
extern const char* const schema_sql;

}  // namespace deixis::results
