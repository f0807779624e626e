#include "motion/clip.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::motion {

namespace {

Pose interpolate(const Pose& a, const Pose& b, double t) {
    // glm::slerp takes the shorter arc and falls back to a linear blend for tiny angles.
    return {a.position + (b.position - a.position) * t, glm::slerp(a.orientation, b.orientation, t)};
}

}  // namespace

void sample(const Clip& clip, double time_s, LocalPose& out) {
    const double last = clip.frameCount() - 1;
    const double frame = std::clamp(time_s / clip.frame_time_s, 0.0, last);
    const double floor = std::floor(frame);
    const auto index = static_cast<std::size_t>(floor);
    const double t = frame - floor;
    const LocalPose& a = clip.frames[index];
    if (t < 1e-9) {
        out = a;
        return;
    }
    const LocalPose& b = clip.frames[index + 1];
    out.joints.resize(a.joints.size());
    for (std::size_t j = 0; j < a.joints.size(); ++j)
        out.joints[j] = interpolate(a.joints[j], b.joints[j], t);
}

LocalPose sample(const Clip& clip, double time_s) {
    LocalPose out;
    sample(clip, time_s, out);
    return out;
}

Clip resample(const Clip& clip, double frame_time_s) {
    Clip out;
    out.skeleton = clip.skeleton;
    out.frame_time_s = frame_time_s;
    const int count = static_cast<int>(std::floor(clip.duration_s() / frame_time_s + 1e-6)) + 1;
    out.frames.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) out.frames.push_back(sample(clip, i * frame_time_s));
    return out;
}

}  // namespace deixis::motion
