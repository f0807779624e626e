// Erasing a person: every row, then every trace that the rows leave in the file and its log.
#include <fmt/core.h>
#include <sqlite3.h>

#include <array>

#include "database_open.hpp"
#include "participant_lock.hpp"
#include "results/participants.hpp"
#include "results/store.hpp"

namespace deixis::results {

namespace {

// What refers to something comes before it.
constexpr std::array erasures{
    "DELETE FROM answers WHERE response IN (SELECT id FROM responses WHERE participant = ?)",
    "DELETE FROM response_stimuli WHERE response IN (SELECT id FROM responses WHERE participant = ?)",
    "DELETE FROM responses WHERE participant = ?",
    "DELETE FROM events WHERE session IN (SELECT id FROM sessions WHERE participant = ?)",
    "DELETE FROM tracking_blocks WHERE session IN (SELECT id FROM sessions WHERE participant = ?)",
    "DELETE FROM hand_joints WHERE session IN (SELECT id FROM sessions WHERE participant = ?)",
    "DELETE FROM trial_tracking WHERE session IN (SELECT id FROM sessions WHERE participant = ?)",
    "DELETE FROM consents WHERE participant = ?",
    "DELETE FROM session_properties WHERE session IN (SELECT id FROM sessions WHERE participant = ?)",
    "DELETE FROM sessions WHERE participant = ?",
    "DELETE FROM trial_stimuli WHERE participant = ?",
    "DELETE FROM trials WHERE participant = ?",
    "DELETE FROM plans WHERE participant = ?",
    "DELETE FROM participant_fields WHERE participant = ?",
    "DELETE FROM participant_groups WHERE participant = ?",
    "DELETE FROM participants WHERE id = ?",
};

bool known(SQLite::Database& database, const std::string& participant) {
    SQLite::Statement row(database, "SELECT 1 FROM participants WHERE id = ?");
    row.bind(1, participant);
    return row.executeStep();
}

void erase(SQLite::Database& database, const std::string& participant, double utc_s) {
    database.exec("BEGIN IMMEDIATE");
    for (const char* sql : erasures) {
        SQLite::Statement statement(database, sql);
        statement.bind(1, participant);
        statement.exec();
    }
    SQLite::Statement count(database, "INSERT INTO withdrawals (utc_s) VALUES (?)");
    count.bind(1, utc_s);
    count.exec();
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
        open->exec("PRAGMA secure_delete = ON; PRAGMA wal_checkpoint(TRUNCATE)");
        if (open->execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete")
            return fail(database.string(), "the database is in use by another program",
                        "Close the program that has it open (another deixis, an SQLite browser), then try "
                        "again: nothing has been erased");
        erase(*open, participant, utc_s);
        open->exec("VACUUM");
        open->exec("PRAGMA journal_mode = WAL; PRAGMA wal_checkpoint(TRUNCATE)");
        std::error_code gone;
        std::filesystem::remove(lockFile(database, participant), gone);
        return {};
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(database, problem));
    }
}

}  // namespace deixis::results
