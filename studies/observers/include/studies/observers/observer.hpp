// How an observer chooses one of several balls from a pointing arm. Pure functions. The model, its sources
// and what is ours: docs/simulated-participant.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "motion/pointing/rays.hpp"

namespace deixis::studies {

/// What of a pointing arm is read: one of its lines, or the two cues of Krause & Herbort (2021).
struct Reading {
    std::optional<motion::PointingRay> line{};  ///< none: two cues
    [[nodiscard]] bool twoCue() const { return !line.has_value(); }
    bool operator==(const Reading&) const = default;
};
/// "two-cue"; "arm-finger", from the elbow through the fingertip; or the name of a pointing ray.
[[nodiscard]] Result<Reading> readingFromName(std::string_view name);
[[nodiscard]] std::string_view readingName(const Reading& reading);

struct ObserverModel {
    Reading reading{};
    double noise_rad = radiansFromDegrees(3.0);
    double lapse_rate = 0.02;  ///< chance of choosing any ball at random

    // Of the two cues only.
    /// Of the weight of direction, the share of the line from the pointer's eyes; the rest is the arm's.
    double eye_line_share = 0.5;
    /// Of where the finger stands in the observer's own field of view, while the gaze runs along the arm. It
    /// falls with the cosine of the angle between gaze and arm, to 0 from a right angle on.
    double visual_weight = 0.5;
};

/// The lines of an arm, unit length; the first two start at the fingertip.
struct ArmLines {
    Ray eye_line{};  ///< away from between the pointer's eyes
    Ray arm_line{};  ///< away from the elbow: forearm and finger as one pointer
    Ray line{};      ///< the one that a reading of one line takes
};

/// An arm as it was seen in the hold.
struct SeenArm {
    ArmLines lines{};
    Vec3 observer_eye{0.0};
};

/// The lines in a world pose. The map has head and arms.
[[nodiscard]] ArmLines armLines(const motion::Skeleton& skeleton, const motion::HumanoidMap& map,
                                const std::vector<Pose>& world, motion::Side side, const Reading& reading);
/// Over frames, of which there must be one: mean origins and mean directions, these of unit length.
[[nodiscard]] ArmLines meanOf(std::span<const ArmLines> frames);

/// Every line turned upwards by an angle (downwards: below 0), no farther than straight up.
[[nodiscard]] ArmLines raised(const ArmLines& lines, double by_rad);

/// Of the line from the pointer's eyes, the line of arm and finger, and the line from the observer's own eye
/// over the pointer's fingertip; their sum is 1.
[[nodiscard]] std::array<double, 3> cueWeights(const ObserverModel& model, const SeenArm& arm);

/// By how much each ball is missed by what is read, radians: the angle from the one line at its start; of the
/// two cues the angle that one line alone would have to miss it by to speak for it as much as all three do.
[[nodiscard]] std::vector<double> misses(const ObserverModel& model, const SeenArm& arm,
                                         const std::vector<Vec3>& balls);

/// The chance that a ball is chosen, without lapses. One line: it is turned by a normal angle of SD noise_rad
/// about two axes across it, and the ball nearest in angle chosen (by the trapezoid rule, right to about
/// 0.001; noise up to 0.7, and above 0). Two cues: in proportion to
/// sum over cues of weight * exp(-angle^2 / (2 noise_rad^2)).
[[nodiscard]] double ballChance(const ObserverModel& model, const SeenArm& arm,
                                const std::vector<Vec3>& balls, std::size_t ball);

/// The same with lapses: (1 - lapse_rate) ballChance() + lapse_rate / balls.
[[nodiscard]] double choiceChance(const ObserverModel& model, const SeenArm& arm,
                                  const std::vector<Vec3>& balls, std::size_t ball);

/// Unit length, across a direction of unit length and across each other: a line is disturbed about them.
struct AcrossRay {
    Vec3 right{};
    Vec3 above{};
};
[[nodiscard]] AcrossRay acrossRay(const Vec3& direction);

}  // namespace deixis::studies
