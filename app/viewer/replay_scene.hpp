// A moment of a recorded trial as a scene to draw.
#pragma once

#include "renderer/scene/scene.hpp"
#include "studies/session/replay.hpp"

namespace deixis::app {

/// A camera that goes round the middle between participant and avatar.
struct OutsideView {
    double azimuth_rad = radiansFromDegrees(65.0);  ///< from behind the participant, towards their right
    double elevation_rad = radiansFromDegrees(18.0);
    double distance_m = 4.6;
};

/// As the participant saw it. Where the head was not tracked, from where it was at the answer.
[[nodiscard]] renderer::Scene sceneByTheirEyes(const studies::TrialReplay& replay,
                                               const studies::RecordedTrial& trial, double time_s);

/// From outside, with the participant's head, and the ways of head and hand over the `trail_s` before.
[[nodiscard]] renderer::Scene sceneFromOutside(const studies::TrialReplay& replay,
                                               const studies::RecordedTrial& trial, double time_s,
                                               const OutsideView& view, double trail_s);

}  // namespace deixis::app
