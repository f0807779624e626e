// Unit gestures: a library of short gestures of our own making, after the classes of McNeill (1992, "Hand and
// Mind"), and their motion.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/unit_gestures/body_target.hpp"

namespace deixis::motion {

enum class GestureClass : unsigned char {
    iconic,      ///< shows what is spoken of: its shape, size or way
    metaphoric,  ///< shows an idea as if it were a thing
    deictic,     ///< points
    beat,        ///< marks the rhythm
    emblem       ///< stands for words of its own, or is for the other person: waving, a nod
};
constexpr std::size_t gesture_class_count = 5;
[[nodiscard]] std::string_view gestureClassName(GestureClass gesture_class);  ///< "iconic", ...
[[nodiscard]] std::optional<GestureClass> gestureClassFromName(std::string_view name);

enum class GesturePhase : unsigned char { preparation, stroke, hold, retraction };
[[nodiscard]] std::string_view gesturePhaseName(GesturePhase phase);  ///< "preparation", ...
[[nodiscard]] std::optional<GesturePhase> gesturePhaseFromName(std::string_view name);

/// A moment of a gesture. Channels without values here go on to their next key.
struct UnitKey {
    double time_s = 0.0;
    GesturePhase phase = GesturePhase::preparation;  ///< of the way that leads here
    bool through = false;                            ///< passed without a stop
    std::array<std::optional<ChannelValues>, channel_count> channels{};
};

/// Written for the right hand where one is enough.
struct UnitGesture {
    std::string id;
    std::string name;
    GestureClass gesture_class = GestureClass::beat;
    std::string meaning;  ///< one line
    /// Begins and ends as its first and last key say, and has to be blended in. Else both are relaxed.
    bool blended = false;
    std::vector<UnitKey> keys;  ///< the first at 0; rising times; at least one stroke

    [[nodiscard]] double duration_s() const { return keys.back().time_s; }
    [[nodiscard]] double apex_s() const;         ///< the end of the first stroke
    [[nodiscard]] double strokeBegin_s() const;  ///< the beginning of the first stroke
    [[nodiscard]] double strokeEnd_s() const;    ///< the end of the last stroke
    [[nodiscard]] bool uses(Channel channel) const;
};

using GestureLibrary = std::vector<UnitGesture>;
/// Null where there is none.
[[nodiscard]] const UnitGesture* findGesture(const GestureLibrary& library, std::string_view id);

/// Fails, naming the key from 0, where a gesture is not as UnitGesture says: times that do not rise from 0,
/// no stroke, a hand beyond the arm's length or nearer than a folded arm's (more than 1.0 or less than 0.35),
/// angles beyond 120 degrees, a gesture that is not blended whose first or last key has values.
[[nodiscard]] Result<void> checkGesture(const UnitGesture& gesture);

/// The gesture for the other hand.
[[nodiscard]] UnitGesture mirrored(const UnitGesture& gesture);

/// Its channels over time, from 0 to its duration.
[[nodiscard]] BodyTrack trackOf(const UnitGesture& gesture);

constexpr double slowest_gesture = 1.0;
constexpr double fastest_gesture = 3.0;
/// Its motion, `speed` times as fast: sampled anew, so that nothing is dropped. Above 0.
[[nodiscard]] UpperBodyMotion motionOf(const UnitGesture& gesture, double speed = 1.0);

}  // namespace deixis::motion
