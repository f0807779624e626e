// When a pointing hand does what: onset, peak, hold and end of a gesture found from the hand's speed.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

/// Thresholds of the detection. Speeds are those of the hand joint (kinematics.hpp). Shares are of the
/// greatest speed and of the greatest displacement from rest in the clip.
struct PhaseThresholds {
    double least_displacement_m = 0.10;  ///< a hand that never goes farther makes no gesture
    double stroke_share = 0.30;          ///< a stroke: the speed reaches this share of the peak speed ...
    double still_share = 0.05;           ///< ... and lasts until it falls below this share (hysteresis),
    double still_mps = 0.05;             ///< or below this speed, whichever is greater
    double run_out_s =
        2.0 / 30.0;  ///< a movement ends so long after that at most, while it goes on slowing down
    double raised_share = 0.50;  ///< raised: farther from rest than this share
    double least_hold_s = 0.10;  ///< a hold is still and raised for so long
};

/// Frames count from 0; 0 <= onset < peak <= hold <= end < frame count, and onset < end.
struct GesturePhases {
    Side hand = Side::right;
    int onset_frame = 0;      ///< the hand leaves its rest
    int peak_frame = 0;       ///< it has come to the pointing posture
    int hold_frame = 0;       ///< last frame of the pointing posture
    int end_frame = 0;        ///< the hand is back at rest, or the clip's last frame where it never comes
    int strokes = 0;          ///< large movements between onset and end; raise and retraction make two
    bool clear_hold = false;  ///< between peak and hold the hand is still for least_hold_s or longer
    bool returns = false;     ///< the hand comes back to rest within the clip
    double peak_speed_mps = 0.0;
    int peak_speed_frame = 0;  ///< of the raise: the first stroke of the gesture up to the peak
};

/// The rule. The hand's rest is where it is when the clip begins (its median over the first 0.1 s). Strokes
/// are found with hysteresis. The hold lies between two strokes, where the hand is raised: of several such
/// pauses the longest (of equal ones the first). It begins with the first still frame after a stroke and ends
/// with the last one before the next, both moved outwards while the hand goes on slowing down; where the hand
/// never is still there, it begins and ends with the slowest frames next to the strokes, and `clear_hold` is
/// false. Onset is the beginning of the first stroke since the hand was last at rest, end the end of the
/// stroke that brings it back. A gesture without a raised pause has its peak and hold at the slowest raised
/// frame. Fails, naming what was found, where the hand stays within least_displacement_m or a position is not
/// finite.
[[nodiscard]] Result<GesturePhases> detectPhases(const std::vector<Vec3>& hand_positions, Side hand,
                                                 double frame_time_s, const PhaseThresholds& thresholds = {});

/// The hand of the clip that goes farther from where it rests, and how far each goes.
struct PointingHand {
    Side hand = Side::right;
    double displacement_m = 0.0;
    double other_displacement_m = 0.0;
};
/// Both hands' displacements are measured from the hips, so that a figure that walks does not count as one
/// that points. The map has hips and both hands; the clip's frames are those of `world`.
[[nodiscard]] PointingHand recognisedHand(const std::vector<std::vector<Pose>>& world,
                                          const HumanoidMap& map);

/// World poses of every frame.
[[nodiscard]] std::vector<std::vector<Pose>> worldPoses(const Clip& clip);
/// Course of one joint.
[[nodiscard]] std::vector<Vec3> jointCourse(const std::vector<std::vector<Pose>>& world, int joint);

}  // namespace deixis::motion
