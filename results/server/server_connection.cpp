#include "server_connection.hpp"

#include <fmt/core.h>

#include <libpq-fe.h>

#include <cstdlib>

#include "core/server_address.hpp"

namespace deixis::results {

namespace {

// Pushes wait for each other. A station that falls asleep in one must not hold up the others for long.
constexpr const char* server_settings =
    "SET client_encoding = 'UTF8'; SET standard_conforming_strings = on; SET bytea_output = hex; "
    "SET extra_float_digits = 3; SET client_min_messages = error; SET lock_timeout = '120s'; "
    "SET idle_in_transaction_session_timeout = '120s'";

std::string withOptions(const std::string& url) {
    const bool timed =
        url.find("connect_timeout=") != std::string::npos || std::getenv("PGCONNECT_TIMEOUT") != nullptr;
    return url + (url.find('?') == std::string::npos ? "?" : "&") + "fallback_application_name=deixis" +
           (timed ? "" : "&connect_timeout=30");
}

/// Without addresses' passwords, on one line.
std::string onOneLine(const std::string& message) {
    std::string out;
    for (const char c : withoutPasswords(message)) {
        const char shown = c == '\n' || c == '\t' ? ' ' : c;
        if (shown != ' ' || (!out.empty() && out.back() != ' ')) out += shown;
    }
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

bool says(const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
}

Error notConnected(const ServerAddress& address, const std::string& message) {
    const std::string text = onOneLine(message);
    const auto fatal = text.rfind("FATAL: ");
    const std::string reason = fatal == std::string::npos ? text : text.substr(fatal + 7);
    if (says(text, "authentication failed") || says(text, "no password supplied"))
        return {address.shown, fmt::format("the server does not let this user in ({})", reason),
                "Set PGUSER and PGPASSWORD, or use ~/.pgpass"};
    if (says(text, "database \"") && says(text, "does not exist"))
        return {address.shown, fmt::format("the server says: {}", reason), "Make it there with createdb"};
    if (fatal != std::string::npos)
        return {address.shown, fmt::format("the server says: {}", reason), "Ask the server's administrator"};
    return {address.shown, fmt::format("no server was reached ({})", reason),
            "Check the address, and that the server is running and reachable from here"};
}

Error rejected(const ServerAddress& address, const pqxx::sql_error& problem) {
    const std::string text = problem.what();
    const std::string line = onOneLine(text.substr(0, text.find('\n')));
    // libpqxx 6 tells the SQLSTATE only of errors that have no class of their own.
    if (dynamic_cast<const pqxx::insufficient_privilege*>(&problem) != nullptr)
        return {address.shown, fmt::format("the user may not do this there ({})", line),
                "The first push needs CREATE on the database; let all stations use one role"};
    if (problem.sqlstate() == std::string("55P03"))
        return {address.shown, "another push, or another program, has held the tables for two minutes",
                "Try again later: nothing of this push is stored, and running it again is safe"};
    return {address.shown, fmt::format("PostgreSQL reports: {}", line), ""};
}

}  // namespace

Result<ServerAddress> parseServerAddress(const std::string& address) {
    const auto wrong = [](const std::string& what) {
        return fail("postgresql://...", what,
                    "Expected postgresql://USER@HOST:PORT/DATABASE. Leave the password to PGPASSWORD or "
                    "~/.pgpass; in an "
                    "address all but its letters and digits must be percent-encoded");
    };
    if (!isServerAddress(address)) return wrong("this is not the address of a PostgreSQL server");
    if (!isPlainServerAddress(address)) return wrong("the address is ambiguous");
    // What libpq says of an address that it cannot read may hold the password: it is not repeated.
    const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> parts(
        PQconninfoParse(address.c_str(), nullptr), &PQconninfoFree);
    if (parts == nullptr) return wrong("the address cannot be read");
    return ServerAddress{address, withoutPasswords(address)};
}

ServerTransaction::ServerTransaction(std::unique_ptr<pqxx::connection> connection)
    : connection_(std::move(connection)), work_(std::make_unique<pqxx::work>(*connection_)) {}

Result<ServerTransaction> ServerTransaction::begin(const ServerAddress& address, Purpose purpose) {
    std::unique_ptr<pqxx::connection> connection;
    try {
        connection = std::make_unique<pqxx::connection>(withOptions(address.url));
    } catch (const pqxx::failure& problem) {
        return tl::unexpected(notConnected(address, problem.what()));
    }
    return atServer(address, [&]() -> Result<ServerTransaction> {
        ServerTransaction begun(std::move(connection));
        if (purpose == Purpose::read) begun.run("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY");
        begun.run(server_settings);
        return begun;
    });
}

std::optional<std::string> ServerTransaction::value(const std::string& sql) {
    const pqxx::result rows = run(sql);
    if (rows.empty()) return std::nullopt;
    return textOf(rows, 0, 0);
}

std::optional<std::string> textOf(const pqxx::result& rows, int row, int column) {
    const auto field =
        rows[static_cast<pqxx::result::size_type>(row)][static_cast<pqxx::row::size_type>(column)];
    if (field.is_null()) return std::nullopt;
    return std::string(field.c_str(), field.size());
}

Error describeServer(const ServerAddress& address, const pqxx::failure& problem) {
    if (dynamic_cast<const pqxx::in_doubt_error*>(&problem) != nullptr)
        return {address.shown,
                "the connection was lost at the very end: the push may be stored completely, or not at all",
                "Push again: it adds only what is missing"};
    if (const auto* sql = dynamic_cast<const pqxx::sql_error*>(&problem)) return rejected(address, *sql);
    if (dynamic_cast<const pqxx::broken_connection*>(&problem) != nullptr)
        return {address.shown,
                fmt::format("the connection to the server was lost ({})", onOneLine(problem.what())),
                "Try again: nothing of an interrupted push is stored"};
    return {address.shown, fmt::format("PostgreSQL reports: {}", onOneLine(problem.what())), ""};
}

}  // namespace deixis::results
