// deixis run: one participant's session, from the first page to the report.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "assets/data_paths.hpp"
#include "commands.hpp"
#include "motion/reference_humanoid.hpp"
#include "recorders.hpp"
#include "report.hpp"
#include "results/store.hpp"
#include "session_loop.hpp"
#include "simulated_setup.hpp"
#include "stations.hpp"
#include "stimuli.hpp"
#include "study_setup.hpp"
#include "trace.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string study;
    std::string participant;
    std::string database;
    std::string report;
    std::string stimuli;
    std::vector<std::string> screenshots;
    std::string trace;
    StationRequest station;
};

double utcNow_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// The first of P01, P02, ... that the database does not know.
std::string nextParticipant(const results::Store& store) {
    const auto taken = store.participants();
    for (int i = 1;; ++i) {
        std::string id = fmt::format("P{:02}", i);
        if (std::find(taken.begin(), taken.end(), id) == taken.end()) return id;
    }
}

int unanswered(const studies::StudyPlan& plan, const std::set<int>& answered) {
    int count = 0;
    for (const auto& trial : plan.trials) count += !trial.practice && !answered.contains(trial.index);
    return count;
}

// STATE=FILE ...
Result<std::map<std::string, std::string>> parseScreenshots(const std::vector<std::string>& options) {
    std::map<std::string, std::string> out;
    for (const std::string& option : options) {
        const auto equals = option.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == option.size())
            return fail("--screenshot", fmt::format("'{}' was given; expected STATE=FILE.png", option));
        out[option.substr(0, equals)] = option.substr(equals + 1);
    }
    return out;
}

// What the session came to, and where it lies.
Result<void> reportSession(const Options& options, const std::string& participant, int left) {
    const std::string page = options.report.empty()
                                 ? fs::path(options.database).replace_extension(".html").string()
                                 : options.report;
    const auto written = writeReport(options.database, page, "");
    if (left > 0)
        fmt::print("{} has {} trials left; the same command with --participant {} goes on there\n",
                   participant, left, participant);
    fmt::print("database: {}\n", fs::absolute(options.database).lexically_normal().string());
    if (!written) {
        if (!options.report.empty()) return written;
        fmt::print("report:   none yet ({})\n", written.error().text());
        return {};
    }
    fmt::print("report:   {}\n", fs::absolute(page).lexically_normal().string());
    return {};
}

