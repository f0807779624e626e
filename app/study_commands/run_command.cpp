// deixis run: one participant's session, from the first page to the report.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/analysis_commands/report.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/version.hpp"
#include "app/program/written_output.hpp"
#include "app/session/operator_feed.hpp"
#include "app/session/recorders.hpp"
#include "app/session/session_loop.hpp"
#include "app/session/trace.hpp"
#include "app/session/work_in_progress.hpp"
#include "app/stations/simulated_setup.hpp"
#include "app/stations/stations.hpp"
#include "app/study/enrolment.hpp"
#include "app/study/stimuli.hpp"
#include "app/study/study_under_way.hpp"
#include "app/study_commands/study_commands.hpp"
#include "assets/data/data_paths.hpp"
#include "core/text.hpp"
#include "core/utc.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "results/participants/participants.hpp"
#include "results/store/participant_lock.hpp"
#include "results/store/store.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
    std::string study;
    std::string participant;
    std::optional<int> number;
    std::string language;
    std::string database;
    std::string report;
    std::string stimuli;
    std::string accept_changes;
    std::vector<std::string> screenshots;
    bool force = false;
    std::string trace;
    StationRequest station;
};

struct Seat {
    std::string participant;
    results::ParticipantLock lock;
};

// Who takes part, with the lock that keeps others from the id: the participant named, or the first of P01,
// P02, ... whom the database does not know and no other process has.
Result<Seat> takeSeat(const RunArguments& options, const results::Store& store) {
    if (!options.participant.empty()) {
        auto lock = results::ParticipantLock::take(options.database, options.participant);
        if (!lock) return tl::unexpected(lock.error());
        return Seat{options.participant, std::move(*lock)};
    }
    for (int i = 1;; ++i) {
        const std::string id = fmt::format("P{:02}", i);
        if (store.registration(id)) continue;
        auto lock = results::ParticipantLock::tryTake(options.database, id);
        if (!lock) return tl::unexpected(lock.error());
        // Who had the lock until now may have registered.
        if (*lock && !store.registration(id)) return Seat{id, std::move(**lock)};
    }
}

