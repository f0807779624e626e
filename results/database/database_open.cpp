#include "results/database/database_open.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <system_error>
#include <thread>

#include "database_check.hpp"
#include "migration.hpp"
#include "results/database/database_files.hpp"
#include "results/database/schema.hpp"

namespace deixis::results {

namespace fs = std::filesystem;

namespace {

std::string immutableUri(const fs::path& database) {
    std::string uri = "file:";
    for (const char c : fs::absolute(database).string()) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '/' || c == '-' || c == '_' || c == '.')
            uri += c;
        else
            uri += fmt::format("%{:02X}", byte);
    }
    return uri + "?immutable=1";
}

tl::unexpected<Error> noSuchFile(const fs::path& path) {
    if (auto orphan = orphanBeside(path)) return tl::unexpected(std::move(*orphan));
    return fail(path.string(), "no such file, expected a database made by deixis",
                "Check the path; a run prints the path of its database");
}

/// In one transaction, and only if all of it succeeds. Foreign keys must not be enforced.
Result<void> migrateWhole(SQLite::Database& database, const fs::path& path) {
    database.exec("BEGIN IMMEDIATE");
    // Whose it is is asked under the write lock: another process may have set the file up in between.
    const auto whose = identify(database, path);
    const Result<void> done =
        whose ? migrate(database, whose->version, path) : Result<void>(tl::unexpected(whose.error()));
    database.exec(done ? "COMMIT" : "ROLLBACK");
    return done;
}

SQLite::Database upToDateCopy(SQLite::Database& source) {
    SQLite::Database copy(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    copyWhole(source, copy);
    return copy;
}

Result<SQLite::Database> openOnce(const fs::path& path, Missing missing) {
    std::error_code ignored;
    if (auto kind = checkKindOfFile(path); !kind) return tl::unexpected(kind.error());
    if (auto orphan = orphanBeside(path)) return tl::unexpected(std::move(*orphan));
    if (missing == Missing::reject && !fs::is_regular_file(path, ignored)) return noSuchFile(path);
    const auto folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        return fail(path.string(), fmt::format("the folder '{}' does not exist", folder.string()),
                    "Create it, or name a file elsewhere");
    const int create = missing == Missing::create ? SQLite::OPEN_CREATE : 0;
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | create, busy_timeout_ms);
    // Before anything is changed in it: what a log beside it holds stays there while it is not known to fit.
    sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    const auto whose = identify(database, path);
    if (!whose) return tl::unexpected(whose.error());
    if (whose->version > 0)
        if (auto sound = checkWhole(database, path, whose->version); !sound)
            return tl::unexpected(sound.error());
    sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr);
    if (sqlite3_db_readonly(database.getHandle(), "main") != 0)
        return fail(path.string(), "the database can be read but not written",
                    "Give yourself write permission for the file and its folder, or name another file");
    // Switching to WAL answers with the mode in force.
    if (database.execAndGet("PRAGMA journal_mode = WAL").getString() != "wal")
        return fail(path.string(), "the file system does not allow SQLite's write-ahead log",
                    "Keep the database on a local disk");
    database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = OFF");
    if (auto ready = migrateWhole(database, path); !ready) return tl::unexpected(ready.error());
    database.exec("PRAGMA foreign_keys = ON");
    return database;
}

bool isLocked(const SQLite::Exception& problem) {
    return problem.getErrorCode() == SQLITE_BUSY || problem.getErrorCode() == SQLITE_LOCKED;
}

}  // namespace

Result<SQLite::Database> openToWrite(const fs::path& path, Missing missing,
                                     std::chrono::milliseconds patience) {
    using Clock = std::chrono::steady_clock;
    // SQLite does not wait for every lock: where two might wait for each other, one is rejected at once.
    constexpr std::chrono::milliseconds between{20};
    // A machine that was stopped meanwhile (a laptop's lid, a virtual machine) has not waited all that long.
    constexpr std::chrono::nanoseconds longest_try = std::chrono::seconds(2);
    std::chrono::nanoseconds waited{0};
    for (;;) {
        const auto begin = Clock::now();
        try {
            return openOnce(path, missing);
        } catch (const SQLite::Exception& problem) {
            if (!isLocked(problem) || waited >= patience) throw;
        }
        std::this_thread::sleep_for(between);
        waited += std::min<std::chrono::nanoseconds>(Clock::now() - begin, longest_try);
    }
}

void copyWhole(SQLite::Database& from, SQLite::Database& to) {
    sqlite3_backup* backup = sqlite3_backup_init(to.getHandle(), "main", from.getHandle(), "main");
    if (backup == nullptr) throw SQLite::Exception(to.getHandle());
    constexpr int every_page = -1;
    const int stepped = sqlite3_backup_step(backup, every_page);
    sqlite3_backup_finish(backup);
    if (stepped != SQLITE_DONE) throw SQLite::Exception("the database cannot be copied", stepped);
}

Result<ReadOnlyDatabase> openReadOnly(const fs::path& path, WithLog log) {
    std::error_code problem;
    if (!fs::is_regular_file(path, problem)) return noSuchFile(path);
    if (auto orphan = orphanBeside(path)) return tl::unexpected(std::move(*orphan));
    try {
        // Without a log the file is all there is. Read as immutable it needs no files beside it, and so no
        // permission to write.
        const bool without_log = log == WithLog::where_there_is_one && !hasLog(path) && !hasJournal(path);
        const int flags = hasJournal(path) ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY;
        const auto written = fs::last_write_time(path, problem);
        SQLite::Database database =
            without_log ? SQLite::Database(immutableUri(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI)
                        : SQLite::Database(path.string(), flags, busy_timeout_ms);
        const auto whose = identify(database, path);
        if (!whose) return tl::unexpected(whose.error());
        if (whose->version == 0)
            return fail(path.string(), "the database has no study yet", "Run a session with it first");
        if (auto sound = checkWhole(database, path, whose->version); !sound) {
            // A writer may have begun, and changed what was read without its log.
            if (without_log &&
                (hasLog(path) || hasJournal(path) || fs::last_write_time(path, problem) != written))
                return openReadOnly(path, WithLog::yes);
            return tl::unexpected(sound.error());
        }
        if (whose->version < schema_version) {
            database = upToDateCopy(database);
            if (auto ready = migrateWhole(database, path); !ready) return tl::unexpected(ready.error());
        }
        database.exec("PRAGMA query_only = ON");
        return ReadOnlyDatabase(std::move(database), path, without_log, written, whose->version);
    } catch (const SQLite::Exception& caught) {
        return tl::unexpected(describe(path, caught));
    }
}

bool ReadOnlyDatabase::undisturbed() const {
    std::error_code problem;
    return !without_log_ || (!hasLog(path_) && !hasJournal(path_) &&
                             std::filesystem::last_write_time(path_, problem) == written_);
}

}  // namespace deixis::results
