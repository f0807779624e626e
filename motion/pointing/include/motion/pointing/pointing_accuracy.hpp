// The objective measure of a pointing clip (Deichler et al. 2023, section 3.2): how well the forearm points
// at the target while the hand is slow, and how reward and speed run around the time of pointing. Pure
// functions.
#pragma once

#include <optional>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// What takes a clip's coordinates to those of the targets: the figure at the origin, on the floor, facing
/// +z, y up.
struct Placement {
    Pose stage_from_clip{};
    bool moved = false;  ///< false: the clip stood there already, and stage_from_clip is the identity
};

/// By the first frame: where hips, legs (or upper arms), head and feet are known. A clip stays untouched
/// where its hips are within 0.25 m of the origin's vertical, it faces +z within 20 degrees, its lowest foot
/// joint is within 0.2 m of the floor, and y is up; else it is turned, moved or lifted as far as that asks.
[[nodiscard]] Placement placementOf(const Clip& clip, const HumanoidMap& map);

/// One arm through a clip, metres in the targets' coordinates; one entry a frame.
struct ArmTrack {
    Side side = Side::right;
    double frame_time_s = 1.0 / 30.0;
    std::vector<Vec3> elbow;
    std::vector<Vec3> hand;
};

/// Fails where the figure has no elbow (lowerArm) or hand of that side, naming them, or a forearm without
/// length.
[[nodiscard]] Result<ArmTrack> armTrack(const Clip& clip, const HumanoidMap& map, Side side,
                                        const Placement& placement);

/// Frame in which the hand is farthest, in the sagittal plane (y and z), from where it was in the first
/// frame: the paper's peak of displacement (section 2.1), for clips whose phases nobody gave.
[[nodiscard]] int displacementPeak(const ArmTrack& arm);
/// How far that is, metres.
[[nodiscard]] double peakDisplacement_m(const ArmTrack& arm);

/// The hand's speed in each frame, m/s: central differences, one-sided at the ends; 0 for a single frame.
[[nodiscard]] std::vector<double> handSpeeds(const ArmTrack& arm);

/// Equation 2 in each frame.
[[nodiscard]] std::vector<double> pointingRewards(const ArmTrack& arm, const Vec3& target);

/// Which frames of a clip count.
struct AccuracyRule {
    double window_s = 0.15;  ///< length of the window, the time of pointing in its middle
    double slower_than_m_s = 0.5;
};

struct PointingAccuracy {
    double reward = 0.0;     ///< the greatest of Equation 2 over the frames that count; in [0, 0.632]
    double error_rad = 0.0;  ///< the angle between forearm and target in that frame
    int frame = 0;           ///< that frame; the first where several are equal
};

/// None where the hand is nowhere slow enough within the window. `pointing_frame` lies within the clip.
[[nodiscard]] std::optional<PointingAccuracy> pointingAccuracy(const ArmTrack& arm, const Vec3& target,
                                                               int pointing_frame, const AccuracyRule& rule);

/// Values at steady steps of time, 0 at the time of pointing; only steps within the clip.
struct PointingProfile {
    int first_step = 0;  ///< time of the first value over the step
    std::vector<double> reward;
    std::vector<double> speed_m_s;
};

/// Reward and hand speed every `step_s` from `from_s` to `to_s` around the pointing frame, linear between
/// frames.
[[nodiscard]] PointingProfile pointingProfile(const ArmTrack& arm, const Vec3& target, int pointing_frame,
                                              double from_s, double to_s, double step_s);

}  // namespace deixis::motion
