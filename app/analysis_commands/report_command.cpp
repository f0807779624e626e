// deixis report: the analysis of databases or long tables as a page, as JSON and as tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/analysis_commands/report.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/version.hpp"
#include "app/program/written_output.hpp"
#include "app/study/observed_choices.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"
#include "core/number.hpp"
#include "core/server_address.hpp"
#include "core/text.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/long_table.hpp"
#include "results/answers/stations.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "results/report/stations_page.hpp"
#include "results/server/server.hpp"

namespace deixis::app {

namespace {

struct ReportArguments {
    std::vector<std::string> data;
    ReportFiles files;
    results::AnalysisOptions analysis;
    DataChoice choice;
    std::vector<std::string> equivalence;
    std::string unit;
    std::vector<std::string> columns;
    std::vector<std::string> scales;
    std::string by;
};

/// "MEASURE=BOUND", each.
Result<std::map<std::string, double>> boundsFrom(const std::vector<std::string>& texts) {
    std::map<std::string, double> out;
    for (const std::string& text : texts) {
        const auto equals = text.rfind('=');
        const auto bound = equals == std::string::npos ? std::nullopt : finiteNumber(text.substr(equals + 1));
        if (!bound || *bound <= 0.0 || equals == 0)
            return fail("--equivalence", fmt::format("found \"{}\", expected MEASURE=BOUND, above 0", text),
                        "Such as naturalness=0.5");
        out[text.substr(0, equals)] = *bound;
    }
    return out;
}

/// "MEASURE=LOW..HIGH", each.
Result<std::map<std::string, studies::Range>> scalesFrom(const std::vector<std::string>& texts) {
    std::map<std::string, studies::Range> out;
    for (const std::string& text : texts) {
        const auto equals = text.rfind('=');
        const auto dots = text.rfind("..");
        std::optional<double> low;
        std::optional<double> high;
        if (equals != std::string::npos && dots != std::string::npos && dots > equals) {
            low = finiteNumber(text.substr(equals + 1, dots - equals - 1));
            high = finiteNumber(text.substr(dots + 2));
        }
        if (!low || !high || *low >= *high || equals == 0)
            return fail("--scale", fmt::format("found \"{}\", expected MEASURE=LOW..HIGH", text),
                        "Such as naturalness=1..5");
        out[text.substr(0, equals)] = {*low, *high};
    }
    return out;
}

/// "MEANING=NAME", each.
Result<std::map<std::string, std::string>> columnsFrom(const std::vector<std::string>& texts) {
    std::map<std::string, std::string> out;
    for (const std::string& text : texts) {
        const auto column = nameAndValue(text);
        if (!column)
            return fail("--column", fmt::format("found \"{}\", expected MEANING=NAME", text),
                        "Such as participant=subject, if the file calls participants subjects");
        out[column->first] = column->second;
    }
    return out;
}

/// Adds what observers would read where the clips that were shown are available. Returns a note where they
/// are not; empty where nothing is missing.
std::string watchAgain(const std::vector<std::string>& data, const std::string& stimuli,
                       std::vector<results::ResponseTable>& tables) {
    std::set<std::string> missing;
    for (std::size_t i = 0; i < data.size(); ++i) {
        if (!isDatabase(data[i])) continue;
        if (auto choices = observedChoices(data[i], stimuli))
            tables[i].watched = std::move(*choices);
        else
            missing.insert(choices.error().text());
    }
    for (results::ResponseTable& table : tables)
        std::erase_if(table.watched, [&](const results::ObservedChoice& one) {
            return std::any_of(
                table.left_out.begin(), table.left_out.end(),
                [&](const results::LeftOut& left) { return left.participant == one.participant; });
        });
    if (missing.empty()) return "";
    // Of some databases alone they would not be the choices that the other tables count.
    for (results::ResponseTable& table : tables) table.watched.clear();
    return fmt::format(
        "What simulated observers would choose after the same arms, and choices by where the arm pointed at "
        "the start and end of its hold, are left out: {}",
        fmt::join(missing, "; "));
}

/// One of the data: a database, a long table, or a study on a server.
Result<results::ResponseTable> loadOne(const std::string& data, const DataChoice& choice,
                                       const results::LongTableOptions& csv) {
    if (isServerAddress(data)) return results::loadServerResponses(data, choice.study);
    std::error_code code;
    if (looksLikeServerAddress(data) && !std::filesystem::exists(data, code))
        return fail(data, "is neither a file nor the address of a PostgreSQL server",
                    "Such an address begins with postgresql://, in lower case");
    auto table = results::loadAnswers(data, csv);
    if (table && !isDatabase(data))
        for (const std::string& note : table->notes) fmt::print(stderr, "note: {}: {}\n", data, note);
    return table;
}

/// Each by itself, in their order.
Result<std::vector<results::ResponseTable>> loadEach(const std::vector<std::string>& data,
                                                     const DataChoice& choice) {
    if (!choice.study.empty() && std::none_of(data.begin(), data.end(), isServerAddress))
        return fail("--study", "names a study on a server, but none of the data is a server's address");
    for (auto one = data.begin(); one != data.end(); ++one)
        for (auto other = data.begin(); other != one; ++other)
            if (std::error_code code; *one == *other || std::filesystem::equivalent(*one, *other, code))
                return fail(*one, "is named twice", "Name each one once");
    // What is said of columns and scales is meant for the CSV files among them.
    const bool all_databases = std::all_of(data.begin(), data.end(), isDatabase);
    std::vector<results::ResponseTable> tables;
    for (const std::string& file : data) {
        auto table = loadOne(file, choice,
                             isDatabase(file) && !all_databases ? results::LongTableOptions{} : choice.csv);
        if (!table) return tl::unexpected(table.error());
        tables.push_back(std::move(*table));
    }
    return tables;
}

}  // namespace

Result<results::ResponseTable> loadAll(const std::vector<std::string>& data, const DataChoice& choice) {
    auto tables = loadEach(data, choice);
    if (!tables) return tl::unexpected(tables.error());
    return results::joinTables(std::move(*tables));
}

namespace {

/// Tables first: where they may not be written, nothing is.
Result<void> writeAnalysis(const results::AnalysisResult& analysis, const ReportFiles& files) {
    // Tables may hold millions of answers: the page is made beside them.
    auto page = std::async(std::launch::async, [&] {
        return files.page.empty() ? std::string() : results::renderReport(analysis);
    });
    std::vector<FolderFiles> folders;
    if (!files.csv.empty() || !files.r.empty()) {
        auto tables = results::analysisTables(analysis, results::TableFormat::csv);
        if (!files.csv.empty()) folders.push_back({files.csv, tables});
        if (!files.r.empty()) {
            auto script = readFile(assets::dataFile("analysis.R"));
            if (!script) return tl::unexpected(script.error());
            tables.emplace_back("analysis.R", std::move(*script));
            folders.push_back({files.r, std::move(tables)});
        }
    }
    if (!files.latex.empty())
        folders.push_back({files.latex, results::analysisTables(analysis, results::TableFormat::latex)});
    if (auto written = writeFolders(folders, files.force); !written) return written;
    const std::string html = page.get();
    if (!files.page.empty())
        if (auto written = writeFile(files.page, html); !written) return written;
    if (files.json.empty()) return {};
    return writeOutput(files.json, results::analysisJson(analysis));
}

/// "report.html" of the desktop is "report-desktop.html"; a folder gets one within.
ReportFiles filesOf(const ReportFiles& files, const std::string& kind) {
    const auto named = [&](const std::string& file) {
        if (file.empty()) return file;
        const std::filesystem::path path(file);
        return (path.parent_path() / (path.stem().string() + "-" + kind + path.extension().string()))
            .string();
    };
    const auto within = [&](const std::string& folder) {
        return folder.empty() ? folder : (std::filesystem::path(folder) / kind).string();
    };
    return {named(files.page),   named(files.json), within(files.csv),
            within(files.latex), within(files.r),   files.force};
}

/// One analysis, or one for each kind of station, with a page that leads to them and compares the stations.
Result<void> writeByStation(results::ResponseTable table, const ReportFiles& files,
                            const results::AnalysisOptions& options, const std::string& stations) {
    const std::vector<std::string> kinds = results::stationKinds(table);
    const bool together = stations == "together" || (stations.empty() && table.stations_together);
    if (auto meet = results::checkStudiesMeet(table, together); !meet) return meet;
    if (!stations.empty() && stations != "apart" && !together) {
        if (std::find(kinds.begin(), kinds.end(), stations) == kinds.end())
            return fail("--stations", fmt::format("found \"{}\", and no answer was given there", stations),
                        fmt::format("apart, together, or one of: {}", fmt::join(kinds, ", ")));
        return writeAnalysis(results::analyse(results::onlyAt(std::move(table), stations), options), files);
    }
    const auto people = std::count_if(kinds.begin(), kinds.end(), [](const std::string& kind) {
        return kind != results::simulated_station;
    });
    if (kinds.size() <= 1) return writeAnalysis(results::analyse(std::move(table), options), files);
    if (together && people > 0)
        return writeAnalysis(results::analyse(people > 1 ? results::withStations(std::move(table))
                                                         : results::onlyAt(std::move(table), std::nullopt),
                                              options),
                             files);
    if (files.json == standard_output)
        return fail("--json",
                    fmt::format("the answers come from {} kinds of station, each with its own analysis",
                                kinds.size()),
                    "--stations KIND or together gives one; --json FILE writes them all");
    std::vector<results::StationReport> reports;
    for (const std::string& kind : kinds) {
        const std::string name = kind.empty() ? "unknown" : kind;
        const ReportFiles own = filesOf(files, name);
        const auto analysis = results::analyse(results::onlyAt(table, kind), options);
        if (auto written = writeAnalysis(analysis, own); !written) return written;
        reports.push_back({name, std::filesystem::path(own.page).filename().string(), analysis.participants,
                           static_cast<int>(analysis.table.rows.size())});
        fmt::print("station {}: {}\n", name, own.page);
    }
    const auto between = results::analyse(results::withStations(std::move(table)), options);
    if (!files.page.empty())
        if (auto written = writeFile(files.page, results::renderStations(between, reports)); !written)
            return written;
    if (!files.json.empty())
        if (auto written = writeFile(files.json, results::stationsJson(between, reports)); !written)
            return written;
    return {};
}

}  // namespace

Result<void> writeReport(const std::vector<std::string>& data, const ReportFiles& files,
                         const results::AnalysisOptions& options, const DataChoice& choice) {
    for (const std::string& file : {files.page, files.json})
        if (auto checked = checkOutput(file); !checked) return checked;
    if (!files.page.empty() && files.page == files.json)
        return fail(files.page, "is named for both the page and the JSON");
    auto tables = loadEach(data, choice);
    if (!tables) return tl::unexpected(tables.error());
    const std::string note = choice.without_clips ? "" : watchAgain(data, choice.stimuli, *tables);
    results::JoinChoice join = choice.join;
    join.alpha = options.alpha;
    auto table = results::joinData(std::move(*tables), join);
    if (!table) return tl::unexpected(table.error());
    if (!note.empty()) table->notes.push_back(note);
    if (options.by_ratings.value_or(false) &&
        std::none_of(table->measures.begin(), table->measures.end(),
                     [](const results::Measure& one) { return one.kind == results::MeasureKind::rating; }))
        return fail("--unit", "found \"ratings\", but the data have none",
                    "Leave it out: choices and preferences are tested by participants");
    results::AnalysisOptions named = options;
    if (!choice.evaluation.empty()) {
        auto objective = results::readObjectiveAccuracy(choice.evaluation);
        if (!objective) return tl::unexpected(objective.error());
        if (auto same = results::checkSameClips(*objective, *table); !same) return same;
        named.objective = std::move(*objective);
    }
    const ElapsedOnTerminal working("analysing");
    named.program = programVersion();
    named.build = buildProperties();
    return writeByStation(std::move(*table), files, named, choice.stations);
}

void addReportCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<ReportArguments>();
    Parser command = cli.addCommand(
        "report", "Analyse databases or long tables: an HTML page, and the numbers as JSON, CSV and LaTeX");
    describe(
        command,
        {.writes =
             "the page (-o; default: report.html in this folder), and the files of --json, --csv, --latex "
             "and --r. --json without FILE prints the numbers, and a page is then written only with -o.",
         .example =
             "deixis report study.sqlite -o report.html --csv tables\ndeixis report study.sqlite --json",
         .page = "docs/analysis.md"});
    command
        .addOption("DATA", options->data,
                   "Databases of one study or of several, CSV files with one line per answer, or a server's "
                   "address (postgresql://USER@HOST:PORT/DATABASE)")
        .required();
    command
        .addOption("--by", options->by,
                   "study: compare studies, each a group of participants: the systems within each and "
                   "pooled. This is the default for databases of studies with different names; with it, each "
                   "CSV file is one study")
        .check(OneOf{{"study"}});
    command
        .addOption("--measure", options->choice.join.measures,
                   "Analyse this measure only, such as one that several studies share; may be "
                   "repeated")
        .oneValueEachTime();
    command.addOption("--study", options->choice.study,
                      "Which study, if a server has several: its name, or the beginning of its hash");
    addOutput(command, options->files.page, "HTML page to write [report.html]");
    addForce(command, options->files.force);
    addJsonOrFile(command, options->files.json);
    addCsv(command, options->files.csv, "Folder to write every table to, as CSV");
    command.addOption("--latex", options->files.latex, "Folder to write every table to, as LaTeX (booktabs)");
    command.addOption("--r", options->files.r,
                      "Folder for the tables and analysis.R, which recomputes them and adds mixed models");
    command
        .addOption(
            "--evaluation", options->choice.evaluation,
            "JSON of the objective evaluation of the same clips (deixis evaluate): adds how answers and "
            "Equation 2 go together, by system and by target")
        .valueName("FILE");
    command.addOption("--stimuli", options->choice.stimuli,
                      "Folder of the clips that the databases' sessions showed [where they were]");
    command.addFlag("--without-clips", options->choice.without_clips,
                    "Do not read those clips: use the answers only");
    command.addOption("--alpha", options->analysis.alpha, "Level of significance; default: the study's")
        .check(Range(1e-6, 0.5));
    command
        .addOption("--level", options->analysis.level,
                   "Level of the intervals; default 1 - alpha, so that they agree with the tests")
        .check(Range(0.5, 0.9999));
    command.addOption("--resamples", options->analysis.resamples, "Resamples of the bootstrap")
        .check(Range(100, 1000000))
        .showDefault();
    command
        .addOption("--between", options->choice.csv.between,
                   "Column of CSV files with the groups of a between-participants factor; may be repeated")
        .oneValueEachTime();
    command
        .addOption("--within", options->choice.csv.within,
                   "Column of CSV files with the levels of a within-participants factor; may be repeated")
        .oneValueEachTime();
    command
        .addOption("--column", options->columns,
                   "What CSV files call a column, such as participant=subject, "
                   "rating=slider.response or rt_ms=rt; may be repeated")
        .oneValueEachTime();
    command
        .addOption("--scale", options->scales,
                   "The scale of ratings in CSV files; an answer outside it is an error; "
                   "may be repeated")
        .oneValueEachTime();
    command.addOption("--stations", options->choice.stations,
                      "Answers given at a desktop and in a headset: apart (a report each), together (station "
                      "is then a factor), or those of one kind; default: the study's choice, or apart. "
                      "Simulated participants are always "
                      "reported apart");
    command
        .addOption("--equivalence", options->equivalence,
                   "Bound within which two systems, levels or groups count as equivalent; may be repeated")
        .oneValueEachTime();
    command
        .addOption(
            "--unit", options->unit,
            "ratings: also test single ratings, in tables marked as pseudo-replicated, beside participants' "
            "means; participants: only these. Default: the study's choice, or participants")
        .check(OneOf{{"participants", "ratings"}});
    addSeed(command, options->analysis.seed, "the bootstrap");
    command.callback([options, &chosen] {
        chosen = [options]() -> Result<void> {
            ReportFiles& files = options->files;
            const bool json_alone = files.json == standard_output;
            if (files.page.empty() && !json_alone) files.page = "report.html";
            for (const std::string& file : {files.page, files.json})
                if (auto free = checkReplaceable(file, files.force); !free) return free;
            options->choice.join.by_study = !options->by.empty();
            auto bounds = boundsFrom(options->equivalence);
            if (!bounds) return tl::unexpected(bounds.error());
            options->analysis.equivalence = std::move(*bounds);
            if (!options->unit.empty()) options->analysis.by_ratings = options->unit == "ratings";
            auto columns = columnsFrom(options->columns);
            if (!columns) return tl::unexpected(columns.error());
            options->choice.csv.columns = std::move(*columns);
            auto scales = scalesFrom(options->scales);
            if (!scales) return tl::unexpected(scales.error());
            options->choice.csv.scales = std::move(*scales);
            if (auto done = writeReport(options->data, files, options->analysis, options->choice); !done)
                return done;
            const auto tell = [to = remarksBeside(files.json)](const char* what, const std::string& where) {
                if (!where.empty()) fmt::print(to, "{}: {}\n", what, where);
            };
            tell("report", files.page);
            if (!json_alone) tell("analysis", files.json);
            tell("tables", files.csv);
            tell("LaTeX tables", files.latex);
            if (!files.r.empty()) tell("R", fmt::format("Rscript {}/analysis.R", files.r));
            return {};
        };
    });
}

}  // namespace deixis::app
