// Opening a database: what can be wrong with the file, in words for the person who named it.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "core/error.hpp"

namespace deixis::results {

/// The error that a failing SQLite call on the named file stands for.
[[nodiscard]] Error describe(const std::filesystem::path& path, const SQLite::Exception& problem);

/// Whether the open database is one of ours and of a version that this program knows. `empty` tells a file
/// without any tables, which is nobody's yet.
struct Identity {
    bool empty = false;
};
[[nodiscard]] Result<Identity> identify(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace deixis::results
