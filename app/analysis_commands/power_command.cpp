// deixis power: how often a study would find assumed effects, by simulation on its real plans.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/analysis_commands/report.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"
#include "results/analysis/effect_estimates.hpp"
#include "results/analysis/power.hpp"

namespace deixis::app {

namespace {

struct PowerArguments {
    std::string study;
    std::vector<int> participants{10, 20, 39, 60};
    std::string effect;
    std::vector<std::string> from;
    std::string effects_out;
    std::optional<double> goal;
    bool search = false;
    std::string json;
    std::string csv;
    bool force = false;
    results::PowerOptions options;
};

Result<studies::AssumedEffects> effectsFor(const PowerArguments& options, const studies::Study& study) {
    if (options.from.empty())
        return studies::loadAssumedEffects(assets::fileOrShipped(options.effect, "effects"), study);
    const auto table = loadAll(options.from);
    if (!table) return tl::unexpected(table.error());
    auto estimated = results::estimateEffects(*table, study);
    if (!estimated) return tl::unexpected(estimated.error());
    for (const std::string& note : estimated->notes)
        fmt::print(remarksBeside(options.json), "effects: {}\n", note);
    return std::move(estimated->effects);
}

Result<void> analysePower(const PowerArguments& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    const auto effects = effectsFor(options, setup->study);
    if (!effects) return tl::unexpected(effects.error());
    for (const std::string& file : {options.json, options.csv, options.effects_out})
        if (auto checked = checkOutput(file); !checked) return checked;
    if (auto free = checkReplaceable(options.json, options.force); !free) return free;
    if (!options.effects_out.empty()) {
        auto written =
            writeUnlessEdited(options.effects_out, studies::assumedEffectsToml(*effects), options.force);
        if (!written) return written;
    }
    auto asked = options.options;
    if (asked.threads == 0) asked.threads = std::thread::hardware_concurrency();
    const int max = *std::max_element(options.participants.begin(), options.participants.end());
    auto power = results::PowerAnalysis::make(setup->study, setup->targets, *effects, max, asked);
    if (!power) return tl::unexpected(power.error());
    power->simulate(options.participants, progressOnTerminal("studies"));
    if (options.search) results::searchParticipants(*power, *options.goal, progressOnTerminal("search"));
    const bool json_alone = options.json == standard_output;
    if (!json_alone) fmt::print("{}", results::powerText(power->result(), options.goal));
    if (!options.json.empty()) {
        auto written = writeOutput(options.json, results::powerJson(power->result(), options.goal));
        if (!written) return written;
        if (!json_alone) fmt::print("\nnumbers: {}\n", options.json);
    }
    if (!options.csv.empty()) {
        // Earlier versions took the file itself.
        const std::filesystem::path named(options.csv);
        const std::filesystem::path csv = named.extension() == ".csv" ? named : named / "power.csv";
        const std::string folder = csv.has_parent_path() ? csv.parent_path().string() : ".";
        auto written = writeFolders(
            {{folder, {{csv.filename().string(), results::powerCsv(power->result())}}}}, options.force);
        if (!written) return written;
        fmt::print(remarksBeside(options.json), "{}table: {}\n", options.json.empty() ? "\n" : "",
                   csv.string());
    }
    return {};
}

}  // namespace

void addPowerCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<PowerArguments>();
    Parser command = cli.addCommand(
        "power", "How often a study would find assumed effects, and how many participants it needs");
    describe(command,
             {.writes = "only what it prints, unless --json FILE, --csv or --save-effects is given.",
              .example = "deixis power pointing2023 --effect pointing2023 --participants 20,40 --goal "
                         "0.8\ndeixis power pointing2023 --from pilot.sqlite --json",
              .page = "docs/power.md"});
    command.addOption("STUDY", options->study, "Study file, or the name of one included").required();
    command.addOption("--participants", options->participants, "Numbers of participants, such as 10,20,39")
        .delimiter(',')
        .check(Range(2, 2000))
        .showDefault();
    auto effect =
        command.addOption("--effect", options->effect,
                          "Assumed means and spreads (TOML, docs/power.md), or the name of a file included");
    auto from =
        command
            .addOption("--from", options->from, "Databases or CSV files of the study to estimate them from")
            .valueName("DATA...");
    effect.excludes(from);
    from.excludes(effect);
    command.addOption("--save-effects", options->effects_out,
                      "File to write the effects used to, for editing and reuse");
    auto goal = command
                    .addOption("--goal", options->goal,
                               "Target power: print for each contrast the smallest simulated number of "
                               "participants that reaches it")
                    .check(Range(0.01, 0.9999));
    command
        .addFlag("--search", options->search,
                 "With --goal: simulate numbers in between, too, to find the exact one")
        .needs(goal);
    command
        .addOption("--studies", options->options.studies, "Simulated studies for each number of participants")
        .check(Range(1, 1000000))
        .showDefault();
    addSeed(command, options->options.seed, "the answers");
    command.addOption("--alpha", options->options.alpha, "Level of significance; default: the study's")
        .check(Range(1e-6, 0.5));
    command.addOption("--level", options->options.level, "Confidence level of the intervals of power")
        .check(Range(0.5, 0.9999))
        .showDefault();
    addJsonOrFile(command, options->json);
    addCsv(command, options->csv, "Folder for the table power.csv, or a file name that ends in .csv");
    addForce(command, options->force);
    options->options.threads = 0;
    command.addOption("--threads", options->options.threads, "Threads that simulate [one per core]")
        .check(Range(1, 1024));
    command.callback([options, &chosen] {
        if (options->effect.empty() && options->from.empty())
            requireUsage("--effect FILE or --from DATABASE");
        chosen = [options] { return analysePower(*options); };
    });
}

}  // namespace deixis::app
