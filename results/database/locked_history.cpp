#include "results/database/locked_history.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace deixis::results {

std::optional<std::string> lockedBefore(const std::string& what) {
    const auto change = nlohmann::json::parse(what, nullptr, false);
    if (!change.is_object() || !change.contains("from") || !change["from"].is_string()) return std::nullopt;
    return change["from"].get<std::string>();
}

LockedHistory readLockedHistory(SQLite::Database& database) {
    LockedHistory out;
    SQLite::Statement study(database, "SELECT coalesce(locked_hash, '') FROM study");
    if (study.executeStep()) out.in_force = study.getColumn(0).getString();
    if (!out.in_force.empty()) out.had.insert(out.in_force);
    SQLite::Statement changes(database, "SELECT what FROM locked_changes");
    while (changes.executeStep())
        if (auto before = lockedBefore(changes.getColumn(0).getString())) out.had.insert(std::move(*before));
    return out;
}

std::vector<std::string> changeNotes(SQLite::Database& database) {
    std::vector<std::string> out;
    SQLite::Statement rows(database,
                           "SELECT what, coalesce(reason, '') FROM locked_changes ORDER BY utc_s, id");
    while (rows.executeStep()) {
        const auto what = nlohmann::json::parse(rows.getColumn(0).getString(), nullptr, false);
        std::string changes;
        if (what.is_object() && what.contains("changes") && what["changes"].is_array())
            for (const auto& change : what["changes"])
                if (change.is_string()) changes += (changes.empty() ? "" : "; ") + change.get<std::string>();
        int before = 0;
        if (const auto from = lockedBefore(rows.getColumn(0).getString())) {
            SQLite::Statement plans(database, "SELECT count(*) FROM plans WHERE locked_hash = ?");
            plans.bind(1, *from);
            if (plans.executeStep()) before = plans.getColumn(0).getInt();
        }
        out.push_back(fmt::format(
            "The study was changed while it was running ({}): {}. {} participant{} seen it as it was before.",
            rows.getColumn(1).getString(), changes, before, before == 1 ? " has" : "s have"));
    }
    return out;
}

}  // namespace deixis::results
