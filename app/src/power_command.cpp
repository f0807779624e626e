// deixis power: how often a study would find assumed effects, by simulation on its real plans.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "assets/data_paths.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "progress_line.hpp"
#include "report.hpp"
#include "results/effect_estimates.hpp"
#include "results/power.hpp"
#include "study_setup.hpp"

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
    results::PowerOptions options;
};

Result<studies::AssumedEffects> effectsFor(const PowerArguments& options, const studies::Study& study) {
    if (options.from.empty())
        return studies::loadAssumedEffects(assets::fileOrShipped(options.effect, "effects"), study);
    const auto table = loadAll(options.from);
    if (!table) return tl::unexpected(table.error());
    auto estimated = results::estimateEffects(*table, study);
    if (!estimated) return tl::unexpected(estimated.error());
    for (const std::string& note : estimated->notes) fmt::print("effects: {}\n", note);
    return std::move(estimated->effects);
}

Result<void> analysePower(const PowerArguments& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    const auto effects = effectsFor(options, setup->study);
    if (!effects) return tl::unexpected(effects.error());
    for (const std::string& file : {options.json, options.csv, options.effects_out})
        if (auto checked = checkOutput(file); !checked) return checked;
    if (!options.effects_out.empty()) {
        auto written = writeFile(options.effects_out, studies::assumedEffectsToml(*effects));
        if (!written) return written;
    }
    auto asked = options.options;
    if (asked.threads == 0) asked.threads = std::thread::hardware_concurrency();
    const int most = *std::max_element(options.participants.begin(), options.participants.end());
    auto power = results::PowerAnalysis::make(setup->study, setup->targets, *effects, most, asked);
    if (!power) return tl::unexpected(power.error());
    power->simulate(options.participants, progressOnTerminal("studies"));
    if (options.search) results::searchParticipants(*power, *options.goal, progressOnTerminal("search"));
    fmt::print("{}", results::powerText(power->result(), options.goal));
    if (!options.json.empty()) {
        auto written = writeFile(options.json, results::powerJson(power->result(), options.goal));
        if (!written) return written;
        fmt::print("\nnumbers: {}\n", options.json);
    }
    if (!options.csv.empty()) {
        if (auto written = writeFile(options.csv, results::powerCsv(power->result())); !written)
            return written;
        fmt::print("{}table: {}\n", options.json.empty() ? "\n" : "", options.csv);
    }
    return {};
}

}  // namespace

void addPowerCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<PowerArguments>();
    CLI::App* command = cli.add_subcommand(
        "power", "How often a study would find assumed effects, and how many participants it needs");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participants", options->participants, "Numbers of participants, such as 10,20,39")
        ->delimiter(',')
        ->check(CLI::Range(2, 2000))
        ->capture_default_str();
    auto* effect = command->add_option(
        "--effect", options->effect,
        "Assumed means and spreads (TOML, docs/power.md), or the name of a file that ships");
    auto* from = command->add_option("--from", options->from,
                                     "Databases or CSV files of the study to estimate them from");
    effect->excludes(from);
    from->excludes(effect);
    command->add_option("--save-effects", options->effects_out,
                        "File to write the effects to that were taken, to be changed and used again");
    auto* goal = command
                     ->add_option("--goal", options->goal,
                                  "Power that is wanted: tell for each contrast how many participants it "
                                  "needs, of those simulated")
                     ->check(CLI::Range(0.01, 0.9999));
    command->add_flag("--search", options->search, "With --goal: simulate numbers between, to the single one")
        ->needs(goal);
    command->add_option("--studies", options->options.studies, "Studies drawn for each number")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--seed", options->options.seed, "Seed of the answers")->capture_default_str();
    command
        ->add_option("--alpha", options->options.alpha, "Level of significance; the study's where not given")
        ->check(CLI::Range(1e-6, 0.5));
    command->add_option("--level", options->options.level, "Level of the intervals of the power")
        ->check(CLI::Range(0.5, 0.9999))
        ->capture_default_str();
    command->add_option("--json", options->json, "JSON file to write");
    command->add_option("--csv", options->csv, "CSV file to write");
    options->options.threads = 0;
    command->add_option("--threads", options->options.threads, "Threads that simulate [one for each core]")
        ->check(CLI::Range(1, 1024));
    command->callback([options, &chosen] {
        if (options->effect.empty() && options->from.empty())
            throw CLI::RequiredError("--effect FILE or --from DATABASE");
        chosen = [options] { return analysePower(*options); };
    });
}

}  // namespace deixis::app
