#include "motion/unit_gestures/gesture_timeline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deixis::motion {

namespace {

constexpr double peak_of_minimum_jerk = 1.875;  // ways per time
constexpr double same_moment_s = 1e-6;

/// When a gesture's own time comes.
double momentOf(const PlacedGesture& placed, double own_s) {
    return placed.apex_s + (own_s - placed.gesture.apex_s()) / placed.speed;
}

/// What a gesture does with one channel; the way back is left to the timeline.
ChannelKeys keysOf(const PlacedGesture& placed, std::size_t channel) {
    ChannelKeys keys;
    for (const UnitKey& key : placed.gesture.keys)
        if (key.channels[channel] && key.phase != GesturePhase::retraction)
            keys.push_back({momentOf(placed, key.time_s), *key.channels[channel], key.through});
    return keys;
}

/// Puts gestures into the track, one after another.
class Assembler {
  public:
    Assembler(double duration_s, const TimelineOptions& options)
        : options_(options), end_s_(duration_s - upper_body_frame_time_s) {}

    void add(std::size_t index, const PlacedGesture& placed) {
        const double stroke_end_s = momentOf(placed, placed.gesture.strokeEnd_s());
        std::array<ChannelKeys, channel_count> parts;
        std::array<double, channel_count> begins{};
        double begin_s = end_s_;
        for (std::size_t c = 0; c < channel_count; ++c) {
            parts[c] = keysOf(placed, c);
            if (parts[c].empty()) continue;
            begins[c] = beginOf(c, placed, parts[c]);
            const bool no_time = parts[c].front().time_s - begins[c] < options_.min_preparation_s ||
                                 stroke_end_s > end_s_ - retractionTime(c, parts[c].back().values);
            if (no_time && isHand(static_cast<Channel>(c))) return;
            if (no_time) parts[c].clear();
            if (!parts[c].empty()) begin_s = std::min(begin_s, begins[c]);
        }
        if (std::all_of(parts.begin(), parts.end(), [](const ChannelKeys& keys) { return keys.empty(); }))
            return;
        for (std::size_t c = 0; c < channel_count; ++c)
            if (!parts[c].empty()) append(c, begins[c], parts[c], stroke_end_s, placed.hold_s);
        made_.push_back(
            {index, begin_s, momentOf(placed, placed.gesture.strokeBegin_s()), placed.apex_s, stroke_end_s});
    }

    GestureTimeline finish() {
        for (std::size_t c = 0; c < channel_count; ++c)
            if (!track_[c].empty()) retract(c);
        return {std::move(track_), std::move(made_)};
    }

  private:
    /// When a channel sets out for a gesture: as the gesture says, or earlier where its way is long for the
    /// time, but not before the stroke that it is in is over.
    [[nodiscard]] double beginOf(std::size_t c, const PlacedGesture& placed, const ChannelKeys& part) const {
        const ChannelValues& from = track_[c].empty() ? relaxedTarget()[c] : track_[c].back().values;
        const double way_s = isHand(static_cast<Channel>(c)) ? timeFor(from, part.front().values) : 0.0;
        return std::max(
            {0.0, busy_until_s_[c], std::min(momentOf(placed, 0.0), part.front().time_s - way_s)});
    }

    void append(std::size_t c, double begin_s, const ChannelKeys& part, double stroke_end_s, double hold_s) {
        auto& keys = track_[c];
        if (keys.empty()) keys.push_back({0.0, relaxedTarget()[c], false});
        while (keys.back().time_s > begin_s + same_moment_s) keys.pop_back();  // a hold is cut short
        const double rest_s = keys.back().time_s + retractionTime(c, keys.back().values);
        if (rest_s + options_.min_rest_s <= begin_s) retract(c);
        keys.back().through = false;
        if (begin_s > keys.back().time_s + same_moment_s)
            keys.push_back({begin_s, keys.back().values, false});
        const double latest_s = end_s_ - retractionTime(c, part.back().values);
        for (const ChannelKey& key : part)
            if (key.time_s <= latest_s + same_moment_s) push(c, key);
        busy_until_s_[c] = std::min(keys.back().time_s, stroke_end_s);
        const double held_s = std::min(keys.back().time_s + hold_s, latest_s);
        if (held_s > keys.back().time_s + same_moment_s) keys.push_back({held_s, keys.back().values, false});
    }

    /// A way that is too fast ends short of the key.
    void push(std::size_t c, ChannelKey key) {
        const auto channel = static_cast<Channel>(c);
        const ChannelKey from = track_[c].back();
        const double time_s = key.time_s - from.time_s;
        if (isHand(channel))
            if (const double needed_s = timeFor(from.values, key.values); needed_s > time_s)
                key.values = alongWay(from.values, key.values, time_s / needed_s);
        appendKey(track_[c], channel, key);
    }

    /// In which a hand goes from one place to another by minimum jerk at its highest speed.
    [[nodiscard]] double timeFor(const ChannelValues& a, const ChannelValues& b) const {
        return peak_of_minimum_jerk * mean_arm_m * handWay(a, b).length / options_.max_hand_speed_m_s;
    }

    [[nodiscard]] double retractionTime(std::size_t c, const ChannelValues& from) const {
        return std::max(options_.retraction_s,
                        isHand(static_cast<Channel>(c)) ? timeFor(from, relaxedTarget()[c]) : 0.0);
    }

    void retract(std::size_t c) {
        auto& keys = track_[c];
        if (keys.back().values == relaxedTarget()[c]) return;
        keys.back().through = false;
        push(c, {keys.back().time_s + retractionTime(c, keys.back().values), relaxedTarget()[c], false});
    }

    const TimelineOptions& options_;
    double end_s_;  // relaxed from then on
    BodyTrack track_;
    std::array<double, channel_count> busy_until_s_{};  // the end of the last stroke
    std::vector<MadeGesture> made_;
};

}  // namespace

GestureTimeline timelineOf(const std::vector<PlacedGesture>& gestures, double duration_s,
                           const TimelineOptions& options) {
    std::vector<std::size_t> order(gestures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return gestures[a].apex_s < gestures[b].apex_s; });
    Assembler assembler(duration_s, options);
    for (const std::size_t i : order) assembler.add(i, gestures[i]);
    return assembler.finish();
}

}  // namespace deixis::motion
