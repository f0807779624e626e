#include "migration.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "migration_3.hpp"
#include "results/database/migration_5.hpp"
#include "results/database/schema.hpp"
#include "results/database/views.hpp"

namespace deixis::results {

namespace {

/// From the version before to `version`.
Result<void> step(SQLite::Database& database, int version, const std::filesystem::path& path) {
    switch (version) {
        case 2:
            database.exec(step_2);
            return {};
        case 3:
            return migrateTo3(database, path);
        case 4:
            database.exec(step_4);
            return {};
        case 5:
            migrateTo5(database);
            return {};
        case 6:
            database.exec(step_6);
            database.exec(step_6_trials);
            return {};
        default:
            throw std::logic_error(fmt::format("no step leads to version {} of the database", version));
    }
}

}  // namespace

Result<void> migrate(SQLite::Database& database, int from_version, const std::filesystem::path& path) {
    if (from_version == schema_version) {
        database.exec(createMissingViews());
        return {};
    }
    if (from_version == 0) {
        database.exec(newest_tables);
    } else {
        // What a step takes out of the file is overwritten. The views are made again at the end, and would
        // stand in the way of what changes the tables.
        database.exec("PRAGMA secure_delete = ON;" + dropViews());
        for (int version = from_version + 1; version <= schema_version; ++version)
            if (auto done = step(database, version, path); !done) return done;
    }
    database.exec(createViews());
    if (database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() != 0)
        return fail(
            path.string(),
            fmt::format("the database of version {} has rows that refer to missing rows", from_version),
            "It was changed by another program; use a copy from before that");
    database.exec(fmt::format("PRAGMA application_id = {}", application_id));
    database.exec(fmt::format("PRAGMA user_version = {}", schema_version));
    return {};
}

}  // namespace deixis::results
