// The database's schema and the two numbers that identify a file as ours. Column by column in
// docs/database.md.
#pragma once

namespace deixis::results {

/// "DXIS" in ASCII, as SQLite's application_id.
inline constexpr int application_id = 0x44584953;

/// SQLite's user_version. Raise it with every change of the tables, and add the step to migrate() and
/// to server_schema.cpp.
inline constexpr int schema_version = 6;

// The files of results/schema. A step, once released, is never changed: it knows only tables as they were in
// its two versions.
extern const char* const step_2;         ///< brings version 1 to version 2
extern const char* const step_3_tables;  ///< of version 3, beside those of version 2 renamed
extern const char* const step_3_rows;    ///< brings over what migration_3.cpp does not
extern const char* const step_4;         ///< brings version 3 to version 4
extern const char* const step_5;         ///< brings version 4 to version 5, but for tokens
extern const char* const step_6;         ///< brings version 5 to version 6, but for columns of trials,
extern const char* const step_6_trials;  ///< which SQLite takes out so
extern const char* const newest_tables;  ///< for an empty database
extern const char* const newest_views;   ///< those of no kind of trial, see views.hpp

}  // namespace deixis::results
