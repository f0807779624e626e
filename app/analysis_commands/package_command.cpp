// deixis package: a study's database as a folder that others can read, replay and analyse.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/analysis_commands/report.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/version.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/staging.hpp"
#include "package_readme.hpp"
#include "package_sets.hpp"
#include "results/copies/anonymous_copy.hpp"
#include "results/copies/data_export.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct PackageRequest {
    std::string database;
    std::string folder;
    bool free_text = false;
    bool tracking = true;
};

constexpr const char* packaged_database = "study.sqlite";

/// Another working folder until the end: what is written within names no other.
class WorkingFolder {
  public:
    WorkingFolder() : before_(fs::current_path()) {}
    ~WorkingFolder() {
        std::error_code code;
        fs::current_path(before_, code);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

    Result<void> enter(const fs::path& folder) {
        // Shipped files stay where they are looked for.
        if (const char* data = std::getenv("DEIXIS_DATA"))
            setenv("DEIXIS_DATA", fs::absolute(data).c_str(), 1);
        std::error_code code;
        fs::current_path(folder, code);
        if (code) return fail(folder.string(), "cannot be entered: " + code.message());
        return {};
    }

  private:
    fs::path before_;
};

std::vector<std::string> filesHere() {
    std::vector<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator("."))
        if (entry.is_regular_file()) out.push_back(entry.path().lexically_relative(".").generic_string());
    std::sort(out.begin(), out.end());
    return out;
}

/// SHA256SUMS. Returns notes on files that hold one of `words`, by which a lab could be told.
Result<std::vector<std::string>> writeSums(const std::vector<std::string>& words) {
    std::vector<std::string> notes;
    std::string sums;
    for (const std::string& file : filesHere()) {
        const auto bytes = readFile(file);
        if (!bytes) return tl::unexpected(bytes.error());
        sums += fmt::format("{}  {}\n", sha256Hex(*bytes), file);
        for (const std::string& word : words)
            if (bytes->find(word) != std::string::npos)
                notes.push_back(fmt::format(
                    "{} contains the text '{}': check it before you share the package", file, word));
    }
    if (auto written = writeFileUnsynced("SHA256SUMS", sums); !written)
        return tl::unexpected(written.error());
    return notes;
}

/// Folders of this machine that no file should name.
std::vector<std::string> foldersOf(const fs::path& database) {
    std::vector<std::string> out{fs::absolute(database).parent_path().string()};
    if (const char* home = std::getenv("HOME")) out.emplace_back(home);
    constexpr std::size_t telling = 5;  // not "/" nor "/tmp"
    std::erase_if(out, [](const std::string& one) { return one.size() <= telling; });
    return out;
}

/// Returns notes on it.
Result<std::vector<std::string>> writePackage(const PackageRequest& request, const fs::path& database) {
    auto working = std::make_optional<ElapsedOnTerminal>("copying");
    const auto sets = packageSets(database, packaged_database);
    if (!sets) return tl::unexpected(sets.error());
    const auto counts = results::copyAnonymously(
        database, packaged_database,
        {request.free_text, request.tracking, sets->hashes, sets->files, sets->authors});
    if (!counts) return tl::unexpected(counts.error());
    working.reset();
    if (auto written =
            writeReport({packaged_database},
                        {.page = "report.html", .json = "analysis.json", .latex = "latex", .r = "tables"});
        !written)
        return tl::unexpected(written.error());
    working.emplace("exporting");
    if (auto written = results::exportCsv(packaged_database, "data", {true, false, true}); !written)
        return tl::unexpected(written.error());
    const auto schema = readFile(assets::dataFile("schemas/analysis.schema.json"));
    if (!schema) return tl::unexpected(schema.error());
    if (auto written = writeFileUnsynced("analysis.schema.json", *schema); !written)
        return tl::unexpected(written.error());
    auto answers = results::loadResponses(packaged_database);
    if (!answers) return tl::unexpected(answers.error());
    auto people = results::listParticipants(packaged_database);
    if (!people) return tl::unexpected(people.error());
    const PackageFacts facts{std::move(*answers), std::move(*people), *counts,         request.free_text,
                             request.tracking,    counts->frames > 0, programVersion()};
    if (auto written = writeFileUnsynced("README.md", packageReadme(facts)); !written)
        return tl::unexpected(written.error());
    return writeSums(foldersOf(database));
}

Result<void> makePackage(const PackageRequest& request) {
    fs::path target = fs::path(request.folder).lexically_normal();
    if (!target.has_filename()) target = target.parent_path();  // "FOLDER/"
    std::error_code code;
    if (fs::exists(fs::symlink_status(target, code)))
        return fail(target.string(), "exists already and is not overwritten", "Name another folder with -o");
    const fs::path database = fs::absolute(request.database);
    if (!fs::is_regular_file(database, code))
        return fail(request.database, "No such file", "Name the database of a study");
    const fs::path place = fs::absolute(target);
    auto making = Staging::within(place.parent_path());
    if (!making) return tl::unexpected(making.error());
    std::vector<std::string> notes;
    {
        WorkingFolder working;
        if (auto entered = working.enter(making->path()); !entered) return entered;
        auto written = writePackage(request, database);
        if (!written) return tl::unexpected(written.error());
        notes = std::move(*written);
    }
    if (auto became = making->become(place, true); !became) return became;
    for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
    fmt::print("package: {}\n", request.folder);
    if (!request.free_text) fmt::print("What participants typed is left out; --free-text keeps it.\n");
    fmt::print("Read {}/README.md before you share it: it says what was left out, and what was not.\n",
               request.folder);
    return {};
}

}  // namespace

void addPackageCommand(Parser cli, Command& chosen) {
    auto request = std::make_shared<PackageRequest>();
    Parser command = cli.addCommand(
        "package",
        "Make a replication package: study, clips, avatar, anonymous data and report in one folder");
    describe(command, {.writes = "the folder, which must not exist; it is complete or not there at all.",
                       .example = "deixis package study.sqlite -o replication",
                       .page = "docs/data-out.md"});
    command.addOption("DB", request->database, "Database of a study").required();
    addOutput(command, request->folder, "Folder to make; must not exist", "DIR").required();
    command.addFlag("--free-text", request->free_text, "Keep what participants typed");
    command.addFlag("!--no-tracking", request->tracking, "Leave tracked movements out");
    command.callback([request, &chosen] { chosen = [request] { return makePackage(*request); }; });
}

}  // namespace deixis::app
