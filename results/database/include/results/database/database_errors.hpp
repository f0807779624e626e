// Errors on opening a database: what is wrong with the file, in words for the user.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// The error that a failing SQLite call on the named file stands for.
[[nodiscard]] Error describe(const std::filesystem::path& path, const SQLite::Exception& problem);

/// What the open database says of itself.
struct Identity {
    int version = 0;  ///< of its schema; 0: a file without any tables, which is nobody's yet
};
/// Errors: another program's database, or a version newer than this program knows.
[[nodiscard]] Result<Identity> identify(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace deixis::results
