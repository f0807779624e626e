// deixis export: a database as tidy CSV tables with a codebook. deixis merge: several databases as one.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/study/locked_set.hpp"
#include "results/copies/data_export.hpp"
#include "results/copies/merge.hpp"
#include "results/store/locked_sets.hpp"

namespace deixis::app {

namespace {

struct ExportRequest {
    std::string database;
    std::string format = "csv";
    std::string folder;
    results::ExportOptions options;
};

struct MergeRequest {
    std::vector<std::string> databases;
    std::string output;
};

Result<void> exportTables(const ExportRequest& request) {
    const std::string folder =
        request.folder.empty()
            ? std::filesystem::path(request.database).replace_extension("").string() + "-csv"
            : request.folder;
    auto working = std::make_optional<ElapsedOnTerminal>("exporting");
    const auto written = results::exportCsv(request.database, folder, request.options);
    working.reset();
    if (!written) return tl::unexpected(written.error());
    for (const std::string& file : *written)
        fmt::print("{}\n", (std::filesystem::path(folder) / file).string());
    return {};
}

Result<void> merge(const MergeRequest& request) {
    const std::vector<std::filesystem::path> databases(request.databases.begin(), request.databases.end());
    auto working = std::make_optional<ElapsedOnTerminal>("joining");
    const auto merged = results::mergeDatabases(databases, request.output);
    working.reset();
    if (!merged) {
        for (const Error& problem : merged.error()) fmt::print(stderr, "{}\n", problem.text());
        return fail(request.output, "was not written: the databases cannot be joined");
    }
    fmt::print("{} databases joined: {}\n", databases.size(), request.output);
    for (const std::string& id : merged->withdrawn) fmt::print("left out because withdrawn: {}\n", id);
    for (const std::string& id : merged->excluded_in_one)
        fmt::print("not counted because excluded or dropped out in one of the databases: {}\n", id);
    const auto sets = results::lockedSets(request.output);
    if (!sets) return tl::unexpected(sets.error());
    const auto lacking = copyLockedSets(databases, request.output, *sets);
    if (!lacking) return tl::unexpected(lacking.error());
    for (const std::string& hash : *lacking)
        fmt::print(stderr,
                   "note: the locked study {:.16} is beside none of the databases: sessions cannot continue "
                   "in the joined one until it is in {}\n",
                   hash, lockedFolder(request.output).string());
    return {};
}

}  // namespace

void addExportCommand(Parser cli, Command& chosen) {
    auto request = std::make_shared<ExportRequest>();
    Parser command = cli.addCommand("export", "Write a database's tables as CSV, with a codebook");
    describe(command, {.writes = "CSV tables, codebook.md and codebook.json to DIR (-o; default: "
                                 "DATABASE-csv beside the database). An earlier export there is replaced.",
                       .example = "deixis export study.sqlite -o tables --anonymise",
                       .page = "docs/data-out.md"});
    command.addOption("DB", request->database, "Database of a study").required();
    command.addOption("--format", request->format, "Format of the tables")
        .check(OneOf{{"csv"}})
        .showDefault();
    addOutput(command, request->folder, "Folder to write to [DB without its ending, plus -csv]", "DIR");
    command.addFlag("--anonymise", request->options.anonymise,
                    "For sharing: other ids, no free text, no notes, no dates");
    command.addFlag("!--no-tracking", request->options.tracking, "Leave tracked frames out");
    command.callback([request, &chosen] { chosen = [request] { return exportTables(*request); }; });
}

void addMergeCommand(Parser cli, Command& chosen) {
    auto request = std::make_shared<MergeRequest>();
    Parser command = cli.addCommand("merge", "Join the databases of several stations of one study");
    describe(command,
             {.writes =
                  "a new database, and beside it the locked studies. An existing database is never replaced.",
              .example = "deixis merge station1.sqlite station2.sqlite -o all.sqlite",
              .page = "docs/data-out.md"});
    command.addOption("DB", request->databases, "Databases to join, two or more").required().expected(-2);
    addOutput(command, request->output, "Database to make; must not exist").required();
    command.callback([request, &chosen] { chosen = [request] { return merge(*request); }; });
}

}  // namespace deixis::app
