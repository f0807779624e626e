#include "server_schema.hpp"

#include <fmt/core.h>

#include <optional>
#include <regex>
#include <stdexcept>

#include "core/text.hpp"
#include "results/database/migration_5.hpp"
#include "results/database/schema.hpp"
#include "results/database/views.hpp"

namespace deixis::results {

namespace {

/// SQLite's way to write the moment of an answer in the view, to the nearest millisecond, and PostgreSQL's.
constexpr const char* sqlite_moment = "strftime('%Y-%m-%dT%H:%M:%fZ', r.answered_utc_s, 'unixepoch')";
constexpr const char* postgres_moment =
    "to_char(to_timestamp(round(r.answered_utc_s::numeric, 3)) AT TIME ZONE 'UTC', "
    "'YYYY-MM-DD\"T\"HH24:MI:SS.MS\"Z\"')";

/// A table of the schema, by which it is known to be ours.
constexpr const char* version_table = "deixis_schema";

std::string inPostgresWords(std::string sql) {
    for (const auto& [from, to] : {std::pair{R"(\) STRICT(, WITHOUT ROWID)?;)", ");"},
                                   {R"(\bINTEGER\b)", "BIGINT"},
                                   {R"(\bREAL\b)", "DOUBLE PRECISION"},
                                   {R"(\bBLOB\b)", "BYTEA"}})
        sql = std::regex_replace(sql, std::regex(from), to);
    return sql;
}

/// Servers came with version 4, and with tables of version 3 before it.
constexpr long long oldest_version = 3;

void giveTokens(ServerTransaction& server) {
    const pqxx::result rows = server.run(before_tokens_sql);
    const auto number = [&](int row, int column) -> std::optional<double> {
        const auto text = textOf(rows, row, column);
        return text ? std::optional(numberIn<double>(*text)) : std::nullopt;
    };
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const std::string participant = textOf(rows, i, 0).value();
        if (const auto token = tokenFrom({participant, number(i, 1), number(i, 2), number(i, 3)}))
            server.run(fmt::format("UPDATE participants SET token = {} WHERE id = {}", server.quoted(*token),
                                   server.quoted(participant)));
    }
}

/// From the version before to `version`, as migrate() does it with a file.
void step(ServerTransaction& server, long long version) {
    switch (version) {
        case 4:
            server.run(inPostgresWords(step_4));
            return;
        case 5:
            server.run(inPostgresWords(step_5));
            giveTokens(server);
            return;
        case 6:
            server.run(inPostgresWords(step_6));
            for (const char* column : {"distractors", "balls", "target_place"})
                server.run(fmt::format("ALTER TABLE trials DROP COLUMN {}", column));
            return;
        default:
            throw std::logic_error(fmt::format("no step leads to version {} of a server's tables", version));
    }
}

Result<long long> versionOf(ServerTransaction& server, const ServerAddress& address,
                            const std::string& schema) {
    const auto found = server.value(fmt::format("SELECT version FROM {}.{}", schema, version_table));
    if (!found)
        return fail(address.shown, fmt::format("the schema {} does not say its version", schema),
                    "Rename it (ALTER SCHEMA ... RENAME TO ...) and push the stations' files again");
    const long long version = std::stoll(*found);
    if (version > schema_version)
        return fail(address.shown,
                    fmt::format("the schema {} has version {}, this program's is {}", schema, version,
                                schema_version),
                    "Use the newer deixis that made it");
    return version;
}

/// Step by step to this program's version; needs the schema as search path.
Result<void> upgrade(ServerTransaction& server, const ServerAddress& address, const std::string& schema,
                     long long from) {
    if (from < oldest_version)
        return fail(
            address.shown,
            fmt::format("the schema {} has version {}, which cannot be upgraded to this program's, {}",
                        schema, from, schema_version),
            "Rename it (ALTER SCHEMA ... RENAME TO ...) and push the stations' files again");
    server.run(dropViews());
    for (long long version = from + 1; version <= schema_version; ++version) step(server, version);
    server.run(postgresViews());
    server.run(fmt::format("UPDATE {} SET version = {}", version_table, schema_version));
    return {};
}

void seeSchema(ServerTransaction& server, const std::string& schema) {
    server.run(fmt::format("SET LOCAL search_path = {}", schema));
}

}  // namespace

