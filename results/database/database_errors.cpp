#include "results/database/database_errors.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include "results/database/schema.hpp"

namespace deixis::results {

Error describe(const std::filesystem::path& path, const SQLite::Exception& problem) {
    const std::string where = path.string();
    switch (problem.getErrorCode()) {
        case SQLITE_NOTADB:
            return {where, "found a file that is not a SQLite database",
                    "Name another file, or move this one away"};
        case SQLITE_CORRUPT:
            return {where, fmt::format("the database is damaged ({})", problem.what()),
                    "Keep a copy, and try the sqlite3 shell's .recover on it"};
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return {where, "the database is locked by another program",
                    "Close the program that has it open (another deixis, an SQLite browser), then try again"};
        case SQLITE_READONLY:
            if (problem.getExtendedErrorCode() == SQLITE_READONLY_ROLLBACK)
                return {where, "a change of the database was interrupted and has to be undone first",
                        "Give yourself write permission for the file, its '-journal' and their folder"};
            return {where, "the database can be read but not written",
                    "Give yourself write permission for the file and its folder, or name another file"};
        case SQLITE_CANTOPEN:
            return {where, "the database cannot be opened or created",
                    "Check that the folder exists and that you may read and write in it"};
        case SQLITE_FULL:
            return {where, "the disk is full", "Free some space, then try again"};
        default:
            return {where, fmt::format("SQLite reports: {}", problem.what()), ""};
    }
}

Result<Identity> identify(SQLite::Database& database, const std::filesystem::path& path) {
    // In one statement: another process may be setting the file up.
    SQLite::Statement all(database,
                          "SELECT (SELECT count(*) FROM sqlite_schema), (SELECT application_id FROM "
                          "pragma_application_id), (SELECT user_version FROM pragma_user_version)");
    all.executeStep();
    const int tables = all.getColumn(0).getInt();
    const int id = all.getColumn(1).getInt();
    const int version = all.getColumn(2).getInt();
    if (id == 0 && version == 0 && tables == 0) return Identity{};
    if (id != application_id)
        return fail(path.string(), "found a SQLite database of another program, expected one made by deixis",
                    "Name another file");
    if (version > schema_version)
        return fail(path.string(),
                    fmt::format("found database version {}, but this program knows versions up to {}",
                                version, schema_version),
                    "Use the newer deixis that made it");
    if (version < 1)
        return fail(path.string(),
                    fmt::format("found database version {}, expected 1 to {}", version, schema_version),
                    "Name another file");
    return Identity{version};
}

}  // namespace deixis::results
