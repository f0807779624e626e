#include "migration.hpp"

#include <fmt/core.h>

#include "migration_3.hpp"
#include "schema.hpp"

namespace deixis::results {

Result<void> migrate(SQLite::Database& database, int from_version, const std::filesystem::path& path) {
    if (from_version == schema_version) return {};
    if (from_version == 0) {
        database.exec(newest_tables);
    } else if (from_version == 3) {
        database.exec(schema_4_from_3);
    } else {
        if (from_version == 1) database.exec(schema_2_from_1);
        if (auto done = migrateTo3(database, path); !done) return done;
    }
    database.exec(newest_views);
    if (database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() != 0)
        return fail(path.string(),
                    fmt::format("the database of version {} has rows that refer to rows which are not there",
                                from_version),
                    "It was changed by another program; use a copy from before that");
    database.exec(fmt::format("PRAGMA application_id = {}", application_id));
    database.exec(fmt::format("PRAGMA user_version = {}", schema_version));
    return {};
}

}  // namespace deixis::results
