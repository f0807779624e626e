// deixis plan: the exact trials of a participant.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "studies/plan.hpp"
#include "study_setup.hpp"

namespace deixis::app {

namespace {

struct PlanArguments {
    std::string study;
    std::string participant;
    int number = 0;
    std::vector<std::string> groups;
    bool json = false;
};

// FACTOR=LEVEL ...
Result<studies::Groups> parseGroups(const std::vector<std::string>& options) {
    studies::Groups groups;
    for (const std::string& option : options) {
        const auto equals = option.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == option.size())
            return fail("--group", fmt::format("'{}' was given; expected FACTOR=LEVEL", option));
        groups[option.substr(0, equals)] = option.substr(equals + 1);
    }
    return groups;
}

// The stored plan's JSON; trials of one stimulus tell its system and item under names of their own, too.
std::string jsonForScripts(const studies::StudyPlan& plan) {
    auto json = nlohmann::ordered_json::parse(studies::planJson(plan));
    for (auto& trial : json["trials"]) {
        if (trial["stimuli"].size() != 1) continue;
        trial["system"] = trial["stimuli"][0]["system"];
        trial["target_id"] = trial["stimuli"][0]["item"];
    }
    return json.dump(1) + "\n";
}

Result<void> printPlan(const PlanArguments& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    auto groups = parseGroups(options.groups);
    if (!groups) return tl::unexpected(groups.error());
    const int number =
        options.number > 0 ? options.number : studies::numberOfParticipant(options.participant).value_or(1);
    const studies::Turn turn = studies::turnOf(setup->study, number, *groups);
    const auto plan = studies::buildPlan(setup->study, setup->targets, options.participant, number,
                                         turn.groups, turn.number_in_cell);
    if (!plan) return tl::unexpected(plan.error());
    fmt::print("{}", options.json ? jsonForScripts(*plan) : studies::planTable(*plan));
    return {};
}

}  // namespace

void addPlanCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<PlanArguments>();
    CLI::App* command = cli.add_subcommand("plan", "Print the exact trials of a participant");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participant", options->participant, "Pseudonymous id, such as P07")->required();
    command
        ->add_option("--number", options->number,
                     "Number of the participant in the study [the digits that the id ends in, or 1]")
        ->check(CLI::Range(1, 999999));
    command->add_option("--group", options->groups,
                        "FACTOR=LEVEL of a factor between participants; may be repeated [as drawn where all "
                        "before enrolled in "
                        "the order of their numbers]");
    command->add_flag("--json", options->json, "As JSON instead of a table");
    command->callback([options, &chosen] { chosen = [options] { return printPlan(*options); }; });
}

}  // namespace deixis::app
