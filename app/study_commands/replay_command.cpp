// deixis replay: what a participant saw and did, from what was recorded.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "app/study/recorded_avatar.hpp"
#include "app/study/recorded_clips.hpp"
#include "app/study_commands/study_commands.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "results/store/recording.hpp"
#include "studies/session/replay.hpp"

#ifdef DEIXIS_IMMERSIVE
#include "app/viewer/replay_viewer.hpp"
#endif

namespace deixis::app {

namespace {

struct ReplayArguments {
    std::string database;
    std::string participant;
    int trial = -1;
    bool list = false;
    bool choices = false;
    std::string stimuli;
    std::string avatar;
#ifdef DEIXIS_IMMERSIVE
    ReplayOptions view;
    bool force = false;
#endif
};

void printList(const results::Recording& recording) {
    for (const results::RecordedAnswer& answer : recording.answers) {
        const studies::Trial& trial = answer.trial.trial;
        std::string shown;
        for (const studies::Stimulus& stimulus : trial.stimuli)
            shown += fmt::format("{}{} {}", shown.empty() ? "" : ", ", stimulus.system, stimulus.item);
        fmt::print("trial {:>3}  session {}  {}{}  {}  [{}]  {} frames{}\n", trial.index, answer.session,
                   trial.stage, trial.practice ? " (practice)" : "", answer.outcome, shown,
                   answer.trial.tracking.size(), answer.superseded ? "  (done again: does not count)" : "");
    }
}

std::string placeInWords(int place) {
    return place < 0 ? "none" : fmt::format("ball {}", place + 1);
}

// The pointing ray of the frame nearest to the answer, as it was tracked.
std::optional<Ray> trackedRay(const studies::RecordedTrial& trial, const studies::ClipSource& clips,
                              const assets::Avatar& avatar, const motion::LocalPose& idle) {
    const auto nearest =
        std::min_element(trial.tracking.begin(), trial.tracking.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.display_time_s - trial.answered_s) <
                   std::abs(b.display_time_s - trial.answered_s);
        });
    if (nearest == trial.tracking.end()) return std::nullopt;
    return studies::TrialReplay(trial, clips, avatar.skeleton, idle).pointer(nearest->display_time_s);
}

// Each choice of the game once more, from the rays alone.
Result<void> printChoices(const results::Recording& recording, const studies::ClipSource& clips,
                          const assets::Avatar& avatar) {
    const motion::LocalPose idle = motion::relaxedPose(avatar.skeleton);
    int choices = 0, same = 0, tracked = 0, tracked_same = 0;
    for (const results::RecordedAnswer& answer : recording.answers) {
        const studies::RecordedTrial& trial = answer.trial;
        if (trial.chosenPlace() < 0 || !trial.pointer) continue;
        ++choices;
        const int by_ray = studies::ballMetBy(trial, *trial.pointer);
        same += by_ray == trial.chosenPlace();
        std::string also;
        if (const auto ray = trackedRay(trial, clips, avatar, idle)) {
            ++tracked;
            const int by_tracking = studies::ballMetBy(trial, *ray);
            tracked_same += by_tracking == trial.chosenPlace();
            also = fmt::format(", by the tracked hand {}", placeInWords(by_tracking));
        }
        fmt::print("trial {:>3}: chose {}, by the ray kept with the answer {}{}\n", trial.trial.index,
                   placeInWords(trial.chosenPlace()), placeInWords(by_ray), also);
    }
    fmt::print("{} choices: {} the same from the ray kept with the answer; {} of {} from the tracked hand\n",
               choices, same, tracked_same, tracked);
    if (same != choices)
        return fail(recording.participant, "some choices are not those that the recorded rays give");
    return {};
}

Result<void> replay(ReplayArguments options) {
#ifdef DEIXIS_IMMERSIVE
    if (auto free = checkFolderFree(options.view.png_folder, {".png"}, options.force); !free) return free;
    if (auto free = checkFree(options.view.mp4_file, options.force); !free) return free;
#endif
    auto recording = results::loadRecording(options.database, options.participant);
    if (!recording) return tl::unexpected(recording.error());
    if (options.trial >= 0) {
        std::erase_if(recording->answers, [&](const results::RecordedAnswer& answer) {
            return answer.trial.trial.index != options.trial;
        });
        if (recording->answers.empty())
            return fail(options.database,
                        fmt::format("{} has answered no trial {} that shows clips", options.participant,
                                    options.trial),
                        "--list prints those that there are");
    }
    if (options.list) {
        printList(*recording);
        return {};
    }
    if (recording->answers.empty())
        return fail(options.database,
                    fmt::format("{} has answered no trial that shows clips", options.participant));
    results::ClipRecords records;
    for (const auto& answer : recording->answers) records.insert(answer.clips.begin(), answer.clips.end());
    const auto avatar = recordedAvatar(shownAvatar(*recording), options.database, options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    const auto clips = RecordedClips::load(records, *avatar, options.stimuli, options.database);
    if (!clips) return tl::unexpected(clips.error());
    if (options.choices) return printChoices(*recording, *clips, *avatar);
#ifdef DEIXIS_IMMERSIVE
    return showReplay(*recording, *clips, *avatar, options.view);
#else
    return fail("replay", "this program was built without windows (DEIXIS_IMMERSIVE=OFF)",
                "--list and --choices need none");
#endif
}

}  // namespace

void addReplayCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<ReplayArguments>();
    Parser command = cli.addCommand("replay", "Show again what a participant saw and did");
    describe(command, {.writes = "nothing, unless --png or --mp4 name a place.",
                       .example = "deixis replay study.sqlite --participant P07 --list\ndeixis replay "
                                  "study.sqlite --participant P07 --trial 12 --mp4 trial.mp4",
                       .page = "docs/running-a-study.md"});
    command.addOption("DB", options->database, "Database of a study").required();
    command.addOption("--participant", options->participant, "Pseudonymous id").required();
    command.addOption("--trial", options->trial, "Only this trial, by its index [all]");
    command.addFlag("--list", options->list, "Print the trials and what was answered");
    command.addFlag("--choices", options->choices,
                    "Print each choice of the game and what the recorded rays give");
    command.addOption(
        "--stimuli", options->stimuli,
        "Folder of the clips that were shown [what is locked beside the database; else where they lay]");
    command.addOption("--avatar", options->avatar,
                      "The avatar that was shown, glTF or VRM [the one locked beside the database; else the "
                      "study's, from the database's folder on, or Deixis's own]");
#ifdef DEIXIS_IMMERSIVE
    command.addOption("--view", options->view.view, "first: by the participant's eyes; third: from outside")
        .check(OneOf{{"first", "third"}})
        .showDefault();
    command.addOption("--png", options->view.png_folder,
                      "Write each frame as a PNG into a folder; no window");
    command.addOption("--mp4", options->view.mp4_file, "Write a film (needs ffmpeg); no window");
    addForce(command, options->force);
    command.addOption("--fps", options->view.frames_per_s, "Frames a second of what is written")
        .check(Range(1.0, 240.0))
        .showDefault();
    command.addOption("--speed", options->view.speed, "1: as it was; 0.25: four times as long")
        .check(Range(0.05, 8.0))
        .showDefault();
    command.addOption("--trail", options->view.trail_s, "Seconds of the way of head and hand that are shown")
        .check(Range(0.0, 60.0))
        .showDefault();
    command.addOption("--size", options->view.size, "Window or picture size").showDefault();
#endif
    command.callback([options, &chosen] { chosen = [options] { return replay(*options); }; });
}

}  // namespace deixis::app
