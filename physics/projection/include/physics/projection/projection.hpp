// Clips as the body can move: each is followed in the simulation, and what the body did is the new clip.
//
// The targets of the body's actuators are set 30 times a second. With the clip's angles as targets the body
// lags behind and sags. With feed-forward they are, for each hinge, with the clip's angle q and speed q' in
// the middle of the time for which the target stays,
//   target = q + (damping / stiffness) q' + bias / stiffness,
// bias being the torque that holds the hinge against gravity and what the speeds cause.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "physics/body/body.hpp"

namespace deixis::physics {

struct ProjectionSettings {
    bool feed_forward = true;
    double noise_rad = 0.0;  ///< SD of what is added to every target, each time that it is set
    std::uint64_t seed = 0;  ///< of that noise
};

/// A clip followed: what the body was told, and what it did.
struct Followed {
    std::vector<BodyState> states;                 ///< one every step_s, from the first frame's time
    std::vector<std::vector<double>> targets_rad;  ///< one every control_s, for each hinge
};

/// The clip is on the skeleton that the body was made for. The body is left in its last state. Fails on
/// numbers that are not finite and on another skeleton; what the body does is not looked at.
[[nodiscard]] Result<Followed> follow(Body& body, const motion::Clip& clip,
                                      const ProjectionSettings& settings);

/// How far elbows and wrists of the new clip are from those of the given one, over all frames.
struct Tracking {
    double mean_m = 0.0;
    double max_m = 0.0;
};

struct Projection {
    motion::Clip clip;  ///< as many frames as the given one, at its rate
    Tracking tracking;
    /// How the body's postures differ from the clip's (figure_pose.hpp), the largest of all frames.
    double fit_distance_m = 0.0;
    double beyond_limit_rad = 0.0;
    std::string beyond_limit_of{};  ///< the hinge; empty: all angles are within the limits
};

/// The clip as it is followed. Joints that the body does not have move as in the clip, and so do the hips of
/// a pinned body. Fails as follow() does, where a body on its feet falls, and where the simulation breaks
/// down.
[[nodiscard]] Result<Projection> project(Body& body, const motion::Clip& clip,
                                         const ProjectionSettings& settings);

}  // namespace deixis::physics
