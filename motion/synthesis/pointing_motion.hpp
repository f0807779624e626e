// A pointing gesture in time: from the stance at ease into a posture, held, and back.
#pragma once

#include "core/random.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"
#include "motion/synthesis/generator.hpp"
#include "pointing_body.hpp"

namespace deixis::motion {

/// How one gesture goes. Times in seconds.
struct PointingMotion {
    Side hand = Side::right;
    LocalPose peak;      ///< the posture reached by the raise
    LocalPose hold_end;  ///< the posture left by the retraction; the hold moves slowly between the two
    double rest_before_s = 0.3;
    double raise_s = 0.8;
    double hold_s = 1.0;
    double retract_s = 0.85;
    double rest_after_s = 0.3;
    bool linear = false;  ///< steady joint speed in place of minimum jerk, and the wrist's path left as it is
    double raise_bulge = 0.0;
    double retract_bulge = 0.0;
    bool gaze = false;  ///< eyes (and the head before the hand) go to `gaze_at`
    Vec3 gaze_at{0.0};
    double noise_share = 0.0;  ///< of the parameters' noise, drift, sway and breathing; 0: none
    double wander_rad = 0.0;   ///< slow wandering of the arm during the hold
    Interval wander_hz{0.0, 0.0};
    double jitter_rad = 0.0;  ///< unsmoothed shaking of the arm's joints, SD per frame
};

/// The motion held as asked for.
[[nodiscard]] PointingMotion heldAs(PointingMotion motion, const HoldSettings& settings,
                                    const PointingBody& body);

constexpr double generated_frame_time_s = 1.0 / 30.0;

/// From the begin of the first rest to the end of the second.
[[nodiscard]] double wholeDuration_s(const PointingMotion& motion);
/// A clip of that duration with its phases, whose frames are without poses.
[[nodiscard]] GeneratedClip emptyClip(const PointingBody& body, const PointingMotion& motion);

[[nodiscard]] GeneratedClip perform(const PointingBody& body, const PointingMotion& motion,
                                    const DemonstrationParameters& parameters, std::uint64_t seed);

}  // namespace deixis::motion
