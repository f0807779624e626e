// The objective measure of a pointing clip (Deichler et al. 2023, section 3.2): how well the forearm
// points at the target while the hand is slow, and the time courses of reward and speed around the time of
// pointing. Pure functions.
#pragma once

#include <optional>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// One arm through a clip, metres in the clip's coordinates; one entry a frame.
struct ArmTrack {
    Side side = Side::right;
    double frame_time_s = 1.0 / 30.0;
    std::vector<Vec3> elbow;
    std::vector<Vec3> hand;
};

/// `world`: the clip's poses (worldPoses()). Fails if the forearm has no length in a frame.
[[nodiscard]] Result<ArmTrack> armTrack(const std::vector<std::vector<Pose>>& world, const HumanoidMap& map,
                                        Side side, double frame_time_s);

/// Equation 2 in each frame.
[[nodiscard]] std::vector<double> pointingRewards(const ArmTrack& arm, const Vec3& target);

/// Which frames of a clip count.
struct AccuracyRule {
    double window_s = 0.15;  ///< length of the window, the time of pointing in its middle
    double slower_than_m_s = 0.5;
};

struct PointingAccuracy {
    double reward = 0.0;     ///< the highest of Equation 2 over the frames that count; in [0, 0.632]
    double error_rad = 0.0;  ///< the angle between forearm and target in that frame
    int frame = 0;           ///< that frame; the first where several are equal
};

/// None if the hand is nowhere slow enough within the window. `pointing_frame` lies within the clip.
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
