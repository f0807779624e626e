#include "app/clips/measured_clips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <optional>

#include "app/clips/clip_files.hpp"
#include "core/hash.hpp"
#include "core/parallel.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/pointing/placement.hpp"
#include "motion/pointing/rays.hpp"

namespace deixis::app {

namespace {

using motion::ArmTrack;
using motion::Side;

/// The arm's lines over the hold.
studies::ArmLines linesOf(const motion::Clip& clip, const motion::HumanoidMap& map, Side side,
                          const std::vector<std::vector<Pose>>& world, int first, int last) {
    std::vector<studies::ArmLines> frames;
    for (int frame = first; frame <= last; ++frame)
        frames.push_back(
            studies::armLines(clip.skeleton, map, world[static_cast<std::size_t>(frame)], side, {}));
    return studies::meanOf(frames);
}

struct OneClip {
    results::MeasuredClip measured;
    std::string digest;
};

std::string digestOf(const ArmTrack& arm) {
    std::string bytes;
    for (const auto* points : {&arm.elbow, &arm.hand})
        for (const Vec3& point : *points)
            for (int axis = 0; axis < 3; ++axis) bytes += fmt::format("{} ", std::llround(point[axis] * 1e6));
    return sha256Hex(bytes);
}

/// Whether the figure has what a ray goes through; where it looks is none.
bool hasRay(const motion::HumanoidMap& map, Side side, motion::PointingRay ray) {
    using enum motion::PointingRay;
    const bool finger = ray == index_finger || ray == shoulder_fingertip || ray == elbow_fingertip;
    return ray != head && (!finger || map.has(motion::armBones(side).index_proximal));
}

std::array<std::optional<double>, motion::all_pointing_rays.size()> rayErrors(
    const motion::Skeleton& skeleton, const motion::HumanoidMap& map, Side side,
    const std::vector<Pose>& world, const Vec3& target) {
    std::array<std::optional<double>, motion::all_pointing_rays.size()> out{};
    for (const motion::PointingRay kind : motion::all_pointing_rays) {
        if (!hasRay(map, side, kind)) continue;
        const Ray ray = motion::pointingRay(skeleton, map, world, side, kind);
        if (glm::length(ray.direction) > 0.5)
            out.at(static_cast<std::size_t>(kind)) = degreesFromRadians(motion::angularError(ray, target));
    }
    return out;
}

Result<OneClip> measure(const ClipToMeasure& job, const motion::AccuracyRule& rule) {
    const std::string name = job.file.string();
    auto file = readMappedClip(job.file);
    if (!file) return tl::unexpected(file.error());
    const motion::HumanoidMap& map = file->map;
    if (const auto missing = motion::missingBones(map, motion::pointingBones()); !missing.empty())
        return fail(name,
                    fmt::format("no joint was found for {}, which pointing is measured by",
                                fmt::join(missing, " and ")),
                    "Name the joints as one of the known schemes does");
    standByTarget(file->clip, map, job.row.target_frame);
    const motion::Clip& clip = file->clip;
    const auto& phases = job.row.phases;
    if (phases && phases->end_frame >= clip.frameCount())
        return fail(name,
                    fmt::format("has {} frames, but its manifest lets the gesture end in frame {}",
                                clip.frameCount(), phases->end_frame),
                    "Frames count from 0");
    if (std::abs(job.row.fps - clip.framesPerSecond()) > 0.01 * job.row.fps)
        return fail(name,
                    fmt::format("has {:.4g} frames per second, but its manifest says {:g}",
                                clip.framesPerSecond(), job.row.fps),
                    "Phases are given in frames: both must count the same");
    const auto world = motion::worldPoses(clip);
    const Side side = phases ? phases->hand : motion::recognisedHand(world, map).hand;
    const auto arm = motion::armTrack(world, map, side, clip.frame_time_s);
    if (!arm) return fail(name, arm.error().message, arm.error().hint);
    const Vec3& target = *job.row.target;
    OneClip one;
    one.digest = digestOf(*arm);
    results::MeasuredClip& measured = one.measured;
    measured.system = job.row.system;
    measured.clip = job.row.clip;
    measured.target_id = job.row.target_id;
    measured.target = target;
    measured.hand = side;
    measured.phases_given = phases.has_value();
    measured.placed = job.row.target_frame == assets::TargetFrame::figure;
    measured.away = motion::standsAway(clip, map);
    motion::GesturePhases gesture;
    if (phases) {
        gesture = *phases;
    } else if (const auto found = motion::detectPhases(arm->hand, side, clip.frame_time_s)) {
        gesture = found->phases;
    } else {
        return one;  // a hand that does not move points at nothing
    }
    measured.pointing_frame = gesture.peak_frame;
    measured.accuracy = motion::pointingAccuracy(*arm, target, gesture.peak_frame, rule);
    measured.profile = motion::pointingProfile(*arm, target, gesture.peak_frame, results::profile_from_s,
                                               results::profile_to_s, results::profile_step_s);
    measured.lines = linesOf(clip, map, side, world, gesture.peak_frame, gesture.hold_frame);
    const int frame = measured.accuracy ? measured.accuracy->frame : gesture.peak_frame;
    measured.ray_errors_deg =
        rayErrors(clip.skeleton, map, side, world[static_cast<std::size_t>(frame)], target);
    return one;
}

}  // namespace

tl::expected<MeasuredClips, std::vector<Error>> measureClips(const std::vector<ClipToMeasure>& clips,
                                                             const motion::AccuracyRule& rule,
                                                             unsigned threads, const Progress& progress) {
    std::vector<std::optional<Result<OneClip>>> results(clips.size());
    const auto measureOne = [&](std::size_t i) {
        try {
            results[i] = measure(clips[i], rule);
        } catch (const std::exception& problem) {
            results[i] = fail(clips[i].file.string(), problem.what());
        }
    };
    takeInTurn(
        clips.size(), threads, [&](unsigned) { return measureOne; }, progress);

    MeasuredClips out;
    std::vector<Error> problems;
    std::string digests;
    for (auto& result : results) {
        if (*result) {
            digests += (*result)->digest;
            out.clips.push_back(std::move((*result)->measured));
        } else {
            problems.push_back(result->error());
        }
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    out.motion_digest = sha256Hex(digests);
    return out;
}

}  // namespace deixis::app
