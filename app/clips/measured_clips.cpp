#include "app/clips/measured_clips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>
#include <thread>

#include "app/clips/clip_files.hpp"
#include "core/hash.hpp"
#include "motion/pointing/pointing.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::app {

namespace {

using motion::ArmTrack;
using motion::Side;

/// The arm's lines over the hold; without phases at the time of pointing.
studies::ArmLines linesOf(const motion::Clip& clip, const motion::HumanoidMap& map, Side side,
                          const motion::Placement& placement, int first, int last) {
    std::vector<studies::ArmLines> frames;
    for (int frame = first; frame <= last; ++frame) {
        std::vector<Pose> world =
            motion::worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(frame)]);
        for (Pose& joint : world) joint = placement.stage_from_clip * joint;
        frames.push_back(studies::armLines(clip.skeleton, map, world, side, {}));
    }
    return studies::meanOf(frames);
}

struct OneClip {
    results::MeasuredClip measured;
    std::string digest;
};

/// The arm that points where nobody says which: that whose hand goes farther.
Result<ArmTrack> fartherArm(const motion::Clip& clip, const motion::HumanoidMap& map,
                            const motion::Placement& placement) {
    auto right = motion::armTrack(clip, map, Side::right, placement);
    auto left = motion::armTrack(clip, map, Side::left, placement);
    if (!left || !right) return left ? left : right;
    return motion::peakDisplacement_m(*left) > motion::peakDisplacement_m(*right) ? left : right;
}

std::string digestOf(const ArmTrack& arm) {
    std::string bytes;
    for (const auto* points : {&arm.elbow, &arm.hand})
        for (const Vec3& point : *points)
            for (int axis = 0; axis < 3; ++axis) bytes += fmt::format("{} ", std::llround(point[axis] * 1e6));
    return sha256Hex(bytes);
}

/// Whether the figure has what a ray goes through.
bool hasRay(const motion::HumanoidMap& map, Side side, motion::PointingRay ray) {
    using enum motion::PointingRay;
    const motion::ArmBones arm = motion::armBones(side);
    switch (ray) {
        case forearm:
            return true;
        case index_finger:
            return map.has(arm.index_proximal);
        case shoulder_hand:
            return map.has(arm.upper_arm);
        case shoulder_fingertip:
            return map.has(arm.upper_arm) && map.has(arm.index_proximal);
        case elbow_fingertip:
            return map.has(arm.index_proximal);
        case eye_fingertip:
            return map.has(motion::Bone::head);
        case head:
            return false;  // where it looks, not where it points
    }
    return false;
}

/// `target` in the clip's coordinates.
std::array<std::optional<double>, motion::all_pointing_rays.size()> rayErrors(const motion::Clip& clip,
                                                                              const motion::HumanoidMap& map,
                                                                              Side side, int frame,
                                                                              const Vec3& target) {
    std::array<std::optional<double>, motion::all_pointing_rays.size()> out{};
    const std::vector<Pose> world =
        motion::worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(frame)]);
    for (const motion::PointingRay kind : motion::all_pointing_rays) {
        if (!hasRay(map, side, kind)) continue;
        const Ray ray = motion::pointingRay(clip.skeleton, map, world, side, kind);
        if (glm::length(ray.direction) > 0.5)
            out.at(static_cast<std::size_t>(kind)) = degreesFromRadians(motion::angularError(ray, target));
    }
    return out;
}

Result<OneClip> measure(const ClipToMeasure& job, const motion::AccuracyRule& rule) {
    const std::string name = job.file.string();
    const auto file = readMappedClip(job.file);
    if (!file) return tl::unexpected(file.error());
    const motion::Clip& clip = file->clip;
    const motion::HumanoidMap& map = file->map;
    const motion::Placement placement = motion::placementOf(clip, map);
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
    auto arm =
        phases ? motion::armTrack(clip, map, phases->hand, placement) : fartherArm(clip, map, placement);
    if (!arm) {
        Error error = arm.error();
        error.where = name;
        return tl::unexpected(std::move(error));
    }
    const Vec3& target = *job.row.target;
    OneClip one;
    one.measured.system = job.row.system;
    one.measured.clip = job.row.clip;
    one.measured.target_id = job.row.target_id;
    one.measured.target = target;
    one.measured.hand = arm->side;
    one.measured.pointing_frame = phases ? phases->peak_frame : motion::displacementPeak(*arm);
    one.measured.phases_given = phases.has_value();
    one.measured.placed = placement.moved;
    one.measured.accuracy = motion::pointingAccuracy(*arm, target, one.measured.pointing_frame, rule);
    one.measured.profile =
        motion::pointingProfile(*arm, target, one.measured.pointing_frame, results::profile_from_s,
                                results::profile_to_s, results::profile_step_s);
    if (map.has(motion::Bone::head))
        one.measured.lines = linesOf(clip, map, arm->side, placement, one.measured.pointing_frame,
                                     phases ? phases->hold_frame : one.measured.pointing_frame);
    const int frame = one.measured.accuracy ? one.measured.accuracy->frame : one.measured.pointing_frame;
    one.measured.ray_errors_deg =
        rayErrors(clip, map, arm->side, frame, transformPoint(inverse(placement.stage_from_clip), target));
    one.digest = digestOf(*arm);
    return one;
}

}  // namespace

tl::expected<MeasuredClips, std::vector<Error>> measureClips(const std::vector<ClipToMeasure>& clips,
                                                             const motion::AccuracyRule& rule,
                                                             unsigned threads, const Progress& progress) {
    std::vector<std::optional<Result<OneClip>>> results(clips.size());
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::condition_variable finished;
    std::size_t done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < clips.size(); i = next++) {
            try {
                results[i] = measure(clips[i], rule);
            } catch (const std::exception& problem) {
                results[i] = fail(clips[i].file.string(), problem.what());
            }
            const std::lock_guard lock(mutex);
            if (++done == clips.size()) finished.notify_one();
        }
    };
    std::vector<std::thread> pool;
    for (unsigned i = 0; i < std::max(1U, threads); ++i) pool.emplace_back(work);
    {
        std::unique_lock lock(mutex);
        while (done < clips.size()) {
            finished.wait_for(lock, std::chrono::milliseconds(100));
            const std::size_t so_far = done;
            lock.unlock();
            progress(so_far, clips.size());
            lock.lock();
        }
    }
    for (std::thread& thread : pool) thread.join();

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
