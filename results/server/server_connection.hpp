// One transaction with a PostgreSQL server, and what can go wrong with it in words for a person. Only calls
// that libpqxx 6.4 (Debian 12) and 7.10 (Debian 13) both have, none of them deprecated, are used: SQL as
// text, no parameters.
#pragma once

#include <memory>
#include <optional>
#include <pqxx/pqxx>
#include <string>
#include <type_traits>

#include "core/error.hpp"

namespace deixis::results {

struct ServerAddress {
    std::string url;
    std::string shown;  ///< without the password
};
[[nodiscard]] Result<ServerAddress> parseServerAddress(const std::string& address);

/// A connection with a transaction begun; without commit() nothing of it stays. Failing calls throw pqxx's
/// exceptions.
class ServerTransaction {
  public:
    enum class Purpose : unsigned char {
        read,  ///< all of it sees one moment of the database
        write
    };
    /// Errors: no server there, user or password rejected, no such database.
    [[nodiscard]] static Result<ServerTransaction> begin(const ServerAddress& address, Purpose purpose);

    pqxx::result run(const std::string& sql) { return work_->exec(sql); }
    /// As an SQL literal.
    [[nodiscard]] std::string quoted(const std::string& text) const { return "'" + work_->esc(text) + "'"; }
    /// The first field of the first row.
    [[nodiscard]] std::optional<std::string> value(const std::string& sql);
    void commit() { work_->commit(); }

  private:
    explicit ServerTransaction(std::unique_ptr<pqxx::connection> connection);

    std::unique_ptr<pqxx::connection> connection_;
    std::unique_ptr<pqxx::work> work_;
};

/// The field's text; none where it is NULL.
[[nodiscard]] std::optional<std::string> textOf(const pqxx::result& rows, int row, int column);
/// The number that a cell's text is, NaN and infinity too.
template <typename Number>
[[nodiscard]] Number numberIn(const std::string& text) {
    Number number{};
    pqxx::from_string(text, number);
    return number;
}

/// The error that a failing call stands for.
[[nodiscard]] Error describeServer(const ServerAddress& address, const pqxx::failure& problem);

/// Calls `work` (-> Result<...>); pqxx's exceptions become errors.
template <typename Work>
[[nodiscard]] auto atServer(const ServerAddress& address, const Work& work) -> std::invoke_result_t<Work> {
    try {
        return work();
    } catch (const pqxx::failure& problem) {
        return tl::unexpected(describeServer(address, problem));
    }
}

}  // namespace deixis::results
