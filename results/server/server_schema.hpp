// The tables of a study on a PostgreSQL server: those of the SQLite file, in a schema of their own.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <vector>

#include "server_connection.hpp"

namespace deixis::results {

/// The statements of schema.hpp in PostgreSQL's words: one study's tables, and the views on them.
[[nodiscard]] std::string postgresTables();
[[nodiscard]] std::string postgresViews();

struct ServerStudy {
    std::string schema;
    std::string name;
    std::string hash;
};

/// "deixis_", the study's name in small letters, digits and "_", and the first 12 digits of its hash.
[[nodiscard]] std::string schemaOf(const std::string& study, const std::string& hash);

struct SchemaEntry {
    bool made = false;                         ///< it was not there
    std::optional<long long> upgraded_from{};  ///< the version that it had
};

/// Makes the study's schema where it is not there, brings one of an older version up to date, and uses it.
/// Errors: a schema of that name that is not ours or another study's, a newer version, or one from which no
/// way leads here.
[[nodiscard]] Result<SchemaEntry> enterSchema(ServerTransaction& server, const ServerAddress& address,
                                              const ServerStudy& study);

/// Has the transaction see the study's tables. Errors: of another version.
[[nodiscard]] Result<void> useSchema(ServerTransaction& server, const ServerAddress& address,
                                     const std::string& schema);

/// The studies in the database that this user may read, in the order of their schemas' names.
[[nodiscard]] std::vector<ServerStudy> serverStudies(ServerTransaction& server);

struct TableColumn {
    std::string name;
    std::string type;  ///< as SQLite's: INTEGER, REAL, TEXT, BLOB
};
[[nodiscard]] std::vector<TableColumn> columnsOf(SQLite::Database& database, const std::string& table);

}  // namespace deixis::results
