#include "anonymous.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/hash.hpp"

namespace deixis::results {

Naming::Naming(SQLite::Database& database, bool anonymise) {
    std::string secret;
    std::map<std::string, std::string> keys;
    SQLite::Statement everybody(database, "SELECT id, registered_utc_s FROM participants ORDER BY id");
    while (everybody.executeStep()) {
        participants_.push_back(everybody.getColumn(0).getString());
        secret += fmt::format("{} ", everybody.getColumn(1).getDouble());
    }
    if (anonymise) {
        for (const std::string& participant : participants_)
            keys[participant] = sha256Hex(secret + participant);
        std::sort(participants_.begin(), participants_.end(),
                  [&](const std::string& a, const std::string& b) { return keys[a] < keys[b]; });
    }
    long long next_session = 1;
    for (std::size_t i = 0; i < participants_.size(); ++i) {
        names_[participants_[i]] = anonymise ? fmt::format("A{:03}", i + 1) : participants_[i];
        SQLite::Statement sessions(
            database,
            "SELECT id, coalesce((SELECT min(time_s) FROM events WHERE session = e.id), 0) "
            "FROM sessions AS e WHERE participant = ? ORDER BY id");
        sessions.bind(1, participants_[i]);
        while (sessions.executeStep()) {
            const long long id = sessions.getColumn(0).getInt64();
            sessions_[id] = {anonymise ? next_session++ : id,
                             anonymise ? sessions.getColumn(1).getDouble() : 0.0};
        }
    }
}

}  // namespace deixis::results
