// Erasing a person: every row, then every trace that the rows leave in the file and its log.
#include <fmt/core.h>
#include <sqlite3.h>

#include <optional>

#include "core/durable.hpp"
#include "results/database/database_open.hpp"
#include "results/database/tables.hpp"
#include "results/participants/participants.hpp"
#include "results/store/participant_lock.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;

bool known(SQLite::Database& database, const std::string& participant) {
    SQLite::Statement row(database, "SELECT 1 FROM participants WHERE id = ?");
    row.bind(1, participant);
    return row.executeStep();
}

bool isUncleared(SQLite::Database& database) {
    return database.execAndGet("SELECT count(*) FROM withdrawals WHERE cleared = 0").getInt() > 0;
}

/// The file is this connection's alone until it ends: out of the log's mode nobody else can be reading, and
/// the lock is then kept. In the log's mode again, since it writes no page as it was before: a rollback
/// journal would hold the person's rows.
Result<void> takeAlone(SQLite::Database& database, const fs::path& path) {
    database.exec("PRAGMA secure_delete = ON; PRAGMA locking_mode = EXCLUSIVE");
    // One after the other: a statement that is not over holds the file.
    const std::string alone = database.execAndGet("PRAGMA journal_mode = DELETE").getString();
    const std::string logged = database.execAndGet("PRAGMA journal_mode = WAL").getString();
    if (alone != "delete" || logged != "wal")
        return fail(path.string(), "the database is in use by another program",
                    "Close the program that has it open (another deixis, an SQLite browser), then try "
                    "again: nothing has been erased");
    return {};
}

void erase(SQLite::Database& database, const std::string& participant, double utc_s) {
    database.exec("BEGIN IMMEDIATE");
    SQLite::Statement count(
        database,
        "INSERT INTO withdrawals (utc_s, token, cleared) SELECT ?, token, 0 FROM participants WHERE id = ?");
    count.bind(1, utc_s);
    count.bind(2, participant);
    count.exec();
    // What refers to something goes before it.
    for (auto table = participant_tables.rbegin(); table != participant_tables.rend(); ++table) {
        SQLite::Statement statement(
            database, fmt::format("DELETE FROM {} WHERE {}", table->name, table->participant_rows));
        statement.bind(1, participant);
        statement.exec();
    }
    database.exec("COMMIT");
}

void emptyLog(SQLite::Database& database) {
    // The first column says whether something stood in the way.
    if (database.execAndGet("PRAGMA main.wal_checkpoint(TRUNCATE)").getInt() != 0)
        throw SQLite::Exception("the log cannot be emptied", SQLITE_BUSY);
}

/// Nothing but rows that count is left in the file, nothing in its log, and no file of the person beside it.
void clear(SQLite::Database& database, const fs::path& path, const std::string& participant) {
    emptyLog(database);
    database.exec("VACUUM");
    emptyLog(database);
    std::error_code gone;
    for (const fs::path& file : {workFile(path, participant), lockFile(path, participant)})
        fs::remove(file, gone);
    syncFolder(lockFile(path, participant).parent_path());
    // The log of this, which names nobody, is emptied as the file is closed.
    database.exec("UPDATE withdrawals SET cleared = 1 WHERE cleared = 0");
}

Error notCleared(const fs::path& path, const Error& why) {
    return {path.string(),
            fmt::format("every row of the person is erased, but free pages of the file still have traces: {}",
                        why.message),
            "Fix that, then run the same command again: it continues where it stopped"};
}

/// Asks as the next program to write would, with journal, log and locks.
Result<void> verify(const fs::path& path, const std::string& participant) {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, busy_timeout_ms);
    if (!known(database, participant) && !isUncleared(database)) return {};
    return fail(path.string(), fmt::format("participant {} is still there", participant),
                "Run the same command again while no other program uses the file");
}

}  // namespace

Result<Withdrawn> withdrawParticipant(const fs::path& path, const std::string& participant, double utc_s) {
    try {
        auto database = openToWrite(path, Missing::reject);
        if (!database) return tl::unexpected(database.error());
        const bool there = known(*database, participant);
        if (!there && !isUncleared(*database))
            return fail(path.string(), fmt::format("there is no participant {}", participant),
                        "'deixis participants list' lists the participants");
        {
            // Kept to the end: nobody may begin a session in between.
            const auto lock = ParticipantLock::take(path, participant);
            if (!lock) return tl::unexpected(lock.error());
            if (auto alone = takeAlone(*database, path); !alone) return tl::unexpected(alone.error());
            if (there) erase(*database, participant, utc_s);
            try {
                clear(*database, path, participant);
            } catch (const SQLite::Exception& problem) {
                return tl::unexpected(notCleared(path, describe(path, problem)));
            }
            database = SQLite::Database(":memory:");  // closes the file
        }
        if (auto done = verify(path, participant); !done) return tl::unexpected(done.error());
        return there ? Withdrawn::erased : Withdrawn::finished;
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(path, problem));
    }
}

}  // namespace deixis::results
