#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "motion/unit_gestures/gesture_timeline.hpp"

namespace deixis::motion {

namespace {

/// Two slow waves that never meet the same way again: smooth, and known at any time.
struct Sway {
    double slow_hz = 0.0, quick_hz = 0.0, slow_rad = 0.0, quick_rad = 0.0;

    explicit Sway(Random& random)
        : slow_hz(random.uniform(0.07, 0.15)),
          quick_hz(random.uniform(0.18, 0.32)),
          slow_rad(random.uniform(0.0, 2.0 * pi)),
          quick_rad(random.uniform(0.0, 2.0 * pi)) {}

    /// -1 to 1.
    [[nodiscard]] double at(double time_s) const {
        return 0.65 * std::sin(2.0 * pi * slow_hz * time_s + slow_rad) +
               0.35 * std::sin(2.0 * pi * quick_hz * time_s + quick_rad);
    }
};

/// Amplitudes of a channel's values.
ChannelValues amplitudes(Channel channel, const IdleOptions& idle) {
    if (channel == Channel::head) return {idle.head_deg, idle.head_deg, 0.6 * idle.head_deg, 0.0};
    if (channel == Channel::trunk)
        return {idle.trunk_deg, idle.trunk_deg, idle.trunk_deg, 0.7 * idle.trunk_deg};
    return {idle.hand, idle.hand, idle.hand, 0.0};
}

}  // namespace

UpperBodyMotion motionOf(const BodyTrack& track, double duration_s, std::uint64_t seed,
                         const IdleOptions& idle) {
    Random random(seed, "idle");
    std::vector<Sway> sways;
    for (std::size_t i = 0; i < channel_count * 4; ++i) sways.emplace_back(random);
    UpperBodyMotion motion;
    const std::size_t count = frameCountOf(duration_s);
    const double last_s = static_cast<double>(count - 1) * upper_body_frame_time_s;
    motion.frames.reserve(count);
    for (std::size_t f = 0; f < count; ++f) {
        const double time_s = static_cast<double>(f) * upper_body_frame_time_s;
        const double share = minimumJerk(std::min(time_s, last_s - time_s) / idle.ramp_s);
        BodyTarget target = targetAt(track, time_s);
        for (std::size_t c = 0; c < channel_count; ++c) {
            const ChannelValues most = amplitudes(static_cast<Channel>(c), idle);
            for (std::size_t v = 0; v < most.size(); ++v)
                target[c][v] += share * most[v] * sways[4 * c + v].at(time_s);
        }
        motion.frames.push_back(poseOf(target));
    }
    return motion;
}

}  // namespace deixis::motion
