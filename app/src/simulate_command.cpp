// deixis simulate: whole studies by simulated participants, in virtual time, nothing drawn.
#include <fmt/format.h>

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>

#include "assets/data_paths.hpp"
#include "commands.hpp"
#include "core/durable.hpp"
#include "enrolment.hpp"
#include "motion/reference_humanoid.hpp"
#include "recorders.hpp"
#include "session_loop.hpp"
#include "simulated_setup.hpp"
#include "stimuli.hpp"
#include "studies/plan.hpp"
#include "studies/simulated_participant.hpp"
#include "studies/standing.hpp"
#include "version.hpp"

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

// All sittings of one participant. Returns how many units were answered.
Result<int> takePart(const StudySetup& setup, const studies::StudyPlan& plan, const assets::Avatar& avatar,
                     const StimulusLibrary& stimuli, const studies::SimulatedParameters& parameters,
                     results::Store& store) {
    const motion::LocalPose idle = motion::relaxedPose(avatar.skeleton);
    const studies::Study stood = studies::atStation(setup.study, "simulated");
    const auto records = stimuli.records();
    const std::string where = fmt::format("study '{}': {}", setup.study.name, plan.participant);
    int answers = 0;
    double now_s = 0.0;
    std::optional<std::size_t> answered_before;
    for (;;) {
        const studies::Resume resume = store.resume(plan.participant, now_s);
        if (studies::trialsLeft(setup.study, plan, resume.answered).empty()) return answers;
        if (answered_before == resume.answered.size())
            return fail(where, "a sitting ended without an answer, and trials are left");
        answered_before = resume.answered.size();
        studies::SimulatedStation station(parameters, avatar.skeleton, simulatedSeed(plan));
        const studies::StationInfo info = withProgram(station.info());
        studies::SessionRunner session(stood, plan, stimuli, avatar.skeleton, idle, resume, true);
        store.beginSession({plan.participant, info, programVersion(), avatar.content_hash, now_s});
        DirectRecorder recorder(store, setup.study, plan, records);
        now_s = runSession(session, station, recorder).utc_s;
        answers += recorder.answered();
        store.endSession(session.outcome(), now_s);
        if (const auto why = station.failure()) return fail(where, why->message, why->mend);
        if (session.outcome() != studies::SessionOutcome::finished) return answers;
    }
}

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
    int answers = 0;
    for (const auto& plan : plans) {
        const auto given = takePart(setup, plan, avatar, *stimuli, parameters, *store);
        if (!given) return given;
        answers += *given;
    }
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
                    "Name another file with --db, or remove it");

    const fs::path made =
        options.stimuli.empty() ? stimuliFolder(options.database) : fs::path(options.stimuli);
    const auto hash = lockStudy(*setup, {options.database, made, {}, {}, false});
    if (!hash) return tl::unexpected(firstOf(hash.error(), options.study));
    const auto locked = openLocked(options.database, *hash);
    if (!locked) return tl::unexpected(locked.error());
    const auto avatar = loadStudyAvatar(locked->setup.study);
    if (!avatar) return tl::unexpected(avatar.error());

    // Written beside and renamed at the end: an interrupted simulation leaves no half database.
    const fs::path partial = options.database + ".partial";
    if (partial.has_parent_path()) fs::create_directories(partial.parent_path(), code);
    const auto remove = [&partial](std::initializer_list<const char*> suffixes) {
        std::error_code ignored;
        for (const char* suffix : suffixes) fs::remove(partial.string() + suffix, ignored);
    };
    remove({"", "-wal", "-shm"});
    const auto answers = simulateInto(partial, options, *locked, *avatar, *parameters);
    if (!answers) {
        remove({"", "-wal", "-shm"});
        return tl::unexpected(answers.error());
    }
    if (auto moved = moveFile(partial, options.database); !moved) return moved;
    remove({"-wal", "-shm"});
    fmt::print("{} simulated participants, {} trials and pages answered: {}\n", options.participants,
               *answers, options.database);
    return {};
}

}  // namespace

void addSimulateCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<SimulateArguments>();
    CLI::App* command = cli.add_subcommand(
        "simulate", "Run whole studies with simulated participants, in virtual time, without drawing");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participants", options->participants, "How many (S001, S002, ...)")
        ->check(CLI::Range(1, 9999))
        ->capture_default_str();
    command->add_option("--db", options->database, "Database to make; must not exist")->required();
    command->add_option("--stimuli", options->stimuli,
                        "Folder for the built-in systems' clips [beside the database]");
    command->add_option("--parameters", options->parameters, "Simulated participants' parameters (TOML)")
        ->default_val(assets::dataFile("simulated_participant.toml").string());
    command->callback([options, &chosen] { chosen = [options] { return simulate(*options); }; });
}

}  // namespace deixis::app
