// deixis clips segment: a continuous recording cut into pointing clips with a manifest.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/study/recorded_targets.hpp"
#include "assets/tables/manifest.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"
#include "motion/gestures/segmentation.hpp"
#include "motion/pointing/placement.hpp"
#include "motion/skeleton/clip_edit.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ClipsSegmentArguments {
    std::string recording;
    std::string folder;
    std::string by = "returns";
    std::string targets;
    std::string marker;
    std::string system = "recorded";
    std::optional<int> rest_frame;
    assets::ImportOptions import;
    double target_metres_per_unit = 1.0;
    bool split = false;
    bool force = false;
};

struct PointingClip {
    motion::Gesture gesture;
    Pose person_from_recording;  ///< at the clip's first frame
    assets::ManifestRow row;
};

/// A joint of the recording that marks the target.
Result<MarkerTrack> markerTrack(const motion::Clip& recording, const std::string& joint,
                                const std::string& file) {
    const int index = recording.skeleton.find(joint);
    if (index < 0)
        return fail(file, fmt::format("has no joint '{}' to mark the target", joint),
                    fmt::format("'deixis clips joints {}' lists its joints", file));
    MarkerTrack track;
    std::vector<Pose> world;
    for (int f = 0; f < recording.frameCount(); ++f) {
        motion::worldPose(recording.skeleton, recording.frames[static_cast<std::size_t>(f)], world);
        track.samples.push_back(
            {f * recording.frame_time_s, world[static_cast<std::size_t>(index)].position});
    }
    return track;
}

std::vector<PointingClip> clipsOf(const motion::Segmentation& segmentation, const MappedClip& source,
                                  const ClipsSegmentArguments& options) {
    std::vector<PointingClip> out;
    for (const motion::Gesture& g : segmentation.gestures) {
        PointingClip clip;
        clip.gesture = g;
        clip.person_from_recording = motion::figureFromClip(source.clip, source.map, g.first);
        clip.row.system = options.system;
        clip.row.target_id = fmt::format("G{:03}", out.size() + 1);
        clip.row.phases = g.phases;
        for (int* frame : {&clip.row.phases->onset_frame, &clip.row.phases->peak_frame,
                           &clip.row.phases->hold_frame, &clip.row.phases->end_frame})
            *frame -= g.first;
        clip.row.fps = source.clip.framesPerSecond();
        out.push_back(std::move(clip));
    }
    return out;
}

void attach(std::vector<PointingClip>& clips, const MarkerTrack& marker, double frame_time_s) {
    for (PointingClip& clip : clips) {
        motion::Gesture& g = clip.gesture;
        const auto seen = marker.median((g.phases.peak_frame - 0.5) * frame_time_s,
                                        (g.phases.hold_frame + 0.5) * frame_time_s);
        if (seen)
            clip.row.target = transformPoint(clip.person_from_recording, *seen);
        else
            g.remarks.emplace_back("the marker is hidden during the hold: no target");
    }
}

Result<void> attach(std::vector<PointingClip>& clips, const std::vector<assets::ListedTarget>& list,
                    const std::string& file) {
    if (list.size() != clips.size())
        return fail(
            file, fmt::format("lists {} targets, and {} gestures were found", list.size(), clips.size()),
            "Give one line for each gesture, in order; without -o and --targets the gestures are listed");
    for (std::size_t i = 0; i < clips.size(); ++i) {
        clips[i].row.target_id = list[i].id;
        clips[i].row.target = list[i].position;
    }
    return {};
}

Result<void> attachTargets(std::vector<PointingClip>& clips, const MappedClip& source,
                           const ClipsSegmentArguments& options) {
    const double frame_time_s = source.clip.frame_time_s;
    if (!options.marker.empty()) {
        const auto marker = markerTrack(source.clip, options.marker, options.recording);
        if (!marker) return tl::unexpected(marker.error());
        attach(clips, *marker, frame_time_s);
    } else if (!options.targets.empty()) {
        const auto targets =
            readRecordedTargets(options.targets, frame_time_s, options.target_metres_per_unit);
        if (!targets) return tl::unexpected(targets.error());
        if (const auto* list = std::get_if<std::vector<assets::ListedTarget>>(&*targets))
            return attach(clips, *list, options.targets);
        attach(clips, std::get<MarkerTrack>(*targets), frame_time_s);
    }
    return {};
}

void print(const motion::Segmentation& segmentation, const std::vector<PointingClip>& clips,
           double frame_time_s) {
    for (const auto& remark : segmentation.remarks) fmt::print("remark: {}\n", remark);
    if (!clips.empty())
        fmt::print("{:<12} {:<5} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>7} {:>8}\n", "id", "hand", "first",
                   "onset", "peak", "hold", "end", "last", "hold, s", "azimuth");
    for (const PointingClip& clip : clips) {
        const motion::Gesture& g = clip.gesture;
        const std::string azimuth =
            clip.row.target
                ? fmt::format("{:.1f}",
                              degreesFromRadians(std::atan2(clip.row.target->x, clip.row.target->z)))
                : "-";
        const motion::GesturePhases& p = g.phases;
        fmt::print("{:<12} {:<5} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} {:>7.2f} {:>8}", clip.row.target_id,
                   motion::sideName(p.hand), g.first, p.onset_frame, p.peak_frame, p.hold_frame, p.end_frame,
                   g.last, (p.hold_frame - p.peak_frame) * frame_time_s, azimuth);
        fmt::print("{}{}\n", g.remarks.empty() ? "" : "  ", fmt::join(g.remarks, "; "));
    }
    for (const motion::LeftOut& left : segmentation.left_out)
        fmt::print("left out: frames {} to {}, {} hand: {}\n", left.first, left.last,
                   motion::sideName(left.hand), left.why);
    fmt::print("{} gestures\n", clips.size());
}

