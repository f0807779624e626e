// What a session presents, as a scene to draw.
#pragma once

#include <string>

#include "renderer/scene/scene.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

/// The scene of a frame, seen from `stage_from_eye`. Its first board is the panel, where there is one.
[[nodiscard]] renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame,
                                             const Pose& stage_from_eye);

/// A small board with a sentence to the participant, in lines of this height.
[[nodiscard]] renderer::Board noticeBoard(const std::string& sentence, double line_m);

/// On a screen: the frame's notice, if it has one, above the middle of the view and before all else, or where
/// it hides no ball of the scene.
void addNotice(renderer::Scene& scene, const std::string& notice);

}  // namespace deixis::app
