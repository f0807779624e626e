#include "participants_change.hpp"

#include <fmt/core.h>

#include "results/database/database_open.hpp"

namespace deixis::results {

tl::unexpected<Error> noParticipant(const std::filesystem::path& database, const std::string& participant) {
    return fail(database.string(), fmt::format("there is no participant {}", participant),
                "'deixis participants list' lists the participants");
}

Result<void> changeParticipant(const std::filesystem::path& path, const std::string& participant,
                               const std::function<void(SQLite::Database&)>& change) {
    try {
        auto database = openToWrite(path, Missing::reject);
        if (!database) return tl::unexpected(database.error());
        SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
        SQLite::Statement known(*database, "SELECT 1 FROM participants WHERE id = ?");
        known.bind(1, participant);
        if (!known.executeStep()) return noParticipant(path, participant);
        change(*database);
        transaction.commit();
        return {};
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(path, problem));
    }
}

void setStatus(SQLite::Database& database, const std::string& participant, ParticipantStatus status,
               const std::optional<std::string>& reason) {
    SQLite::Statement update(database, "UPDATE participants SET status = ?, reason = ? WHERE id = ?");
    update.bind(1, std::string(participantStatusName(status)));
    if (reason) update.bind(2, *reason);
    update.bind(3, participant);
    update.exec();
}

}  // namespace deixis::results
