// Where hands, head and trunk are to be, and how they get there in time: what gestures are written in.
// Relative to the body, so that one gesture fits every figure.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/skeleton/humanoid.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

/// What moves on its own.
enum class Channel : unsigned char { right_hand, left_hand, head, trunk };
constexpr std::size_t channel_count = 4;

/// Of a hand: where its wrist is as seen from the shoulder, out (to the hand's own side), up and ahead, in
/// arm lengths (shoulder to wrist); and how far the elbow is swung outwards and up from where it hangs,
/// degrees. Of the head: yaw (to the figure's left), pitch (down), roll (to its right shoulder), degrees; the
/// fourth is 0. Of the trunk: yaw (to its left), lean (ahead), lean to its right, lift of the shoulders,
/// degrees.
using ChannelValues = std::array<double, 4>;

using BodyTarget = std::array<ChannelValues, channel_count>;

constexpr Channel handChannel(Side side) {
    return side == Side::right ? Channel::right_hand : Channel::left_hand;
}
constexpr bool isHand(Channel channel) {
    return channel == Channel::right_hand || channel == Channel::left_hand;
}
constexpr std::size_t indexOf(Channel channel) {
    return static_cast<std::size_t>(channel);
}

/// Of relaxedUpperBody().
[[nodiscard]] const BodyTarget& relaxedTarget();

/// The body with its hands there, or as near as they can come; shoulders go along with raised and stretched
/// arms.
[[nodiscard]] UpperBodyPose poseOf(const BodyTarget& target);

/// The other way round.
[[nodiscard]] ChannelValues mirrored(Channel channel, const ChannelValues& values);
[[nodiscard]] Channel mirrored(Channel channel);

/// Arm length of the mean body, metres: what an arm length of a target is.
constexpr double mean_arm_m = upper_bones[4].length_m + upper_bones[5].length_m;

/// A place of a channel at a moment.
struct ChannelKey {
    double time_s = 0.0;
    ChannelValues values{};
    bool through = false;  ///< passed without a stop

    bool operator==(const ChannelKey&) const = default;
};
using ChannelKeys = std::vector<ChannelKey>;  ///< in rising order of time

/// Between keys by minimum jerk, at rest in each that is not gone through; before the first and after the
/// last as they are. At least one key.
[[nodiscard]] ChannelValues valuesAt(const ChannelKeys& keys, double time_s);

/// How far a hand goes from one place to another, arm lengths. It cannot go by too near its shoulder: then it
/// goes round by a place before the body.
struct HandWay {
    double length = 0.0;
    std::optional<ChannelValues> round{};  ///< the place, where there is one
    double share_to_round = 0.0;           ///< of the length
};
[[nodiscard]] HandWay handWay(const ChannelValues& from, const ChannelValues& to);

/// The place at a share of that way.
[[nodiscard]] ChannelValues alongWay(const ChannelValues& from, const ChannelValues& to, double share);

/// Puts a key behind others, and before it, for a hand, the place that it goes round by.
void appendKey(ChannelKeys& keys, Channel channel, const ChannelKey& key);

/// Keys of each channel; one without keys is relaxed.
using BodyTrack = std::array<ChannelKeys, channel_count>;
[[nodiscard]] BodyTarget targetAt(const BodyTrack& track, double time_s);

}  // namespace deixis::motion
