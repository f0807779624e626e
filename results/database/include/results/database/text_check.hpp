// Texts in a database that a server could not store: from an earlier version, or another program.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// The error names table, row and column of the first text that is not UTF-8 or holds a NUL.
[[nodiscard]] Result<void> checkTexts(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace deixis::results
