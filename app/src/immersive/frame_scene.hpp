// What a session presents, as a scene to draw.
#pragma once

#include <string>

#include "renderer/scene.hpp"
#include "studies/station.hpp"

namespace deixis::app {

/// The scene of a frame, seen from `stage_from_eye`.
[[nodiscard]] renderer::Scene sceneFromFrame(const studies::PresentedFrame& frame,
                                             const Pose& stage_from_eye);

/// Whether this frame's board should say how to take part: the first page, and a pause.
[[nodiscard]] bool explainsControls(const studies::PresentedFrame& frame);

/// Adds a faint line under what the board says; the rest of it stays where it is in the world.
void addFootLine(renderer::Board& board, const std::string& words);

}  // namespace deixis::app
