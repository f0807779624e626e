#include "assets/joint_positions.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/files.hpp"
#include "motion/reference_humanoid.hpp"
#include "motion/retarget.hpp"

namespace deixis::assets {

namespace {

using motion::Bone;

constexpr std::size_t joint_count = 25;
constexpr std::size_t field_count = 1 + 4 * joint_count;
constexpr double ticks_per_second = 1e7;
constexpr double frame_time_s = 1.0 / 30.0;

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

/// One joint over time; only moments at which it was tracked.
struct Track {
    std::vector<double> time_s;
    std::vector<Vec3> position;

    [[nodiscard]] Vec3 at(double t) const {
        const auto after = std::upper_bound(time_s.begin(), time_s.end(), t);
        if (after == time_s.begin()) return position.front();
        if (after == time_s.end()) return position.back();
        const auto i = static_cast<std::size_t>(after - time_s.begin());
        const double part = (t - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
        return position[i - 1] + (position[i] - position[i - 1]) * part;
    }

    /// Mean of the moments around t, weighted 1 2 3 2 1, three quarters of a frame apart.
    [[nodiscard]] Vec3 smoothAt(double t) const {
        constexpr std::array<double, 5> weight{1.0, 2.0, 3.0, 2.0, 1.0};
        Vec3 sum(0.0);
        for (std::size_t i = 0; i < 5; ++i)
            sum += weight[i] / 9.0 * at(t + (static_cast<double>(i) - 2.0) * 0.75 * frame_time_s);
        return sum;
    }
};

struct Recording {
    std::array<Track, joint_count> tracks;
    double first_s = 0.0;
    double last_s = 0.0;
};

Result<Recording> parseLines(std::string_view text, const std::string& name) {
    Recording recording;
    std::array<double, field_count> fields{};
    double previous_s = 0.0;
    bool any = false;
    for (int line = 1; !text.empty(); ++line) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!row.empty() && (row.back() == '\r' || row.back() == ' ' || row.back() == ','))
            row.remove_suffix(1);
        if (row.empty()) continue;
        const std::string where = name + ":" + std::to_string(line);
        std::size_t count = 0;
        for (const char* at = row.data();; ++at) {
            double value = 0.0;
            const auto [stop, problem] = std::from_chars(at, row.data() + row.size(), value);
            const bool ends = stop == row.data() + row.size();
            if (problem != std::errc{} || !std::isfinite(value) || (!ends && *stop != ','))
                return fail(where, "found no finite number in column " + std::to_string(count + 1) +
                                       ", expected time and x,y,z,state of 25 joints");
            if (count < field_count) fields[count] = value;
            ++count;
            at = stop;
            if (ends) break;
        }
        if (count != field_count)
            return fail(where, "found " + std::to_string(count) + " columns, expected " +
                                   std::to_string(field_count) + ": time and x,y,z,state of 25 joints");
        const double time_s = fields[0] / ticks_per_second;
        if (any && time_s <= previous_s)
            return fail(where, "found a time that is not after the one before, expected rising times");
        if (!any) recording.first_s = time_s;
        any = true;
        recording.last_s = previous_s = time_s;
        for (std::size_t j = 0; j < joint_count; ++j) {
            if (fields[4 + 4 * j] < 0.5) continue;
            recording.tracks[j].time_s.push_back(time_s);
            recording.tracks[j].position.emplace_back(fields[1 + 4 * j], fields[2 + 4 * j],
                                                      fields[3 + 4 * j]);
        }
    }
    if (!any) return fail(name, "found no lines, expected a Kinect recording");
    constexpr double longest_s = 3600.0;
    if (recording.last_s - recording.first_s > longest_s)
        return fail(name,
                    "found more than an hour between the first and the last time, expected times in "
                    "units of 100 ns");
    return recording;
}

}  // namespace

Result<motion::Clip> parseKinectClip(std::string_view text, const std::string& name) {
    const auto recording = parseLines(text, name);
    if (!recording) return tl::unexpected(recording.error());
    const int count =
        static_cast<int>(std::floor((recording->last_s - recording->first_s) / frame_time_s + 1e-6)) + 1;
    std::vector<motion::BonePositions> frames(static_cast<std::size_t>(count));
    for (int f = 0; f < count; ++f)
        for (const Used& u : used)
            if (const Track& track = recording->tracks[u.joint]; !track.position.empty())
                frames[static_cast<std::size_t>(f)][u.bone] =
                    track.smoothAt(recording->first_s + f * frame_time_s);
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    auto clip = motion::clipFromPositions(frames, frame_time_s, avatar, motion::mapByVrmNames(avatar));
    if (!clip) return fail(name, clip.error().message, clip.error().mend);
    return clip;
}

Result<motion::Clip> readKinectClip(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseKinectClip(*text, path.string());
}

}  // namespace deixis::assets
