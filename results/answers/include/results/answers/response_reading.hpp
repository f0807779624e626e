// Reading the responses of an open database, wherever it came from.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// As loadResponses(); `path` is named in errors and, its last part, in the table. Failing SQLite calls
/// throw.
[[nodiscard]] Result<ResponseTable> readResponses(SQLite::Database& database,
                                                  const std::filesystem::path& path);

}  // namespace deixis::results
