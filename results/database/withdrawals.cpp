#include "results/database/withdrawals.hpp"

#include <algorithm>

namespace deixis::results {

bool Withdrawals::add(const Withdrawal& one) {
    const bool known = std::any_of(all_.begin(), all_.end(), [&](const Withdrawal& other) {
        return other.token == one.token && (one.token || other.utc_s == one.utc_s);
    });
    if (!known) all_.push_back(one);
    return !known;
}

std::vector<Withdrawal> Withdrawals::addFrom(SQLite::Database& database) {
    std::vector<Withdrawal> out;
    SQLite::Statement rows(database, "SELECT utc_s, token FROM withdrawals ORDER BY id");
    while (rows.executeStep()) {
        Withdrawal one{rows.getColumn(0).getDouble()};
        if (!rows.getColumn(1).isNull()) one.token = rows.getColumn(1).getString();
        if (add(one)) out.push_back(one);
    }
    return out;
}

bool Withdrawals::include(const std::optional<std::string>& participant_token) const {
    return participant_token && std::any_of(all_.begin(), all_.end(), [&](const Withdrawal& one) {
               return one.token == participant_token;
           });
}

}  // namespace deixis::results
