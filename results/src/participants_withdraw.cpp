// Erasing a person: every row, then every trace that the rows leave in the file and its log.
#include <fmt/core.h>
#include <sqlite3.h>

#include "database_open.hpp"
#include "participant_lock.hpp"
#include "results/participants.hpp"
#include "results/store.hpp"
#include "tables.hpp"

namespace deixis::results {

namespace {

bool known(SQLite::Database& database, const std::string& participant) {
    SQLite::Statement row(database, "SELECT 1 FROM participants WHERE id = ?");
    row.bind(1, participant);
    return row.executeStep();
}

void erase(SQLite::Database& database, const std::string& participant, double utc_s) {
    database.exec("BEGIN IMMEDIATE");
    SQLite::Statement count(
        database, "INSERT INTO withdrawals (utc_s, token) SELECT ?, token FROM participants WHERE id = ?");
    count.bind(1, utc_s);
    count.bind(2, participant);
    count.exec();
    // What refers to something goes before it.
    for (auto table = people_tables.rbegin(); table != people_tables.rend(); ++table) {
        SQLite::Statement statement(
            database, fmt::format("DELETE FROM {} WHERE {}", table->name, table->participant_rows));
        statement.bind(1, participant);
        statement.exec();
    }
    database.exec("COMMIT");
}

}  // namespace

Result<void> withdrawParticipant(const std::filesystem::path& database, const std::string& participant,
                                 double utc_s) {
    try {
        auto open = openToWrite(database, Missing::refuse);
        if (!open) return tl::unexpected(open.error());
        if (!known(*open, participant))
            return fail(database.string(), fmt::format("there is no participant {}", participant),
                        "'deixis participants list' tells who there is");
        // Kept to the end: nobody may begin a session in between.
        const auto lock = ParticipantLock::take(database, participant);
        if (!lock) return tl::unexpected(lock.error());
        // With another program reading, the log could not be emptied: nobody else may have the file open. The
        // first read under this mode takes it; out of WAL the journal leaves no log behind at all.
        open->exec("PRAGMA secure_delete = ON; PRAGMA main.wal_checkpoint(TRUNCATE)");
        if (open->execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete")
            return fail(database.string(), "the database is in use by another program",
                        "Close the program that has it open (another deixis, an SQLite browser), then try "
                        "again: nothing has been erased");
        erase(*open, participant, utc_s);
        open->exec("VACUUM");
        open->exec("PRAGMA journal_mode = WAL; PRAGMA main.wal_checkpoint(TRUNCATE)");
        std::error_code gone;
        std::filesystem::remove(lockFile(database, participant), gone);
        return {};
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(database, problem));
    }
}

}  // namespace deixis::results
