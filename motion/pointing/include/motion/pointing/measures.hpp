// Everything that can be measured on one pointing clip without human raters. docs/measures.md describes
// each measure.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/pointing/body_checks.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

/// One ray against the target, over the hold (every frame from peak to hold).
struct RayMeasures {
    Ray middle{};             ///< the ray in the middle of the hold, in the clip's coordinates
    double error_rad = 0.0;   ///< in the middle of the hold
    double distance_m = 0.0;  ///< from the ray to the target there
    bool points_away = false;
    double min_error_rad = 0.0;              ///< the smallest of the hold
    std::optional<Steadiness> steadiness{};  ///< of the ray's direction, radians
};

struct PointingMeasures {
    GesturePhases phases;
    std::optional<DetectedGesture> detected{};  ///< where the phases were not given
    double peak_speed_m_s = 0.0;                ///< of the hand, onset to peak
    double hold_s = 0.0;                        ///< from peak to hold
    double time_to_peak_s = 0.0;                ///< from onset to peak
    double time_to_peak_speed_s = 0.0;          ///< from onset to the raise's peak speed
    /// Of the fingertip over the hold, metres; none if the hold has fewer than 3 frames.
    std::optional<Steadiness> fingertip{};
    /// Of the hand from onset to peak.
    std::optional<double> log_dimensionless_jerk{};
    std::optional<double> spectral_arc_length{};
    /// Each ray by PointingRay; none if it has no direction (a bone of zero length), or without a target.
    std::array<std::optional<RayMeasures>, all_pointing_rays.size()> rays{};
    std::optional<double> reward{};      ///< equation 2 in the middle of the hold
    std::optional<double> max_reward{};  ///< the largest of the hold
    std::optional<FootSkate> foot_skate{};
    std::vector<LimitViolation> limit_violations;
    std::vector<Intersection> intersections;
};

/// Measures a clip. `target` in the clip's own coordinates, metres. Given phases are taken, else they are
/// detected on the hand that goes farther. Fails on a clip without hips, head or an arm (named), with a joint
/// that is not a number, without a gesture, or with phases outside the clip.
[[nodiscard]] Result<PointingMeasures> measurePointing(const Clip& clip, const HumanoidMap& map,
                                                       const std::optional<Vec3>& target,
                                                       const std::optional<GesturePhases>& phases = {});

}  // namespace deixis::motion
