// Many stations' results in one place: a PostgreSQL database, which holds any number of studies side by
// side, each in its own schema (namespace) with the tables of docs/database.md. User's guide:
// docs/server.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/answers/response_table.hpp"

namespace deixis::results {

struct PushOutcome {
    std::string study;                         ///< its name
    std::string schema;                        ///< the schema that holds it on the server
    std::optional<long long> upgraded_from{};  ///< the version of the schema before, where it was older
    long long participants = 0;                ///< new on the server; so are the next three
    long long sessions = 0;
    long long responses = 0;
    long long rows = 0;               ///< of all tables, those of the three included
    long long changed = 0;            ///< rows that were there and changed: exclusions, ends of sessions, ...
    std::vector<std::string> erased;  ///< withdrawn since, in this file or another
    std::vector<std::string>
        withdrawn;  ///< of the file, but not pushed: they were withdrawn after they took part
    std::vector<std::string> older;  ///< left as they are: the server holds more of them than the file does
};

/// Brings what the database holds, and the server does not yet, to the server, in one transaction. Rows that
/// are there are compared: answers and plans must be equal; what may change (status, fields, ends of
/// sessions, answers superseded) is updated. `address` is a libpq URL; what it leaves out come
/// from PGHOST, PGUSER, PGPASSWORD, ... or ~/.pgpass. Pushes wait for each other. Errors: of the file, as of
/// a report; server not reached, user or password rejected, no such database; the study's schema is another
/// program's or of a newer version, while an older one is updated first; a row differs; an id or
/// number is another person's there.
[[nodiscard]] Result<PushOutcome> pushDatabase(const std::filesystem::path& database,
                                               const std::string& address);

/// As loadResponses(), of one study on the server. `study` is its name or the beginning of its hash, and may
/// be empty if there is only one. Errors: as of a push; no study, or several.
[[nodiscard]] Result<ResponseTable> loadServerResponses(const std::string& address, const std::string& study);

}  // namespace deixis::results
