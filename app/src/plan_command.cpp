// deixis plan: the exact trials of a participant.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "studies/plan.hpp"
#include "study_setup.hpp"

namespace deixis::app {

namespace {

struct Options {
    std::string study;
    std::string participant;
    bool json = false;
};

Result<void> printPlan(const Options& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    const auto plan = studies::buildPlan(setup->study, setup->targets, options.participant);
    if (!plan) return tl::unexpected(plan.error());
    fmt::print("{}", options.json ? studies::planJson(*plan) : studies::planTable(*plan));
    return {};
}

}  // namespace

void addPlanCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = cli.add_subcommand("plan", "Print the exact trials of a participant");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participant", options->participant, "Pseudonymous id, such as P07")->required();
    command->add_flag("--json", options->json, "As JSON instead of a table");
    command->callback([options, &chosen] { chosen = [options] { return printPlan(*options); }; });
}

}  // namespace deixis::app
