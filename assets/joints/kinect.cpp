#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "assets/joints/joint_positions.hpp"
#include "number_lines.hpp"
#include "position_import.hpp"

namespace deixis::assets {

namespace {

using motion::Bone;

constexpr std::size_t kinect_joint_count = 25;
constexpr std::size_t field_count = 1 + 4 * kinect_joint_count;
constexpr double ticks_per_second = 1e7;
constexpr double kinect_fps = 30.0;
constexpr double smoothing_step_s = 0.75 / kinect_fps;

/// Joints that are used, by their number in Kinect's JointType. Kinect's Neck lies in the throat; the point
/// between the shoulders (20) is what the solver calls neck.
struct Used {
    std::size_t joint;
    Bone bone;
};
constexpr Used used[] = {{0, Bone::hips},           {20, Bone::neck},          {3, Bone::head},
                         {4, Bone::leftUpperArm},   {5, Bone::leftLowerArm},   {6, Bone::leftHand},
                         {8, Bone::rightUpperArm},  {9, Bone::rightLowerArm},  {10, Bone::rightHand},
                         {12, Bone::leftUpperLeg},  {13, Bone::leftLowerLeg},  {14, Bone::leftFoot},
                         {16, Bone::rightUpperLeg}, {17, Bone::rightLowerLeg}, {18, Bone::rightFoot}};

struct KinectRecording {
    std::array<JointTrack, kinect_joint_count> tracks;
    std::vector<double> times_s;  ///< of the lines
};

/// With `fps` lines follow each other at that rate, whatever times they tell.
Result<KinectRecording> parseLines(std::string_view text, const std::string& name,
                                   const std::optional<double>& fps) {
    KinectRecording recording;
    std::array<double, field_count> fields{};
    CsvReader reader(text, name, formOfNumbers(text));
    CsvRecord row;
    std::vector<std::string>& words = row.fields;
    for (;;) {
        const auto more = reader.next(row);
        if (!more) return tl::unexpected(more.error());
        if (!*more) break;
        const std::string where = name + ":" + std::to_string(row.line);
        while (!words.empty() && words.back().empty()) words.pop_back();
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto value = finiteNumber(words[i]);
            if (!value)
                return fail(where,
                            "found '" + words[i].substr(0, 40) + "' in column " + std::to_string(i + 1) +
                                ", expected a finite number: time and x,y,z,state of 25 joints",
                            hintOfNumber(words[i]));
            if (i < field_count) fields[i] = *value;
        }
        if (words.size() != field_count)
            return fail(where, "found " + std::to_string(words.size()) + " columns, expected " +
                                   std::to_string(field_count) + ": time and x,y,z,state of 25 joints");
        const double time_s =
            fps ? static_cast<double>(recording.times_s.size()) / *fps : fields[0] / ticks_per_second;
        if (!recording.times_s.empty() && time_s <= recording.times_s.back())
            return fail(where, "found a time that is not after the one before, expected increasing times");
        recording.times_s.push_back(time_s);
        for (std::size_t j = 0; j < kinect_joint_count; ++j) {
            if (fields[4 + 4 * j] < 0.5) continue;
            recording.tracks[j].time_s.push_back(time_s);
            recording.tracks[j].position.emplace_back(fields[1 + 4 * j], fields[2 + 4 * j],
                                                      fields[3 + 4 * j]);
        }
    }
    if (recording.times_s.empty()) return fail(name, "found no lines, expected a Kinect recording");
    return recording;
}

}  // namespace

Result<ImportedClip> parseKinectClip(std::string_view text, const std::string& name,
                                     const ImportOptions& options) {
    const auto recording = parseLines(text, name, options.fps);
    if (!recording) return tl::unexpected(recording.error());
    PositionRecording out;
    out.format = "Kinect v2 joint positions";
    out.unit = FoundUnit{};
    out.up = UpAxis::y;
    out.rate = options.fps ? FoundRate{*options.fps, Origin::given} : FoundRate{kinect_fps, Origin::declared};
    const double frame_time_s = 1.0 / out.rate.fps;
    const auto& times = recording->times_s;
    const auto count = framesOver(times, frame_time_s, name, out.remarks);
    if (!count) return tl::unexpected(count.error());
    if (times.size() > 1 && !options.fps)
        if (auto good =
                checkStep((times.back() - times.front()) / static_cast<double>(times.size() - 1), name,
                          "Kinect's times are in units of 100 ns; otherwise give the rate with --fps");
            !good)
            return tl::unexpected(good.error());
    out.frames.resize(*count);
    for (std::size_t f = 0; f < *count; ++f)
        for (const Used& u : used)
            if (const JointTrack& track = recording->tracks[u.joint]; !track.empty())
                out.frames[f][u.bone] =
                    track.smoothAt(times.front() + static_cast<double>(f) * frame_time_s, smoothing_step_s);
    return clipOfPositions(std::move(out), name, options);
}

}  // namespace deixis::assets
