#include "motion/skeleton/clip.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace deixis::motion {

namespace {

/// sin(t a) / sin(a) where 1 - cos(a) is `less`, at most 0.02: Eberly's series (2011, "A fast and accurate
/// algorithm for computing SLERP"), whose next term is below the last bit of a double.
double shareOfArc(double t, double less) {
    constexpr int terms = 8;
    double term = t;
    double sum = t;
    for (int i = 1; i <= terms; ++i) {
        const double u = 1.0 / (i * (2.0 * i + 1.0));
        const double v = i / (2.0 * i + 1.0);
        term *= (v - u * t * t) * less;
        sum += term;
    }
    return sum;
}

/// The shorter spherical arc. Neighbouring frames are mostly a few degrees apart, where no sine is needed.
Quat alongArc(const Quat& a, const Quat& b, double t) {
    constexpr double wide = 0.02;  // 11 degrees between the quaternions, 23 between the rotations
    const double cosine = glm::dot(a, b);
    const double less = 1.0 - std::abs(cosine);
    if (less > wide) return glm::slerp(a, b, t);
    const double of_a = shareOfArc(1.0 - t, less);
    const double of_b = std::copysign(shareOfArc(t, less), cosine);
    return {of_a * a.w + of_b * b.w, of_a * a.x + of_b * b.x, of_a * a.y + of_b * b.y,
            of_a * a.z + of_b * b.z};
}

}  // namespace

Pose interpolate(const Pose& a, const Pose& b, double t) {
    return {a.position + (b.position - a.position) * t, alongArc(a.orientation, b.orientation, t)};
}

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

Result<Clip> resample(const Clip& clip, double frame_time_s) {
    constexpr double max_poses = 2e7;
    const double frames = std::floor(clip.duration_s() / frame_time_s + 1e-6) + 1.0;
    if (!(frames * clip.skeleton.size() <= max_poses)) {
        const auto whole = [](double number) {
            std::string text = std::to_string(number);
            return text.substr(0, text.find('.'));
        };
        return fail(
            "",
            "found a clip of " + whole(clip.duration_s()) + " s, which at " + whole(1.0 / frame_time_s) +
                " frames per second has " + whole(frames) + " frames of " +
                std::to_string(clip.skeleton.size()) + " joints, expected at most " +
                whole(std::floor(max_poses / clip.skeleton.size())) + " frames",
            "Is the clip's frame rate right? Otherwise use fewer frames per second, or cut the clip first");
    }
    Clip out;
    out.skeleton = clip.skeleton;
    out.frame_time_s = frame_time_s;
    const int count = static_cast<int>(frames);
    out.frames.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) out.frames.push_back(sample(clip, i * frame_time_s));
    return out;
}

}  // namespace deixis::motion
