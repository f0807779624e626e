// The database's schema and the two numbers by which a file is known to be ours. Column by column in
// docs/database.md.
#pragma once

namespace deixis::results {

/// "DXIS" in ASCII, as SQLite's application_id.
inline constexpr int application_id = 0x44584953;

/// SQLite's user_version. Raise it with every change of the tables, and add the step to migrate() and
/// to server_schema.cpp.
inline constexpr int schema_version = 4;

extern const char* const schema_2_from_1;  ///< brings version 1 to version 2
extern const char* const schema_4_from_3;  ///< brings version 3 to version 4
extern const char* const newest_tables;    ///< for an empty database, or beside old tables renamed
extern const char* const newest_views;     ///< replaces them

}  // namespace deixis::results
