// What human-like gestures share: how trunk and head take part, and how long the phases last.
#pragma once

#include "core/random.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"
#include "pointing_motion.hpp"
#include "pointing_posture.hpp"

namespace deixis::motion {

/// A demonstration before it is performed.
struct DemonstrationPlan {
    Vec3 target{0.0};
    std::uint64_t seed = 0;
    PointingMotion motion;
};

/// Trunk, shoulder girdle and head for a target; the arm's fields are left.
[[nodiscard]] PostureRequest bodyTakingPart(const PointingBody& body, const Vec3& target, Side hand,
                                            const BodyShareParameters& shares);

/// Durations, path bulges and the gaze at a target.
[[nodiscard]] PointingMotion humanTiming(const Vec3& target, Side hand, const TimingParameters& timing,
                                         Random& random);

/// The gesture of the demonstrations' actor at a target: with the actor's and a trial's error.
[[nodiscard]] DemonstrationPlan planDemonstration(const PointingBody& body, const Vec3& target, Side hand,
                                                  const DemonstrationParameters& parameters,
                                                  std::uint64_t seed);

/// The whole library's plans: left-handed ones first, then right-handed.
[[nodiscard]] std::vector<DemonstrationPlan> planLibrary(const PointingBody& body,
                                                         const DemonstrationParameters& parameters);

}  // namespace deixis::motion
