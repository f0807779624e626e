// The step from schema version 2 to 3, and so to the newest: since then tables have only got columns that may
// be NULL.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// As migrate().
[[nodiscard]] Result<void> migrateTo3(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace deixis::results