// STATE=FILE ...
Result<std::map<std::string, std::string>> parseScreenshots(const std::vector<std::string>& options) {
    std::map<std::string, std::string> out;
    for (const std::string& option : options) {
        const auto wanted = nameAndValue(option);
        if (!wanted)
            return fail("--screenshot", fmt::format("'{}' was given; expected STATE=FILE.png", option));
        const auto& [state, file] = *wanted;
        out[state == "listening" ? "watching" : state] = file;  // its earlier name
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
                    "{} has finished this visit; {} trials are left for the next one, which the same command "
                    "with --participant {} begins\n",
                    participant, left, participant);
            return;
        case studies::SessionOutcome::quit:
        case studies::SessionOutcome::running:
            if (left > 0)
                fmt::print("{} has {} trials left; the same command with --participant {} continues there\n",
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

// The database asked for; else one named after the study.
Result<std::string> databaseFor(const RunArguments& options) {
    std::error_code code;
    const bool there = fs::exists(options.database, code);
    if (there) return options.database;
    if (options.study.empty())
        return fail(options.database, "no such database",
                    fmt::format("'deixis run STUDY --db {}' begins a study", options.database));
    // No database is begun for a study that has a mistake.
    const auto setup = loadStudySetup(options.study, options.language);
    if (!setup) return tl::unexpected(setup.error());
    return options.database.empty() ? setup->study.name + ".sqlite" : options.database;
}

// Whoever left the study is not asked again by mistake.
Result<void> checkTakesPart(const RunArguments& options, const results::Store& store,
                            const std::string& participant) {
    if (!store.registration(participant)) return {};
    const auto known = results::showParticipant(options.database, participant);
    if (!known) return tl::unexpected(known.error());
    if (results::mayTakePart(known->row)) return {};
    const bool declined = known->row.consent == results::Consent::declined;
    return fail(
        options.database,
        fmt::format("{} {} ({})", participant,
                    known->row.status == results::ParticipantStatus::excluded ? "is excluded" : "dropped out",
                    known->row.reason),
        fmt::format("'deixis participants include {} {}' lets the participant {}", options.database,
                    participant, declined ? "be asked for consent again" : "go on"));
}

// That every stage can be done at such a station.
Result<void> checkStages(const studies::Study& study, studies::StationKind station) {
    if (station == studies::StationKind::simulated) return {};
    const bool studio = station == studies::StationKind::studio;
    for (const studies::Stage& stage : study.stages) {
        const auto& kind = studies::declarationOf(stage.kind);
        if (!kind.showsClips() || kind.in_studio == studio) continue;
        return fail("--station",
                    fmt::format("found {}, but stage \"{}\" of kind \"{}\" {}",
                                studies::stationKindName(station), stage.name, kind.name,
                                studio ? "shows clips, which the studio's page does not"
                                       : "is done in the studio's page"),
                    studio ? "Use --station desktop or headset" : "Use --station studio");
    }
    return {};
}

struct Prepared {
    LockedStudy locked;
    Enrolment enrolment;
    assets::Avatar avatar;
    StimulusLibrary stimuli;
};

// The session itself: the station's frames, until it has an outcome.
Result<void> runOn(const RunArguments& options, Prepared& prepared, results::Store& store,
                   std::optional<std::ofstream> trace_file, const results::RecordingOptions& recording) {
    auto& [locked, enrolment, avatar, stimuli] = prepared;
    const StudySetup& setup = locked.setup;
    const std::string& participant = enrolment.registration.participant;
    const auto feed = std::make_shared<OperatorFeed>();
    StationRequest request = options.station;
    request.operator_feed = feed;
    request.sounds = stimuli.sounds();
    const auto station = openStation(request, setup.study, enrolment.plan, avatar);
    if (!station) return tl::unexpected(station.error());
    const studies::StationInfo info = (*station)->info();
    if (store.hasSession(participant, !info.synthetic))
        return fail(options.database,
                    fmt::format("the answers of {} were begun by a {} and are not mixed with a {}'s",
                                participant, info.synthetic ? "person" : "simulated participant",
                                info.synthetic ? "simulated participant" : "person"),
                    "Name another participant with --participant, or another database with --db");
    // Nothing is kept of a participant before all that the session needs is there.
    const auto drawn_anew = storeEnrolment(setup, locked.hash, store, enrolment, options.number, utcNow_s());
    if (!drawn_anew) return tl::unexpected(drawn_anew.error());
    if (*drawn_anew) {
        auto others = StimulusLibrary::load(locked, {enrolment.plan}, avatar);
        if (!others) return tl::unexpected(others.error());
        stimuli = std::move(*others);
    }
    fmt::print("participant {}: {} station ({}){}\n", participant, studies::stationKindName(info.kind),
               info.details,
               enrolment.resume.answered.empty()
                   ? ""
                   : fmt::format(", {} trials and pages answered before", enrolment.resume.answered.size()));
    if (!info.controls.empty()) fmt::print("{}\n", info.controls);
    std::fflush(stdout);

    auto unfinished = readUnfinishedWork(results::workFile(options.database, participant), enrolment.resume);
    if (!unfinished) return tl::unexpected(unfinished.error());
    enrolment.resume.work = std::move(*unfinished);

    const motion::LocalPose idle = motion::relaxedPose(avatar.skeleton);
    const auto records = stimuli.records();
    const auto history = store.secondsPerUnit();
    const bool in_headset = info.kind == studies::StationKind::headset;
    const studies::Study stood = studies::standingAs(
        setup.study, in_headset ? studies::Standing::headset : studies::Standing::desktop);
    studies::SessionRunner session(stood, enrolment.plan, stimuli, avatar.skeleton, idle, enrolment.resume,
                                   !in_headset, info.hint);
    store.beginSession({participant, withProgram(info), programVersion(), avatar.content_hash, utcNow_s()});
    try {
        // A simulated participant's virtual time can wait for the disk; a person's frames cannot. Gone before
        // the store is used again.
        std::unique_ptr<Recorder> recorder;
        if (info.synthetic)
            recorder = std::make_unique<DirectRecorder>(store, setup.study, enrolment.plan, records);
        else
            recorder =
                std::make_unique<BackgroundRecorder>(store, setup.study, enrolment.plan, records, recording);
        FailSafeRecorder calm(*recorder);
        OperatorFeedWriter for_operator(
            feed, participant, setup.study, [&session] { return session.progress(); }, history,
            options.database, calm);
        std::optional<Trace> trace;
        if (trace_file) trace.emplace(std::move(*trace_file), session, for_operator);
        Recorder& looked_at = trace ? static_cast<Recorder&>(*trace) : for_operator;
        std::optional<WorkInProgress> work;
        if (!info.synthetic)
            work.emplace(results::workFile(options.database, participant), session, looked_at);
        Recorder& told = work ? static_cast<Recorder&>(*work) : looked_at;
        runSession(session, **station, told);
        told.finish();
    } catch (const results::DatabaseMoved& moved) {
        throw std::runtime_error(fmt::format(
            "{}. After that the same command with --participant {} continues", moved.what(), participant));
    } catch (const std::exception& error) {
        throw std::runtime_error(
            fmt::format("{}. All earlier answers are kept in {}; the same command with --participant {} "
                        "continues after them",
                        error.what(), options.database, participant));
    }
    store.endSession(session.outcome(), utcNow_s());
    const auto left =
        studies::trialsLeft(setup.study, enrolment.plan, store.resume(participant, utcNow_s()).answered);
    tellOutcome(participant, session.outcome(), left.size());
    auto reported = report(options);
    if (const auto why = (*station)->failure())
        return fail(fmt::format("{}: {}: {}", setup.study.file.string(), participant, why->where),
                    why->message, why->hint);
    const Screenshots& pictures = *options.station.screenshots;
    if (reported && !pictures.wanted.empty())
        return fail("--screenshot",
                    fmt::format("the session was never in the state '{}'; it was in {}",
                                pictures.wanted.begin()->first, fmt::join(pictures.met, ", ")));
    return reported;
}

Result<void> run(RunArguments options) {
    auto screenshots = parseScreenshots(options.screenshots);
    if (!screenshots) return tl::unexpected(screenshots.error());
    for (const auto& [state, picture] : *screenshots)
        if (auto free = checkFree(picture, options.force); !free) return free;
    options.station.screenshots->wanted = std::move(*screenshots);
    auto database = databaseFor(options);
    if (!database) return tl::unexpected(database.error());
    options.database = std::move(*database);
    const auto recording = recordingOptions();
    if (!recording) return tl::unexpected(recording.error());

    if (!options.participant.empty())
        if (auto id = studies::checkParticipantId(options.participant); !id) return id;
    auto store = results::Store::open(options.database, results::Durability::each_answer);
    if (!store) return tl::unexpected(store.error());
    const auto seat = takeSeat(options, *store);
    if (!seat) return tl::unexpected(seat.error());
    const std::string& participant = seat->participant;
    if (auto takes_part = checkTakesPart(options, *store, participant); !takes_part) return takes_part;
    const fs::path made =
        options.stimuli.empty() ? stimuliFolder(options.database) : fs::path(options.stimuli);
    auto locked = studyUnderWay(
        {options.study, options.database, made, participant, options.language, options.accept_changes},
        *store);
    if (!locked) return tl::unexpected(locked.error());
    if (auto can = checkStages(locked->setup.study, options.station.kind); !can) return can;
    auto avatar = loadStudyAvatar(locked->setup.study);
    if (!avatar) return tl::unexpected(avatar.error());
    auto enrolment = enrol(locked->setup, *store, participant, options.number, utcNow_s());
    if (!enrolment) return tl::unexpected(enrolment.error());
    if (enrolment->left.empty()) {
        fmt::print("{} has answered every trial already\n", participant);
        return report(options);
    }

    auto stimuli = StimulusLibrary::load(*locked, {enrolment->plan}, *avatar);
    if (!stimuli) return tl::unexpected(stimuli.error());

    std::optional<std::ofstream> trace_file;
    if (!options.trace.empty()) {
        auto opened = openTrace(options.trace);
        if (!opened) return tl::unexpected(opened.error());
        trace_file = std::move(*opened);
    }
    Prepared prepared{std::move(*locked), std::move(*enrolment), std::move(*avatar), std::move(*stimuli)};
    return runOn(options, prepared, *store, std::move(trace_file), *recording);
}

}  // namespace

void addRunCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<RunArguments>();
    Parser command = cli.addCommand("run", "Run one participant's session, or resume it where it stopped");
    describe(command,
             {.writes = "every answer to DATABASE as it is given; beside it DATABASE.locked, stimuli and the "
                        "report (default: STUDY.sqlite and STUDY.html in this folder).",
              .example = "deixis run pointing2023 --participant P07 --db study.sqlite",
              .page = "docs/running-a-study.md"});
    command.addOption("STUDY", options->study,
                      "Study file, or the name of one included [with --db: the study in the database]");
    command.addOption("--participant", options->participant,
                      "Pseudonymous id [the next free of P01, P02, ...]");
    command
        .addOption("--number", options->number,
                   "Number of a new participant, which determines the order of trials [the digits at the end "
                   "of the id, or the next free one]")
        .check(Range(1, 999999));
    addLanguage(command, options->language);
    command
        .addTextOption(
            "--station",
            [kind = &options->station.kind](const std::string& name) {
                *kind = studies::stationKindNamed(name).value();
            },
            "desktop: a window and a person; headset: a person in VR (OpenXR); studio: a person in the "
            "browser, "
            "who makes gestures; simulated: a simulated participant, without a window")
        .check(OneOf{{"desktop", "headset", "studio", "simulated"}})
        .showDefault("desktop");
    command.addOption("--db", options->database, "Database to create or to continue [STUDY.sqlite]");
    command
        .addOption("--accept-changes", options->accept_changes,
                   "Why the study's files were changed since it began; the reason is recorded, and new "
                   "participants get the new files")
        .check([](const std::string& reason) {
            return trimmed(reason).empty() ? "needs a reason in words" : std::string();
        });
    command.addOption("--report", options->report, "HTML report to write [beside the database]");
    command.addOption("--stimuli", options->stimuli,
                      "Folder for the built-in systems' clips [beside the database]");
    command.addOption("--size", options->station.size, "Window or picture size, such as 1280x720");
    command
        .addOption("--resolution-scale", options->station.resolution_scale,
                   "Scale of the picture size that the headset's runtime recommends (headset)")
        .check(Range(0.2, 3.0))
        .showDefault();
    command.addFlag("--operator", options->station.operator_window,
                    "Open the experimenter's window, on a second monitor or beside the participant's "
                    "(desktop; always open with a headset)");
    command.addFlag("--fullscreen", options->station.fullscreen, "Fill the screen (desktop)");
    command.addOption("--port", options->station.port, "Port of the page; 0: a free one (studio)")
        .check(Range(0, 65535))
        .showDefault();
    command.addFlag("--no-browser", options->station.no_browser,
                    "Open no browser; print the address alone (studio)");
    command
        .addOption("--parameters", options->station.simulated_parameters,
                   "Simulated participant's parameters (TOML) [the default ones]")
        .defaultValue(assets::dataFile("simulated_participant.toml").string())
        .showDefault("");
    command
        .addOption("--screenshot", options->screenshots,
                   "Write a picture of a state of the simulated session; may be repeated")
        .valueName("STATE=FILE.png");
    addForce(command, options->force, "pictures that are");
    command.addOption(
        "--trace", options->trace,
        "File that gets a JSON line for each change in what is presented, while the session runs");
    command.callback([options, &chosen] {
        if (options->study.empty() && options->database.empty())
            rejectUsage("run", "Give STUDY, or the database of a running study with --db");
        chosen = [options] { return run(*options); };
    });
}

}  // namespace deixis::app
