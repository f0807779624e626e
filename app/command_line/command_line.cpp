#include "app/command_line/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/clip_commands/clip_commands.hpp"
#include "app/learning_commands/learning_commands.hpp"
#include "app/program/command_help.hpp"
#include "app/program/help_formatter.hpp"
#ifdef DEIXIS_STUDIO
#include "app/studio_commands/studio_commands.hpp"
#endif
#include "app/study_commands/study_commands.hpp"
#include "core/nearest_name.hpp"
#include "core/number.hpp"

namespace deixis::app {

namespace {

/// "010" would be read as 8.
bool leadsWithZero(const std::string& text) {
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    return text.size() > first + 1 && text[first] == '0';
}

std::string expectNumber(const std::string& text) {
    return finiteNumber(text) ? "" : fmt::format("found '{}', expected a finite number", text);
}

std::string expectWhole(const std::string& text) {
    if (wholeNumber(text) && !leadsWithZero(text)) return "";
    return fmt::format("found '{}', expected a whole number", text);
}

std::string expectNatural(const std::string& text) {
    if (naturalNumber(text) && !leadsWithZero(text)) return "";
    return fmt::format("found '{}', expected a whole number from 0 on", text);
}

/// Ranges alone do not keep nan out, and the numbers' own reading wraps and overflows: so every option is
/// guarded, by the type of what it sets.
void guardNumbers(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() == 0) continue;  // a flag
        const std::string type = option->get_type_name();
        if (type.starts_with("FLOAT"))
            option->check(expectNumber);
        else if (type.starts_with("UINT"))
            option->check(expectNatural);
        else if (type.starts_with("INT"))
            option->check(expectWhole);
    }
    for (CLI::App* command : app.get_subcommands({})) guardNumbers(*command);
}

using AddCommand = void (*)(Parser, Command&);

std::vector<CLI::App*> allCommands(CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string notThere(const std::string& what, const std::string& where, const std::string& found,
                     const std::vector<std::string>& known) {
    const std::vector<std::string_view> names(known.begin(), known.end());
    const std::string_view nearest = nearestName(found, names);
    return fmt::format("{}: there is no {} {}{}", where, what, found,
                       nearest.empty() ? "" : fmt::format(". Did you mean {}?", nearest));
}

std::vector<std::string> optionsOf(const CLI::App& app) {
    std::vector<std::string> out;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
    return out;
}

}  // namespace

void addCommands(CLI::App& cli, Command& chosen) {
    cli.formatter(helpFormatter());
    const Parser parser(cli);
    describe(
        parser,
        {.writes = "what each command says below its options.",
         .example = "deixis run pointing2023 --participant P01 --db study.sqlite\ndeixis report study.sqlite",
         .page = "docs/command-line.md"});
    const auto group = [&cli, &chosen, parser](const char* name, std::initializer_list<AddCommand> commands) {
        const std::size_t before = allCommands(cli).size();
        for (const AddCommand add : commands) add(parser, chosen);
        const auto all = allCommands(cli);
        for (std::size_t i = before; i < all.size(); ++i) all[i]->group(name);
    };
    group("Commands for a study", {addCheckCommand, addPlanCommand, addTargetsCommand, addRunCommand,
                                   addSimulateCommand, addParticipantsCommand, addReplayCommand});
    group("Commands for its results", {addReportCommand, addExportCommand, addMergeCommand, addPackageCommand,
                                       addPushCommand, addReproductionCommand, addSchemaCommand});
    group("Commands for statistics", {addPowerCommand, addFitCommand, addStatsCommand});
    group("Commands for clips and systems",
          {addGenerateCommand, addEvaluateCommand, addClipsCommand, addViewCommand, addLearnCommand});
#ifdef DEIXIS_STUDIO
    group("Commands for the studio", {addStudioCommand, addServeCommand});
#endif
    addDescribeCommand(parser, chosen);
    nameValues(cli);
    guardNumbers(cli);
}

std::string unknownWord(const CLI::App& cli, const std::vector<std::string>& arguments) {
    const CLI::App* app = &cli;
    std::string path = cli.get_name();
    for (const std::string& argument : arguments) {
        if (argument.starts_with("--")) {
            const std::string name = argument.substr(0, argument.find('='));
            if (name.size() > 2 && app->get_option_no_throw(name) == nullptr)
                return notThere("option", path, name, optionsOf(*app));
            continue;
        }
        const auto commands = app->get_subcommands([](const CLI::App*) { return true; });
        if (argument.starts_with('-') || commands.empty()) continue;
        const auto next = std::find_if(commands.begin(), commands.end(), [&](const CLI::App* command) {
            return command->get_name() == argument;
        });
        if (next == commands.end()) {
            std::vector<std::string> names;
            for (const CLI::App* command : commands) names.push_back(command->get_name());
            return notThere("command", path, argument, names);
        }
        app = *next;
        path += " " + argument;
    }
    return "";
}

}  // namespace deixis::app
