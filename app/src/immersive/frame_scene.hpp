// What a session presents, as a scene to draw.
#pragma once

#include "renderer/scene.hpp"
#include "studies/station.hpp"

namespace deixis::app {

/// The scene of a frame, seen from `stage_from_eye`.
[[nodiscard]] renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame,
                                             const Pose& stage_from_eye);

}  // namespace deixis::app
