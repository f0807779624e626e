// Bringing a database to the newest schema.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// Brings a database of `from_version` (0: an empty one) to schema_version, with all that it holds. Call with
/// a transaction open and foreign keys not enforced; roll back where it fails. Fails where a stored plan
/// cannot be read or references are broken; failing SQLite calls throw. `path` is for the messages.
[[nodiscard]] Result<void> migrate(SQLite::Database& database, int from_version,
                                   const std::filesystem::path& path);

}  // namespace deixis::results