/// Which of the folders of a split recording a clip goes to.
std::string part(const PointingClip& clip) {
    if (!clip.row.target) return "no-target";
    return motion::liesBehind(*clip.row.target) ? "back" : "front";
}

Result<void> write(const std::vector<PointingClip>& clips, const MappedClip& source,
                   const ClipsSegmentArguments& options) {
    OutputFolder folder(options.folder, options.force);
    std::map<fs::path, std::vector<assets::ManifestRow>> manifests;
    if (!options.split) manifests[{}] = {};
    for (const PointingClip& clip : clips) {
        const fs::path below = options.split ? part(clip) : "";
        const auto cut = motion::trimmed(source.clip, clip.gesture.first, clip.gesture.last);
        if (!cut) return tl::unexpected(cut.error());
        assets::ManifestRow row = clip.row;
        row.clip = fmt::format("{}_{}.bvh", row.system, row.target_id);
        const auto bytes = clipBytes(motion::moved(*cut, clip.person_from_recording), row.clip);
        if (!bytes) return tl::unexpected(bytes.error());
        if (auto added = folder.add(below / row.clip, *bytes); !added) return added;
        manifests[below].push_back(std::move(row));
    }
    for (const auto& [below, rows] : manifests)
        if (auto added = folder.add(below / "manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    for (const auto& [below, rows] : manifests)
        fmt::print("{} clips: {}\n", rows.size(),
                   (fs::path(options.folder) / below / "manifest.csv").string());
    return {};
}

Result<void> segment(const ClipsSegmentArguments& options) {
    if (options.system.empty() || options.system.front() == '.' ||
        options.system.find_first_of("/\\") != std::string::npos)
        return fail("--system", fmt::format("found '{}', expected a name that can be part of a file name",
                                            options.system));
    const auto source = readMappedClip(options.recording, options.import);
    if (!source) return tl::unexpected(source.error());
    motion::SegmentationOptions how;
    how.by = options.by == "holds" ? motion::CutBy::holds : motion::CutBy::returns;
    how.rest_frame = options.rest_frame;
    const auto segmentation = motion::segment(source->clip, source->map, how);
    if (!segmentation)
        return fail(options.recording, segmentation.error().message, segmentation.error().hint);
    std::vector<PointingClip> clips = clipsOf(*segmentation, *source, options);
    const auto attached = attachTargets(clips, *source, options);
    print(*segmentation, clips, source->clip.frame_time_s);
    if (!attached) return attached;
    if (options.folder.empty()) return {};
    if (clips.empty()) return fail(options.recording, "no gesture was found, so nothing is written");
    return write(clips, *source, options);
}

}  // namespace

void addClipsSegmentCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsSegmentArguments>();
    Parser command = clips.addCommand("segment", "Cut a recording into pointing clips");
    describe(
        command,
        {.writes =
             "nothing without -o; a BVH file for each gesture and manifest.csv to DIR, all of them or none.",
         .example = "deixis clips segment take3.bvh -o clips --targets targets.csv",
         .page = "docs/segmentation.md"});
    command.addOption("RECORDING", options->recording, "Recording of a person who points, y up").required();
    Option out = addOutput(command, options->folder,
                           "Folder for the clips and their manifest [they are only listed]", "DIR");
    command
        .addOption("--by", options->by,
                   "What ends a gesture: 'returns' (the hand goes back to rest) or 'holds' (each "
                   "straight-arm hold is one)")
        .check(OneOf{{"returns", "holds"}})
        .showDefault();
    Option targets =
        command.addOption("--targets", options->targets,
                          "CSV: target_id,x,y,z for each gesture in order (the avatar's axes), or a "
                          "marker's frame,x,y,z or time,x,y,z (the recording's axes)");
    command
        .addOption("--target-metres-per-unit", options->target_metres_per_unit,
                   "Length in metres of the unit of a marker in --targets")
        .needs(targets)
        .check(Above{})
        .showDefault();
    command.addOption("--marker", options->marker, "Joint of the recording that marks the target")
        .excludes(targets);
    command.addOption("--rest", options->rest_frame, "A frame in which both hands are at rest [found]")
        .check(FromZero{});
    command.addOption("--system", options->system, "Name of the system in the manifest").showDefault();
    command
        .addFlag("--split", options->split, "Make folders front, back and no-target, each with its manifest")
        .needs(out);
    addImportOptions(command, options->import);
    addForce(command, options->force).needs(out);
    command.callback([options, &chosen] { chosen = [options] { return segment(*options); }; });
}

}  // namespace deixis::app
