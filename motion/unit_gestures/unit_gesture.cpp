#include "motion/unit_gestures/unit_gesture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deixis::motion {

namespace {

constexpr std::array<std::string_view, gesture_class_count> class_names{"iconic", "metaphoric", "deictic",
                                                                        "beat", "emblem"};
constexpr std::array<std::string_view, 4> phase_names{"preparation", "stroke", "hold", "retraction"};

template <typename Enum, std::size_t count>
std::optional<Enum> fromName(const std::array<std::string_view, count>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Enum>(found - names.begin());
}

/// What is wrong with a channel's values; empty where nothing is.
std::string faultOf(Channel channel, const ChannelValues& values) {
    if (std::any_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }))
        return "found a number that is not finite";
    constexpr double most_deg = 120.0;
    std::size_t angles_from = 0;
    if (isHand(channel)) {
        constexpr double nearest = 0.35, farthest = 1.0;
        const double reach = std::hypot(values[0], values[1], values[2]);
        if (reach < nearest || reach > farthest)
            return fmt::format("found a hand {:.2f} arm lengths from the shoulder, expected {} to {}", reach,
                               nearest, farthest);
        angles_from = 3;
    }
    for (std::size_t v = angles_from; v < values.size(); ++v)
        if (std::abs(values[v]) > most_deg)
            return fmt::format("found an angle of {} degrees, expected {} at most", values[v], most_deg);
    return {};
}

}  // namespace

std::string_view gestureClassName(GestureClass gesture_class) {
    return class_names[static_cast<std::size_t>(gesture_class)];
}

std::optional<GestureClass> gestureClassFromName(std::string_view name) {
    return fromName<GestureClass>(class_names, name);
}

std::string_view gesturePhaseName(GesturePhase phase) {
    return phase_names[static_cast<std::size_t>(phase)];
}

std::optional<GesturePhase> gesturePhaseFromName(std::string_view name) {
    return fromName<GesturePhase>(phase_names, name);
}

double UnitGesture::apex_s() const {
    for (std::size_t k = 1; k < keys.size(); ++k)
        if (keys[k].phase == GesturePhase::stroke && !keys[k].through) return keys[k].time_s;
    return strokeEnd_s();
}

double UnitGesture::strokeBegin_s() const {
    for (std::size_t k = 1; k < keys.size(); ++k)
        if (keys[k].phase == GesturePhase::stroke) return keys[k - 1].time_s;
    return 0.0;
}

double UnitGesture::strokeEnd_s() const {
    double end_s = 0.0;
    for (const UnitKey& key : keys)
        if (key.phase == GesturePhase::stroke) end_s = key.time_s;
    return end_s;
}

bool UnitGesture::uses(Channel channel) const {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const UnitKey& key) { return key.channels[indexOf(channel)].has_value(); });
}

const UnitGesture* findGesture(const GestureLibrary& library, std::string_view id) {
    const auto found =
        std::find_if(library.begin(), library.end(), [&](const UnitGesture& g) { return g.id == id; });
    return found == library.end() ? nullptr : &*found;
}

Result<void> checkGesture(const UnitGesture& gesture) {
    const auto wrong = [](std::size_t key, const std::string& what) {
        return fail(fmt::format("key {}", key), what);
    };
    const auto& keys = gesture.keys;
    if (keys.size() < 3) return fail("", fmt::format("found {} keys, expected 3 or more", keys.size()));
    bool strokes = false;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const UnitKey& key = keys[k];
        const double before_s = k == 0 ? 0.0 : keys[k - 1].time_s;
        if (!std::isfinite(key.time_s) || (k == 0 ? key.time_s != 0.0 : key.time_s <= before_s))
            return wrong(k, fmt::format("found it at {} s, expected times that rise from 0", key.time_s));
        if (k > 0 && key.phase == GesturePhase::stroke) strokes = true;
        const bool at_end = k == 0 || k + 1 == keys.size();
        for (std::size_t c = 0; c < channel_count; ++c) {
            if (!key.channels[c]) continue;
            if (at_end && !gesture.blended)
                return wrong(k,
                             "found values, expected the relaxed pose at both ends of a gesture that is not "
                             "to be blended");
            if (const std::string fault = faultOf(static_cast<Channel>(c), *key.channels[c]); !fault.empty())
                return wrong(k, fault);
        }
    }
    if (!strokes) return fail("", "found no stroke, expected at least one");
    return {};
}

UnitGesture mirrored(const UnitGesture& gesture) {
    UnitGesture out = gesture;
    for (std::size_t k = 0; k < out.keys.size(); ++k)
        for (std::size_t c = 0; c < channel_count; ++c) {
            const auto channel = static_cast<Channel>(c);
            const auto& values = gesture.keys[k].channels[c];
            auto& other = out.keys[k].channels[indexOf(mirrored(channel))];
            other.reset();
            if (values) other = mirrored(channel, *values);
        }
    return out;
}

BodyTrack trackOf(const UnitGesture& gesture) {
    BodyTrack track;
    for (std::size_t c = 0; c < channel_count; ++c) {
        if (!gesture.uses(static_cast<Channel>(c))) continue;
        for (std::size_t k = 0; k < gesture.keys.size(); ++k) {
            const UnitKey& key = gesture.keys[k];
            const bool at_end = k == 0 || k + 1 == gesture.keys.size();
            if (key.channels[c])
                appendKey(track[c], static_cast<Channel>(c), {key.time_s, *key.channels[c], key.through});
            else if (at_end && !gesture.blended)
                appendKey(track[c], static_cast<Channel>(c), {key.time_s, relaxedTarget()[c], false});
        }
    }
    return track;
}

UpperBodyMotion motionOf(const UnitGesture& gesture, double speed) {
    const BodyTrack track = trackOf(gesture);
    const auto steps =
        static_cast<std::size_t>(std::max(1L, std::lround(gesture.duration_s() / speed * upper_body_fps)));
    UpperBodyMotion motion;
    motion.frames.reserve(steps + 1);
    for (std::size_t f = 0; f <= steps; ++f) {
        const double share = static_cast<double>(f) / static_cast<double>(steps);
        motion.frames.push_back(poseOf(targetAt(track, share * gesture.duration_s())));
    }
    return motion;
}

}  // namespace deixis::motion
