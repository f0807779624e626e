// What a session presents, as a scene to draw.
#pragma once

#include <string>

#include "renderer/scene.hpp"
#include "studies/station.hpp"

namespace deixis::app {

/// The scene of a frame, seen from `stage_from_eye`. Its first board is the panel, where there is one.
[[nodiscard]] renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame,
                                             const Pose& stage_from_eye);

/// A small board with a sentence to the participant, in lines of this height.
[[nodiscard]] renderer::Board noticeBoard(const std::string& sentence, double line_m);

/// On a screen: the frame's notice, if it has one, above the middle of the view and before all else.
void addNotice(renderer::Scene& scene, const std::string& notice);

/// Whether this frame's panel should say how to take part: a page of instructions or consent, the welcome
/// back, and a pause.
[[nodiscard]] bool explainsControls(const studies::PresentedFrame& frame);

/// Adds a faint line under what the board says; the rest of it stays where it is in the world.
void addFootLine(renderer::Board& board, const std::string& words);

}  // namespace deixis::app
