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
#include "enrolment.hpp"
#include "motion/reference_humanoid.hpp"
#include "operator_feed.hpp"
#include "recorders.hpp"
#include "report.hpp"
#include "results/participants.hpp"
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

struct RunArguments {
    std::string study;
    std::string participant;
    std::string language;
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

// What the session came to.
void tellOutcome(const std::string& participant, studies::SessionOutcome outcome, std::size_t left) {
    switch (outcome) {
        case studies::SessionOutcome::declined:
            fmt::print("{} did not agree to take part; the session ended there\n", participant);
            return;
        case studies::SessionOutcome::excluded:
            fmt::print("{} was excluded, and the session ended there; the event log says why\n", participant);
            return;
        case studies::SessionOutcome::aborted:
            fmt::print("{} dropped out: the session was aborted\n", participant);
            return;
        case studies::SessionOutcome::finished:
            if (left > 0)
                fmt::print(
                    "{} has finished this sitting; {} trials wait for the next one, which the same command "
                    "with --participant {} begins\n",
                    participant, left, participant);
            return;
        case studies::SessionOutcome::quit:
        case studies::SessionOutcome::running:
            if (left > 0)
                fmt::print("{} has {} trials left; the same command with --participant {} goes on there\n",
                           participant, left, participant);
    }
}

// Where what was answered lies, and the report on it.
Result<void> report(const RunArguments& options) {
    const std::string page = options.report.empty()
                                 ? fs::path(options.database).replace_extension(".html").string()
                                 : options.report;
    const auto written = writeReport({options.database}, {.page = page});
    fmt::print("database: {}\n", fs::absolute(options.database).lexically_normal().string());
    if (!written) {
        if (!options.report.empty()) return written;
        fmt::print("report:   none yet ({})\n", written.error().text());
        return {};
    }
    fmt::print("report:   {}\n", fs::absolute(page).lexically_normal().string());
    return {};
}

// In the language asked for, or that of somebody who has been here before.
Result<StudySetup> setupFor(const RunArguments& options, const results::Store& store,
                            const std::string& participant, StudySetup setup) {
    const auto registered = store.registration(participant);
    if (!registered || registered->language == setup.study.language) return setup;
    if (!options.language.empty())
        return fail(options.database,
                    fmt::format("{} takes part in the language '{}'; found --language {}", participant,
                                registered->language, options.language),
                    "Leave --language out");
    return loadStudySetup(options.study, registered->language);
}

// Whoever left the study is not asked again by mistake.
Result<void> checkTakesPart(const RunArguments& options, const results::Store& store,
                            const std::string& participant) {
    if (!store.registration(participant)) return {};
    const auto known = results::showParticipant(options.database, participant);
    if (!known) return tl::unexpected(known.error());
    if (known->row.status == "active") return {};
    return fail(
        options.database,
        fmt::format("{} {} ({})", participant,
                    known->row.status == "excluded" ? "is excluded" : "dropped out", known->row.reason),
        fmt::format("'deixis participants include {} {}' lets the participant go on", options.database,
                    participant));
}

struct Prepared {
    StudySetup setup;
    Enrolment enrolment;
    assets::Avatar avatar;
    StimulusLibrary stimuli;
};

// The session itself: the station's frames, until it has an outcome.
Result<void> runOn(const RunArguments& options, const Prepared& prepared, results::Store& store,
                   std::optional<std::ofstream> trace_file, const results::RecordingOptions& recording) {
    const auto& [setup, enrolment, avatar, stimuli] = prepared;
    const std::string& participant = enrolment.registration.participant;
    const auto feed = std::make_shared<OperatorFeed>();
    StationRequest request = options.station;
    request.operator_feed = feed;
    const auto station = openStation(request, setup.study, enrolment.plan, avatar);
    if (!station) return tl::unexpected(station.error());
    const studies::StationInfo info = (*station)->info();
    if (store.hasSession(participant, !info.synthetic))
        return fail(options.database,
                    fmt::format("the answers of {} were begun by a {}; they are not mixed with a {}'s",
                                participant, info.synthetic ? "person" : "simulated participant",
                                info.synthetic ? "simulated participant" : "person"),
                    "Name another participant with --participant, or another database with --db");
    // Nothing is kept of a participant before all that the session needs is there.
    if (auto stored = store.storePlan(setup.study, enrolment.registration, enrolment.plan); !stored)
        return stored;
    fmt::print("participant {}: {} station ({}){}\n", participant, info.kind, info.details,
               enrolment.resume.answered.empty()
                   ? ""
                   : fmt::format(", {} answers kept from before", enrolment.resume.answered.size()));
    if (!info.controls.empty()) fmt::print("{}\n", info.controls);
    std::fflush(stdout);

    const motion::LocalPose idle = motion::relaxedPose(avatar.skeleton);
    const auto records = stimuli.records();
    const auto history = store.secondsPerUnit();
    const bool keyboard = info.kind != "headset";
    studies::SessionRunner session(setup.study, enrolment.plan, stimuli, avatar.skeleton, idle,
                                   enrolment.resume, keyboard, info.hint);
    store.beginSession({participant, info, programVersion(), avatar.content_hash, utcNow_s()});
    try {
        // A simulated participant's virtual time can wait for the disk; a person's frames cannot. Gone before
        // the store is used again.
        std::unique_ptr<Recorder> recorder;
        if (info.synthetic)
            recorder = std::make_unique<DirectRecorder>(store, setup.study, enrolment.plan, records);
        else
            recorder =
                std::make_unique<BackgroundRecorder>(store, setup.study, enrolment.plan, records, recording);
        OperatorFeedWriter for_operator(
            feed, participant, setup.study, [&session] { return session.progress(); }, history,
            options.database, *recorder);
        std::optional<Trace> trace;
        if (trace_file) trace.emplace(std::move(*trace_file), session, for_operator);
        Recorder& told = trace ? static_cast<Recorder&>(*trace) : for_operator;
        runSession(session, **station, told);
        told.finish();
    } catch (const std::exception& error) {
        throw std::runtime_error(
            fmt::format("{}. All earlier answers are kept in {}; the same command with --participant {} goes "
                        "on after them",
                        error.what(), options.database, participant));
    }
    store.endSession(session.outcome(), utcNow_s());
    const auto left =
        studies::trialsLeft(setup.study, enrolment.plan, store.resume(participant, utcNow_s()).answered);
    tellOutcome(participant, session.outcome(), left.size());
    auto reported = report(options);
    if (const auto why = (*station)->failure())
        return fail(fmt::format("{}: {}: {}", setup.study.file.string(), participant, why->where),
                    why->message, why->mend);
    const Screenshots& pictures = *options.station.screenshots;
    if (reported && !pictures.wanted.empty())
        return fail("--screenshot",
                    fmt::format("the session was never in the state '{}'; it was in {}",
                                pictures.wanted.begin()->first, fmt::join(pictures.met, ", ")));
    return reported;
}

Result<void> run(RunArguments options) {
    auto setup = loadStudySetup(options.study, options.language);
    if (!setup) return tl::unexpected(setup.error());
    auto screenshots = parseScreenshots(options.screenshots);
    if (!screenshots) return tl::unexpected(screenshots.error());
    options.station.screenshots->wanted = std::move(*screenshots);
    if (options.database.empty()) options.database = setup->study.name + ".sqlite";
    const auto recording = recordingOptions();
    if (!recording) return tl::unexpected(recording.error());

    auto store = results::Store::open(options.database, results::Durability::each_answer);
    if (!store) return tl::unexpected(store.error());
    const std::string participant =
        options.participant.empty() ? nextParticipant(*store) : options.participant;
    setup = setupFor(options, *store, participant, std::move(*setup));
    if (!setup) return tl::unexpected(setup.error());
    auto avatar = loadStudyAvatar(setup->study);
    if (!avatar) return tl::unexpected(avatar.error());
    if (auto takes_part = checkTakesPart(options, *store, participant); !takes_part) return takes_part;
    const auto lock = results::ParticipantLock::take(options.database, participant);
    if (!lock) return tl::unexpected(lock.error());
    auto enrolment = enrol(*setup, *store, participant, utcNow_s());
    if (!enrolment) return tl::unexpected(enrolment.error());
    if (enrolment->left.empty()) {
        fmt::print("{} has answered every trial already\n", participant);
        return report(options);
    }

    const fs::path stimuli_folder =
        options.stimuli.empty() ? stimuliFolder(options.database) : fs::path(options.stimuli);
    auto stimuli = StimulusLibrary::load(*setup, {enrolment->plan}, *avatar, stimuli_folder);
    if (!stimuli) return tl::unexpected(stimuli.error());

    std::optional<std::ofstream> trace_file;
    if (!options.trace.empty()) {
        auto opened = openTrace(options.trace);
        if (!opened) return tl::unexpected(opened.error());
        trace_file = std::move(*opened);
    }
    const Prepared prepared{std::move(*setup), std::move(*enrolment), std::move(*avatar),
                            std::move(*stimuli)};
    return runOn(options, prepared, *store, std::move(trace_file), *recording);
}

}  // namespace

void addRunCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<RunArguments>();
    CLI::App* command = cli.add_subcommand("run", "Run one participant's session; resumes where it was left");
    command->add_option("STUDY", options->study, "Study file, or the name of one that ships")->required();
    command->add_option("--participant", options->participant,
                        "Pseudonymous id [the next free of P01, P02, ...]");
    command->add_option("--language", options->language,
                        "Language of the participant's texts, such as de [the study's first]");
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
    command->add_flag(
        "--operator", options->station.operator_window,
        "The experimenter's window, on a second monitor or beside the participant's (desktop; a "
        "headset has it always)");
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
