// deixis simulate: whole studies by simulated participants, in virtual time, nothing drawn.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/stations/simulated_sessions.hpp"
#include "app/stations/simulated_setup.hpp"
#include "app/study/enrolment.hpp"
#include "app/study/stimuli.hpp"
#include "app/study_commands/study_commands.hpp"
#include "assets/data/data_paths.hpp"
#include "core/staging.hpp"
#include "results/database/database_files.hpp"
#include "studies/design/plan.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct SimulateArguments {
    std::string study;
    int participants = 39;
    std::string database;
    std::string stimuli;
    std::string parameters;
};

// Everybody, into a database that is made. Returns how many units were answered.
Result<int> simulateInto(const fs::path& database, const SimulateArguments& options,
                         const LockedStudy& locked, const assets::Avatar& avatar,
                         const studies::SimulatedParameters& parameters) {
    auto store = results::Store::open(database, results::Durability::whole_run);
    if (!store) return tl::unexpected(store.error());
    const StudySetup& setup = locked.setup;
    std::vector<studies::StudyPlan> plans;
    for (int i = 1; i <= options.participants; ++i) {
        const auto enrolment = enrol(setup, *store, fmt::format("S{:03}", i), {}, 0.0);
        if (!enrolment) return tl::unexpected(enrolment.error());
        if (auto stored =
                store->storePlan(setup.study, enrolment->registration, enrolment->plan, locked.hash);
            !stored)
            return tl::unexpected(stored.error());
        plans.push_back(enrolment->plan);
    }
    const auto stimuli = StimulusLibrary::load(locked, plans, avatar);
    if (!stimuli) return tl::unexpected(stimuli.error());
    const auto answers = simulateSessions(setup, plans, avatar, *stimuli, parameters, *store);
    if (!answers) return answers;
    store->commit();
    return answers;
}

Result<void> simulate(const SimulateArguments& options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    const auto parameters = studies::loadSimulatedParameters(options.parameters);
    if (!parameters) return tl::unexpected(parameters.error());

    std::error_code code;
    if (fs::exists(options.database, code))
        return fail(options.database, "exists already; a simulation never adds to or overwrites a database",
                    "Name another file with -o, or remove it");

    if (auto free = results::checkPlaceForDatabase(options.database); !free) return free;
    const fs::path made =
        options.stimuli.empty() ? stimuliFolder(options.database) : fs::path(options.stimuli);
    const auto hash = lockStudy(*setup, {options.database, made, {}, {}, false});
    if (!hash) return tl::unexpected(firstOf(hash.error(), options.study));
    const auto locked = openLocked(options.database, *hash);
    if (!locked) return tl::unexpected(locked.error());
    const auto avatar = loadStudyAvatar(locked->setup.study);
    if (!avatar) return tl::unexpected(avatar.error());

    PartialFile partial(options.database);
    if (partial.path().has_parent_path()) fs::create_directories(partial.path().parent_path(), code);
    auto working = std::make_optional<ElapsedOnTerminal>("simulating");
    const auto answers = simulateInto(partial.path(), options, *locked, *avatar, *parameters);
    working.reset();
    if (!answers) return tl::unexpected(answers.error());
    if (auto moved = partial.finish(); !moved) return moved;
    fmt::print("{} simulated participants, {} trials and pages answered: {}\n", options.participants,
               *answers, options.database);
    return {};
}

}  // namespace

void addSimulateCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<SimulateArguments>();
    Parser command = cli.addCommand(
        "simulate", "Run whole studies with simulated participants, in virtual time, without drawing");
    describe(command, {.writes = "a new database, and beside it its locked study and the clips of the "
                                 "built-in systems. A database that is there already is never replaced.",
                       .example = "deixis simulate pointing2023 --participants 39 -o simulated.sqlite",
                       .page = "docs/simulated-participant.md"});
    command.addOption("STUDY", options->study, "Study file, or the name of one that ships").required();
    command
        .addOption("--participants", options->participants,
                   "How many simulated participants, S001, S002 and so on")
        .check(Range(1, 9999))
        .showDefault();
    addOutput(command, options->database, "Database to make; must not exist").required();
    command.addOption("--stimuli", options->stimuli,
                      "Folder for the built-in systems' clips [beside the database]");
    command
        .addOption("--parameters", options->parameters,
                   "Simulated participants' parameters (TOML) [those that ship]")
        .defaultValue(assets::dataFile("simulated_participant.toml").string())
        .showDefault("");
    command.callback([options, &chosen] { chosen = [options] { return simulate(*options); }; });
}

}  // namespace deixis::app
