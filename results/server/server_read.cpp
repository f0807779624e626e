// A study on a server is read as a database in memory, made by the same statements as the files are: a report
// of it is then a report like any other.
#include <fmt/core.h>

#include "results/answers/response_reading.hpp"
#include "results/database/database_open.hpp"
#include "results/database/schema.hpp"
#include "results/database/tables.hpp"
#include "results/database/views.hpp"
#include "results/server/server.hpp"
#include "server_schema.hpp"

namespace deixis::results {

namespace {

Result<ServerStudy> chooseStudy(const std::vector<ServerStudy>& studies, const std::string& wanted,
                                const ServerAddress& address) {
    std::vector<const ServerStudy*> fit;
    std::string all;
    for (const ServerStudy& study : studies) {
        if (wanted.empty() || study.name == wanted || study.hash.starts_with(wanted)) fit.push_back(&study);
        all += fmt::format("{}{} ({:.12})", all.empty() ? "" : ", ", study.name, study.hash);
    }
    if (fit.size() == 1) return *fit.front();
    if (studies.empty())
        return fail(address.shown, "there is no study yet that this user can read", "'deixis push' adds one");
    if (fit.empty())
        return fail(address.shown, fmt::format("there is no study '{}', only {}", wanted, all),
                    "Name one of them with --study");
    return fail(address.shown,
                wanted.empty() ? fmt::format("several studies are there: {}", all)
                               : fmt::format("several studies fit '{}'; there are {}", wanted, all),
                "Name one with --study, by its name or the beginning of its hash");
}

void bindAs(SQLite::Statement& to, int place, const std::optional<std::string>& text,
            const std::string& type) {
    if (!text)
        to.bind(place);
    else if (type == "INTEGER")
        to.bind(place, numberIn<std::int64_t>(*text));
    else if (type == "REAL")
        to.bind(place, numberIn<double>(*text));
    else
        to.bind(place, *text);
}

void fetchTable(ServerTransaction& server, SQLite::Database& database, const std::string& table) {
    const std::vector<TableColumn> columns = columnsOf(database, table);
    std::string names, places;
    for (const TableColumn& column : columns) {
        if (column.type == "BLOB") return;  // tracked frames: no report reads them
        names += (names.empty() ? "" : ", ") + column.name;
        places += places.empty() ? "?" : ", ?";
    }
    const pqxx::result rows = server.run(fmt::format("SELECT {} FROM {} ORDER BY 1", names, table));
    SQLite::Statement insert(database, fmt::format("INSERT INTO {} ({}) VALUES ({})", table, names, places));
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        for (int c = 0; c < static_cast<int>(columns.size()); ++c)
            bindAs(insert, c + 1, textOf(rows, i, c), columns[static_cast<std::size_t>(c)].type);
        insert.exec();
        insert.reset();
    }
}

SQLite::Database fetchStudy(ServerTransaction& server) {
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec("PRAGMA foreign_keys = OFF");
    database.exec(newest_tables);
    database.exec(createViews());
    database.exec("BEGIN");
    for (const char* table : study_tables) fetchTable(server, database, table);
    fetchTable(server, database, "withdrawals");
    fetchTable(server, database, "locked_changes");
    for (const ParticipantTable& table : participant_tables) fetchTable(server, database, table.name);
    database.exec("COMMIT");
    return database;
}

}  // namespace

Result<ResponseTable> loadServerResponses(const std::string& address, const std::string& study) {
    const auto place = parseServerAddress(address);
    if (!place) return tl::unexpected(place.error());
    return atServer(*place, [&]() -> Result<ResponseTable> {
        auto server = ServerTransaction::begin(*place, ServerTransaction::Purpose::read);
        if (!server) return tl::unexpected(server.error());
        const auto chosen = chooseStudy(serverStudies(*server), study, *place);
        if (!chosen) return tl::unexpected(chosen.error());
        if (auto used = useSchema(*server, *place, chosen->schema); !used)
            return tl::unexpected(used.error());
        try {
            SQLite::Database database = fetchStudy(*server);
            auto table = readResponses(database, place->shown);
            if (table) table->database = place->shown;
            return table;
        } catch (const SQLite::Exception& problem) {
            return tl::unexpected(describe(place->shown, problem));
        }
    });
}

}  // namespace deixis::results
