// Rows of a file brought to a server, and those that are there already compared.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/database/tables.hpp"
#include "results/server/server.hpp"
#include "server_schema.hpp"

namespace deixis::results {

/// The condition by which a table's rows are a participant's, who is given as an SQL literal.
[[nodiscard]] std::string rowsOf(const ParticipantTable& table, const std::string& participant);

class ParticipantPush {
  public:
    ParticipantPush(SQLite::Database& file, const std::filesystem::path& path, ServerTransaction& server,
                    const ServerAddress& address, PushOutcome& outcome)
        : file_(file), path_(path), server_(server), address_(address), outcome_(outcome) {}

    /// All rows, as they are.
    void pushWhole(const std::string& table);

    /// What is new and what has changed of one participant; adds to the outcome. Errors: what differs.
    Result<void> push(const std::string& participant);

  private:
    using Cell = std::optional<std::string>;

    /// Sessions and responses are counted by each database; within a participant they are the first, second,
    /// ...
    struct Counted {
        std::map<std::int64_t, int> place_in_file;    ///< by the file's id; places count from 1
        std::map<std::int64_t, int> place_on_server;  ///< by the server's id
        std::map<int, std::int64_t> server_id;        ///< by place
    };
    struct PushedRows {
        long long added = 0;
        long long changed = 0;
        bool older = false;  ///< the server has rows that the file lacks
    };
    struct Known {
        std::vector<Cell> cells;
        std::int64_t server_id = 0;  ///< where the table counts its rows
    };

    Result<PushedRows> pushTable(const ParticipantTable& table, const std::string& participant);
    std::map<std::string, Known> fetch(const ParticipantTable& table, const std::vector<TableColumn>& columns,
                                       const std::string& participant);
    Result<PushedRows> compare(const ParticipantTable& table, const std::vector<TableColumn>& columns,
                               const std::string& participant, std::map<std::string, Known> there,
                               std::vector<bool>& is_new);
    void insertNew(const ParticipantTable& table, const std::vector<TableColumn>& columns,
                   const std::string& participant, const std::vector<bool>& is_new);
    void flush(const std::string& into, std::string& values, std::size_t enough);
    std::string literal(const SQLite::Column& value);
    /// With the server's number where the column refers to a session or response.
    std::string literalOnServer(const ParticipantTable& table, const TableColumn& column,
                                const SQLite::Column& value);
    std::int64_t nextId(const std::string& table);

    SQLite::Database& file_;
    const std::filesystem::path& path_;
    ServerTransaction& server_;
    const ServerAddress& address_;
    PushOutcome& outcome_;
    std::map<std::string, Counted> counted_;       ///< of the participant under way, by table
    std::map<std::string, std::int64_t> next_id_;  ///< by table
};

}  // namespace deixis::results
