// Databases of earlier versions, as the programs of their times made them.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <filesystem>

#include "core/files.hpp"

#include "paths.hpp"

namespace fixtures {

/// Versions 1 to 5; see the files' heads.
inline void makeVersion(int version, const std::filesystem::path& path) {
    const auto sql = deixis::readFile(
        deixis::tests::sourceDir() / fmt::format("tests/results/reference/database_version_{}.sql", version));
    REQUIRE(sql);
    SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(*sql);
}

}  // namespace fixtures
