// deixis plan: the exact trials of a participant.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/study/enrolment.hpp"
#include "app/study/study_under_way.hpp"
#include "app/study_commands/study_commands.hpp"
#include "core/text.hpp"
#include "results/store/store.hpp"
#include "studies/design/plan.hpp"

namespace deixis::app {

namespace {

struct PlanArguments {
    std::string study;
    std::string database;
    std::string participant;
    int number = 0;
    std::vector<std::string> groups;
    bool json = false;
};

// FACTOR=LEVEL ...
Result<studies::Groups> parseGroups(const std::vector<std::string>& options) {
    studies::Groups groups;
    for (const std::string& option : options) {
        const auto group = nameAndValue(option);
        if (!group) return fail("--group", fmt::format("'{}' was given; expected FACTOR=LEVEL", option));
        groups[group->first] = group->second;
    }
    return groups;
}

// The stored plan's JSON, with what it is; trials of one stimulus tell its system and item under names of
// their own, too. assets/data/schemas/plan.schema.json describes it.
std::string jsonForScripts(const studies::StudyPlan& plan) {
    nlohmann::ordered_json json{{"schema", {{"name", "deixis-plan"}, {"version", 1}}}};
    json.update(nlohmann::ordered_json::parse(studies::planJson(plan)));
    for (auto& trial : json["trials"]) {
        if (trial["stimuli"].size() != 1) continue;
        trial["system"] = trial["stimuli"][0]["system"];
        trial["target_id"] = trial["stimuli"][0]["item"];
    }
    return json.dump(1) + "\n";
}

/// Of a new participant of a study file.
Result<studies::StudyPlan> planOfStudy(const PlanArguments& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    auto groups = parseGroups(options.groups);
    if (!groups) return tl::unexpected(groups.error());
    const int number =
        options.number > 0 ? options.number : studies::numberOfParticipant(options.participant).value_or(1);
    const studies::Assignment turn = studies::assignmentOf(setup->study, number, *groups);
    return studies::buildPlan(setup->study, setup->targets, options.participant, number, turn.groups,
                              turn.number_in_cell);
}

/// The plan that the database holds; of who is not in it yet the one that a session begun now would have.
Result<studies::StudyPlan> planInDatabase(const PlanArguments& options) {
    std::optional<studies::StudyPlan> plan;
    const auto number = options.number > 0 ? std::optional(options.number) : std::nullopt;
    const auto read =
        results::Store::read(options.database, [&](const results::Store& store) -> Result<void> {
            plan = store.plan(options.participant);
            if (plan && number && *number != plan->number)
                return fail("--number",
                            fmt::format("found {}, but {} takes part with the number {}", *number,
                                        options.participant, plan->number),
                            "Leave it out");
            if (plan) return {};
            const auto held = studyHeld(options.database, store);
            if (!held) return tl::unexpected(held.error());
            auto enrolment = enrol(held->setup, store, options.participant, number, 0.0);
            if (!enrolment) return tl::unexpected(enrolment.error());
            plan = std::move(enrolment->plan);
            return {};
        });
    if (!read) return tl::unexpected(read.error());
    return std::move(*plan);
}

Result<void> printPlan(const PlanArguments& options) {
    const auto plan = options.database.empty() ? planOfStudy(options) : planInDatabase(options);
    if (!plan) return tl::unexpected(plan.error());
    fmt::print("{}", options.json ? jsonForScripts(*plan) : studies::planTable(*plan));
    return {};
}

}  // namespace

void addPlanCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<PlanArguments>();
    Parser command = cli.addCommand("plan", "Print the exact trials of a participant");
    describe(command, {.writes = "nothing; it prints the plan.",
                       .example = "deixis plan pointing2023 --participant P07\ndeixis plan --db "
                                  "study.sqlite --participant P07 --json",
                       .page = "docs/design.md"});
    auto study = command.addOption("STUDY", options->study, "Study file, or the name of one included");
    auto database = command.addOption("--db", options->database,
                                      "Instead of STUDY: a database. Prints the participant's stored plan, "
                                      "or the one that the next session would store");
    database.excludes(study);
    command.addOption("--participant", options->participant, "Pseudonymous id, such as P07").required();
    command
        .addOption("--number", options->number,
                   "Number of the participant in the study [the digits at the end of the id, or 1]")
        .check(Range(1, 999999));
    auto group = command.addOption("--group", options->groups,
                                   "Level of a between-participants factor; may be repeated [as if all "
                                   "earlier numbers had enrolled in order]");
    group.valueName("FACTOR=LEVEL");
    database.excludes(group);
    addJson(command, options->json, "Print JSON instead of a table");
    command.callback([options, &chosen] {
        if (options->study.empty() && options->database.empty())
            rejectUsage("plan", "Give STUDY, or the database of a running study with --db");
        chosen = [options] { return printPlan(*options); };
    });
}

}  // namespace deixis::app
