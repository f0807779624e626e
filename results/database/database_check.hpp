// Looking a database over before anything is read from it or written to it.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// The file's structure, every row against what its columns may hold, and every index (integrity_check). In
/// the newest schema also: that what rows refer to is there, and that every answer is as it was written
/// (answer_hash.hpp). The error names the first fault. Failing SQLite calls throw.
[[nodiscard]] Result<void> checkWhole(SQLite::Database& database, const std::filesystem::path& path,
                                      int version);

}  // namespace deixis::results
