// deixis push: a station's database to a PostgreSQL server.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/program/command_help.hpp"
#include "app/program/progress_line.hpp"
#include "core/server_address.hpp"
#include "results/server/server.hpp"

namespace deixis::app {

namespace {

struct PushRequest {
    std::string database;
    std::string server;
};

std::string idList(const std::vector<std::string>& ids) {
    return fmt::format("{}", fmt::join(ids, ", "));
}

Result<void> push(const PushRequest& request) {
    auto working = std::make_optional<ElapsedOnTerminal>("pushing");
    const auto pushed = results::pushDatabase(request.database, request.server);
    working.reset();
    if (!pushed) return tl::unexpected(pushed.error());
    const results::PushOutcome& told = *pushed;
    if (told.upgraded_from)
        fmt::print(
            "upgraded: the server's tables of the study, which were of version {}; an older deixis can no "
            "longer use them\n",
            *told.upgraded_from);
    if (told.rows == 0 && told.changed == 0 && told.erased.empty())
        fmt::print("nothing new: the server has all of {}\n", request.database);
    else
        fmt::print("pushed: {} participants, {} sessions and {} responses new ({} rows), {} rows changed\n",
                   told.participants, told.sessions, told.responses, told.rows, told.changed);
    if (!told.erased.empty()) fmt::print("erased because withdrawn: {}\n", idList(told.erased));
    if (!told.withdrawn.empty())
        fmt::print("not pushed because withdrawn after they took part: {}\n", idList(told.withdrawn));
    if (!told.older.empty())
        fmt::print("left unchanged because the server has more of them than this file: {}\n",
                   idList(told.older));
    fmt::print("study: {}, in schema {} of {}\n", told.study, told.schema, withoutPasswords(request.server));
    return {};
}

}  // namespace

void addPushCommand(Parser cli, Command& chosen) {
    auto request = std::make_shared<PushRequest>();
    Parser command = cli.addCommand(
        "push", "Copy a database's results to a PostgreSQL server that holds those of many stations");
    describe(command, {.writes = "to the server: the database's study, participants, sessions and answers. "
                                 "The database is only read.",
                       .example = "deixis push study.sqlite postgresql://lab@db.lab/deixis",
                       .page = "docs/server.md"});
    command.addOption("DB", request->database, "Database of a study").required();
    command
        .addOption("SERVER", request->server,
                   "postgresql://USER@HOST:PORT/DATABASE; the password from PGPASSWORD or ~/.pgpass")
        .required();
    command.callback([request, &chosen] { chosen = [request] { return push(*request); }; });
}

}  // namespace deixis::app
