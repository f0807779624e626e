// The database's schema and the two numbers by which a file is known to be ours.
#pragma once

#include <vector>

namespace deixis::results {

/// "DXIS" in ASCII, as SQLite's application_id.
inline constexpr int application_id = 0x44584953;

/// SQLite's user_version. Raise it with every change of the tables, and add the step that makes the change.
inline constexpr int schema_version = 2;

/// The SQL that brings a database of `from_version` (0: an empty one) to schema_version, to be run in this
/// order and in one transaction. Column by column in docs/database.md.
[[nodiscard]] std::vector<const char*> schemaSteps(int from_version);

}  // namespace deixis::results
