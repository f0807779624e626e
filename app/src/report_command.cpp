// deixis report: the analysis of a database as a page and as JSON.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "commands.hpp"
#include "core/files.hpp"
#include "report.hpp"
#include "results/analysis.hpp"
#include "results/response_table.hpp"

namespace deixis::app {

namespace {

struct ReportArguments {
    std::string database;
    std::string page;
    std::string json;
};

}  // namespace

Result<void> checkOutput(const std::string& file) {
    std::error_code code;
    if (file.empty() || !std::filesystem::is_regular_file(file, code)) return {};
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start == "SQLite format 3")
        return fail(file, "is a database; a report is not written over it", "Name another file");
    return {};
}

Result<void> writeReport(const std::string& database, const std::string& page, const std::string& json) {
    for (const std::string& file : {page, json})
        if (auto checked = checkOutput(file); !checked) return checked;
    if (!page.empty() && page == json) return fail(page, "was named for both the page and the JSON");
    const auto table = results::loadResponses(database);
    if (!table) return tl::unexpected(table.error());
    const auto analysis = results::analyse(*table);
    if (!page.empty())
        if (auto written = writeFile(page, results::renderReport(analysis)); !written) return written;
    if (!json.empty())
        if (auto written = writeFile(json, results::analysisJson(analysis)); !written) return written;
    return {};
}

void addReportCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<ReportArguments>();
    CLI::App* command =
        cli.add_subcommand("report", "Analyse a database: an HTML page, and the numbers as JSON");
    command->add_option("DB", options->database, "Database of a study")->required();
    command->add_option("-o,--output", options->page, "HTML page to write")->default_val("report.html");
    command->add_option("--json", options->json, "JSON file to write");
    command->callback([options, &chosen] {
        chosen = [options]() -> Result<void> {
            if (auto done = writeReport(options->database, options->page, options->json); !done) return done;
            fmt::print("report: {}\n", options->page);
            if (!options->json.empty()) fmt::print("analysis: {}\n", options->json);
            return {};
        };
    });
}

}  // namespace deixis::app