std::string postgresTables() {
    return inPostgresWords(newest_tables);
}

std::string postgresViews() {
    std::string sql = createViews();
    const auto at = sql.find(sqlite_moment);
    if (at == std::string::npos)
        throw std::logic_error("postgresViews: the view writes moments in another way");
    return sql.replace(at, std::string(sqlite_moment).size(), postgres_moment);
}

std::string schemaOf(const std::string& study, const std::string& hash) {
    constexpr std::size_t max = 40;  // with the rest at most 63 bytes, PostgreSQL's limit
    std::string out = "deixis_";
    for (const char c : lowerCase(study.substr(0, max)))
        out += isDigit(c) || (c >= 'a' && c <= 'z') ? c : '_';
    return out + "_" + hash.substr(0, 12);
}

Result<SchemaEntry> enterSchema(ServerTransaction& server, const ServerAddress& address,
                                const ServerStudy& study) {
    const bool there =
        server
            .value(fmt::format("SELECT 1 FROM pg_namespace WHERE nspname = {}", server.quoted(study.schema)))
            .has_value();
    if (!there) {
        server.run(fmt::format("CREATE SCHEMA {}", study.schema));
        seeSchema(server, study.schema);
        server.run(postgresTables());
        server.run(postgresViews());
        server.run(fmt::format("CREATE TABLE {0} (version BIGINT NOT NULL); INSERT INTO {0} VALUES ({1})",
                               version_table, schema_version));
        return SchemaEntry{true, {}};
    }
    const bool ours =
        server.value(fmt::format("SELECT to_regclass({})", server.quoted(study.schema + "." + version_table)))
            .has_value();
    if (!ours)
        return fail(address.shown,
                    fmt::format("the schema {} is there, but was not made by deixis", study.schema),
                    "Rename it, or push to another database");
    const auto version = versionOf(server, address, study.schema);
    if (!version) return tl::unexpected(version.error());
    seeSchema(server, study.schema);
    const auto hash = server.value("SELECT hash FROM study");
    if (hash != study.hash)
        return fail(
            address.shown,
            fmt::format("the schema {} has another study ({:.12})", study.schema, hash.value_or("none")),
            "Rename it, or push to another database");
    if (*version == schema_version) return SchemaEntry{};
    if (auto done = upgrade(server, address, study.schema, *version); !done)
        return tl::unexpected(done.error());
    return SchemaEntry{false, *version};
}

Result<void> useSchema(ServerTransaction& server, const ServerAddress& address, const std::string& schema) {
    const auto version = versionOf(server, address, schema);
    if (!version) return tl::unexpected(version.error());
    if (*version != schema_version)
        return fail(address.shown,
                    fmt::format("the schema {} has version {}, this program's is {}", schema, *version,
                                schema_version),
                    "Push a station's file with this program: that upgrades the tables");
    seeSchema(server, schema);
    return {};
}

std::vector<ServerStudy> serverStudies(ServerTransaction& server) {
    const pqxx::result schemas = server.run(
        fmt::format("SELECT n.nspname FROM pg_namespace AS n JOIN pg_class AS c ON c.relnamespace = n.oid "
                    "WHERE c.relname = "
                    "'{}' AND n.nspname LIKE 'deixis\\_%' AND has_schema_privilege(n.oid, 'USAGE') AND "
                    "has_table_privilege(c.oid, 'SELECT') ORDER BY 1",
                    version_table));
    std::vector<ServerStudy> out;
    for (int i = 0; i < static_cast<int>(schemas.size()); ++i) {
        const std::string schema = textOf(schemas, i, 0).value();
        const pqxx::result study = server.run(fmt::format("SELECT name, hash FROM {}.study", schema));
        if (!study.empty()) out.push_back({schema, textOf(study, 0, 0).value(), textOf(study, 0, 1).value()});
    }
    return out;
}

std::vector<TableColumn> columnsOf(SQLite::Database& database, const std::string& table) {
    SQLite::Statement info(database, "SELECT name, type FROM pragma_table_info(?) ORDER BY cid");
    info.bind(1, table);
    std::vector<TableColumn> out;
    while (info.executeStep()) out.push_back({info.getColumn(0).getString(), info.getColumn(1).getString()});
    return out;
}

}  // namespace deixis::results
