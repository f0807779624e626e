// The step from schema version 2 to 3.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// As migrate().
[[nodiscard]] Result<void> migrateTo3(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace deixis::results
