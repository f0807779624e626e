// A clip: a skeleton and its poses at a constant frame rate.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

/// Invariants: 1. at least one frame; 2. every frame has the skeleton's number of joints; 3. frame_time_s >
/// 0.
struct Clip {
    Skeleton skeleton;
    double frame_time_s = 1.0 / 30.0;
    std::vector<LocalPose> frames;

    [[nodiscard]] int frameCount() const { return static_cast<int>(frames.size()); }
    [[nodiscard]] double framesPerSecond() const { return 1.0 / frame_time_s; }
    /// Time of the last frame; 0 for a single frame.
    [[nodiscard]] double duration_s() const { return frame_time_s * (frameCount() - 1); }
};

/// The pose at `time_s`, clamped to the clip: positions linear, rotations by the shorter spherical arc.
/// `out` is resized; give the same object each frame to save the allocation.
void sample(const Clip& clip, double time_s, LocalPose& out);
[[nodiscard]] LocalPose sample(const Clip& clip, double time_s);
/// The pose at share `t` of the way from one to another, likewise; the rotations are of unit length.
[[nodiscard]] Pose interpolate(const Pose& a, const Pose& b, double t);

/// The clip at another frame rate, its first frame kept; the last sample lies within one new frame of the
/// end. Fails if that takes more than 20 million poses of single joints (about 1 GB): an hour of a person
/// with 55 joints at 100 frames per second.
[[nodiscard]] Result<Clip> resample(const Clip& clip, double frame_time_s);

}  // namespace deixis::motion
