// When a pointing hand starts, arrives, starts to return and is back: the one detector, used for clips and
// for the gestures of a recording.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/pointing/frame_runs.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/gesture_phases.hpp"

namespace deixis::motion {

/// A hand through a recording; each vector has one entry a frame.
struct HandTrajectory {
    std::vector<double> displacement;  ///< from where it rests, any length
    std::vector<double> speed_m_s;
};

/// A stretch in which a hand is out of rest.
struct Excursion {
    Run frames;
    Run around;  ///< reaching to the excursions before and after
    double farthest = 0.0;
};
/// Where the displacement is above `back` and goes beyond `out` meanwhile. Rests of less than `min_rest`
/// frames do not part two excursions.
[[nodiscard]] std::vector<Excursion> excursionsOf(const std::vector<double>& displacement, double back,
                                                  double out, int min_rest);

/// The phases of the gesture that an excursion is. The hold is the longest stretch in which the hand is
/// raised (half as far as the excursion's farthest, or farther) and slower than 0.3 of its peak speed in
/// the excursion (of equal ones the first); else about its slowest raised frame. Seen from there, the hand
/// moves where it is faster than a fifth of its peak speed on the same way, and the slower begin and end
/// of a movement are found from how fast it gets under way, as in a minimum-jerk movement (Flash & Hogan
/// 1985). An excursion that reaches the last frame ends where the hand next all but stops or turns.
[[nodiscard]] GesturePhases phasesOf(const Excursion& excursion, const HandTrajectory& trajectory, Side hand);

/// The same where the hold, `peak` to `hold`, is known and the hand may not rest before and after it: onset
/// and end are where it last and next all but stops or turns. around.begin < peak <= hold < around.end.
[[nodiscard]] GesturePhases phasesAroundHold(Run hold, Run around, const HandTrajectory& trajectory,
                                             Side hand);

/// The gesture of a clip.
struct DetectedGesture {
    GesturePhases phases;
    int strokes = 0;          ///< large movements between onset and end; raise and retraction make two
    bool clear_hold = false;  ///< between peak and hold the hand is still for 0.1 s or longer
    bool returns = false;     ///< the hand comes back to rest within the clip
};

/// Finds the gesture of a clip that holds one; of several the one that is held longest (of equal ones the
/// first). The hand's rest is where it is when the clip begins (its median over the first 0.1 s). Fails,
/// naming what was found, where the hand stays within 0.1 m of it, a position is not finite, or there are
/// fewer than 3 frames.
[[nodiscard]] Result<DetectedGesture> detectPhases(const std::vector<Vec3>& hand_positions, Side hand,
                                                   double frame_time_s);

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
/// Trajectory of one joint.
[[nodiscard]] std::vector<Vec3> jointTrajectory(const std::vector<std::vector<Pose>>& world, int joint);

}  // namespace deixis::motion