Result<void> run(Options options) {
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    auto screenshots = parseScreenshots(options.screenshots);
    if (!screenshots) return tl::unexpected(screenshots.error());
    options.station.screenshots->wanted = std::move(*screenshots);
    if (options.database.empty()) options.database = setup->study.name + ".sqlite";
    const auto recording = recordingOptions();
    if (!recording) return tl::unexpected(recording.error());
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());

    auto store = results::Store::open(options.database, results::Durability::each_answer);
    if (!store) return tl::unexpected(store.error());
    const std::string participant =
        options.participant.empty() ? nextParticipant(*store) : options.participant;
    auto plan = studies::buildPlan(setup->study, setup->targets, participant);
    if (!plan) return tl::unexpected(plan.error());
    const auto lock = results::ParticipantLock::take(options.database, participant);
    if (!lock) return tl::unexpected(lock.error());
    // Who has begun goes on with the stored plan, whatever a newer program would draw.
    if (auto stored = store->plan(participant); stored && stored->study_hash == setup->study.hash)
        plan = std::move(*stored);

    const std::set<int> answered = store->answeredTrials(participant);
    if (unanswered(*plan, answered) == 0) {
        fmt::print("{} has answered every trial already\n", participant);
        return reportSession(options, participant, 0);
    }

    std::vector<const studies::Trial*> trials;
    for (const auto& trial : plan->trials) trials.push_back(&trial);
    const fs::path stimuli_folder =
        options.stimuli.empty() ? stimuliFolder(options.database) : fs::path(options.stimuli);
    const auto stimuli = StimulusLibrary::load(*setup, trials, *avatar, stimuli_folder);
    if (!stimuli) return tl::unexpected(stimuli.error());

    std::optional<std::ofstream> trace_file;
    if (!options.trace.empty()) {
        auto opened = openTrace(options.trace);
        if (!opened) return tl::unexpected(opened.error());
        trace_file = std::move(*opened);
    }
    const auto station = openStation(options.station, setup->study, *plan, *avatar);
    if (!station) return tl::unexpected(station.error());
    const studies::StationInfo info = (*station)->info();
    if (store->hasSession(participant, !info.synthetic))
        return fail(options.database,
                    fmt::format("the answers of {} were begun by a {}; they are not mixed with a {}'s",
                                participant, info.synthetic ? "person" : "simulated participant",
                                info.synthetic ? "simulated participant" : "person"),
                    "Name another participant with --participant, or another database with --db");
    // Nothing is kept of a participant before all that the session needs is there.
    if (auto stored = store->storePlan(setup->study, *plan); !stored) return stored;
    fmt::print("participant {}: {} station ({}){}\n", participant, info.kind, info.details,
               answered.empty() ? "" : fmt::format(", {} answers kept from before", answered.size()));
    if (!info.controls.empty()) fmt::print("{}\n", info.controls);
    std::fflush(stdout);

    const motion::LocalPose idle = motion::relaxedPose(avatar->skeleton);
    const auto records = stimuli->records(*plan);
    studies::SessionRunner session(setup->study, *plan, *stimuli, avatar->skeleton, idle, answered);
    store->beginSession({participant, info, programVersion(), avatar->content_hash, utcNow_s()});
    try {
        // A simulated participant's virtual time can wait for the disk; a person's frames cannot. Gone before
        // the store is used again.
        std::unique_ptr<Recorder> recorder;
        if (info.synthetic)
            recorder = std::make_unique<DirectRecorder>(*store, *plan, records);
        else
            recorder = std::make_unique<BackgroundRecorder>(*store, *plan, records, *recording);
        std::optional<Trace> trace;
        if (trace_file) trace.emplace(std::move(*trace_file), session, *recorder);
        Recorder& told = trace ? static_cast<Recorder&>(*trace) : *recorder;
        runSession(session, **station, told);
        told.finish();
    } catch (const std::exception& error) {
        throw std::runtime_error(
            fmt::format("{}. All earlier answers are kept in {}; the same command with --participant {} goes "
                        "on after them",
                        error.what(), options.database, participant));
    }
    store->endSession(session.quit() ? "quit" : "finished", utcNow_s());
    auto reported =
        reportSession(options, participant, unanswered(*plan, store->answeredTrials(participant)));
    if (const auto why = (*station)->failure()) return tl::unexpected(*why);
    const Screenshots& pictures = *options.station.screenshots;
    if (reported && !pictures.wanted.empty())
        return fail("--screenshot",
                    fmt::format("the session was never in the state '{}'; it was in {}",
                                pictures.wanted.begin()->first, fmt::join(pictures.met, ", ")));
    return reported;
}

}  // namespace

void addRunCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = cli.add_subcommand("run", "Run one participant's session; resumes where it was left");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participant", options->participant,
                        "Pseudonymous id [the next free of P01, P02, ...]");
    command
        ->add_option(
            "--station", options->station.kind,
            "desktop: a window and a person; headset: a person in VR (OpenXR); simulated: a simulated "
            "participant, drawn off screen")
        ->check(CLI::IsMember({"desktop", "headset", "simulated"}))
        ->capture_default_str();
    command->add_option("--db", options->database, "Database to add to [STUDY.sqlite]");
    command->add_option("--report", options->report, "HTML report to write [beside the database]");
    command->add_option("--stimuli", options->stimuli,
                        "Folder for the built-in systems' clips [beside the database]");
    command->add_option("--size", options->station.size, "Window or picture size, such as 1280x720");
    command
        ->add_option("--resolution-scale", options->station.resolution_scale,
                     "Of the picture size that the headset's runtime recommends (headset)")
        ->check(CLI::Range(0.2, 3.0))
        ->capture_default_str();
    command->add_flag("--fullscreen", options->station.fullscreen, "Fill the screen (desktop)");
    command
        ->add_option("--parameters", options->station.simulated_parameters,
                     "Simulated participant's parameters (TOML)")
        ->default_val(assets::dataFile("simulated_participant.toml").string());
    command->add_option("--screenshot", options->screenshots,
                        "STATE=FILE.png: a picture of a state of the simulated session; may be repeated");
    command->add_option("--trace", options->trace,
                        "File to which a JSON line is added for each change of what is presented, while the "
                        "session runs");
    command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace deixis::app
