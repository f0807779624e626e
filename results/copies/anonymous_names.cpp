#include "anonymous_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/hash.hpp"

namespace deixis::results {

namespace {

/// A letter with which no id begins, before a digit: nobody gets another one's id.
char freeLetter(const std::vector<std::string>& ids) {
    const auto taken = [&](char letter) {
        return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) {
            return id.size() > 1 && (id[0] == letter || id[0] == letter - 'A' + 'a') && id[1] >= '0' &&
                   id[1] <= '9';
        });
    };
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (!taken(letter)) return letter;
    return 'A';
}

}  // namespace

std::vector<std::string> AnonymousNames::shuffled(std::vector<std::string> names) const {
    std::map<std::string, std::string> keys;
    for (const std::string& name : names) keys[name] = sha256Hex(secret_ + name);
    std::sort(names.begin(), names.end(),
              [&](const std::string& a, const std::string& b) { return keys[a] < keys[b]; });
    return names;
}

std::map<std::string, std::string> AnonymousNames::namesFor(const std::vector<std::string>& all,
                                                            const std::string& word) const {
    std::map<std::string, std::string> out;
    for (const std::string& name : shuffled(all))
        out.emplace(name, fmt::format("{} {}", word, out.size() + 1));
    return out;
}

AnonymousNames::AnonymousNames(SQLite::Database& database, bool anonymise) {
    SQLite::Statement everybody(
        database, "SELECT id, registered_utc_s, coalesce(token, '') FROM participants ORDER BY id");
    while (everybody.executeStep()) {
        participants_.push_back(everybody.getColumn(0).getString());
        secret_ +=
            fmt::format("{} {} ", everybody.getColumn(1).getDouble(), everybody.getColumn(2).getString());
    }
    const char letter = freeLetter(participants_);
    if (anonymise) participants_ = shuffled(std::move(participants_));
    long long next_session = 1;
    for (std::size_t i = 0; i < participants_.size(); ++i) {
        names_[participants_[i]] = anonymise ? fmt::format("{}{:03}", letter, i + 1) : participants_[i];
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
