// The locked sets that a database's study has had, in order: databases of one study can be joined if one
// of them has had all the others' sets.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace deixis::results {

struct LockedHistory {
    std::string in_force;       ///< hash; empty: nothing is locked
    std::set<std::string> had;  ///< with the one in force

    /// Whether the other's set is one of these; also where the other has nothing locked.
    [[nodiscard]] bool includes(const LockedHistory& other) const {
        return other.in_force.empty() || had.contains(other.in_force);
    }
};

/// `in_force`, and what a change says of the set before it (locked_changes.what).
[[nodiscard]] LockedHistory readLockedHistory(SQLite::Database& database);
/// The hash before a change; none if it does not tell.
[[nodiscard]] std::optional<std::string> lockedBefore(const std::string& what);

/// A sentence for each accepted change, for the reader of a report.
[[nodiscard]] std::vector<std::string> changeNotes(SQLite::Database& database);

}  // namespace deixis::results
