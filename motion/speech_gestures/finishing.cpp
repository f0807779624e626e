#include "motion/speech_gestures/finishing.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::motion {

namespace {

constexpr double still_speed_m_s = 0.15;
constexpr std::size_t still_frames = 8;   // half a second
constexpr std::size_t still_reached = 4;  // frames

/// Of the faster wrist, from the frame before; 0 at the first.
std::vector<double> wristSpeeds(const UpperBodyMotion& motion) {
    std::vector<double> out(motion.frames.size(), 0.0);
    for (std::size_t f = 1; f < out.size(); ++f) {
        const UpperBodyJoints before = jointsOf(motion.frames[f - 1]), now = jointsOf(motion.frames[f]);
        for (const UpperJoint wrist : {UpperJoint::left_wrist, UpperJoint::right_wrist}) {
            const auto at = static_cast<std::size_t>(wrist);
            out[f] = std::max(out[f], glm::length(now[at] - before[at]) * upper_body_fps);
        }
    }
    return out;
}

void holdStretch(UpperBodyMotion& motion, std::size_t first, std::size_t until) {
    const UpperBodyPose held = motion.frames[(first + until) / 2];
    for (std::size_t f = first; f < until; ++f) {
        // A motion's own ends are not left to anything.
        const std::size_t from_start = first == 0 ? still_reached : f - first + 1;
        const std::size_t to_end = until == motion.frames.size() ? still_reached : until - f;
        const double share = static_cast<double>(std::min(from_start, to_end)) / still_reached;
        motion.frames[f] = share >= 1.0 ? held : interpolate(motion.frames[f], held, minimumJerk(share));
    }
}

}  // namespace

void fadeTo(UpperBodyMotion& motion, std::size_t first, const UpperBodyPose& pose) {
    const std::size_t count = motion.frames.size();
    if (count == 0 || first + 1 >= count) return;
    const auto whole = static_cast<double>(count - 1 - first);
    for (std::size_t f = first; f < count; ++f)
        motion.frames[f] =
            interpolate(motion.frames[f], pose, minimumJerk(static_cast<double>(f - first) / whole));
}

void holdStill(UpperBodyMotion& motion) {
    const std::vector<double> speeds = wristSpeeds(motion);
    std::size_t first = 0;
    for (std::size_t f = 0; f <= speeds.size(); ++f) {
        if (f < speeds.size() && speeds[f] < still_speed_m_s) continue;
        if (f - first >= still_frames) holdStretch(motion, first, f);
        first = f + 1;
    }
}

}  // namespace deixis::motion
