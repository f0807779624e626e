// Pictures of what a simulated participant sees: the same scene and renderer as the desktop's, off screen.
#pragma once

#include <memory>
#include <string>

#include "app/session/screenshots.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::app {

/// Attaches a renderer without a window to the station, where `screenshots` wants pictures. `size` is
/// "WIDTHxHEIGHT" or empty. A picture is taken of each state wanted, when it first comes and the participant
/// has turned to it.
[[nodiscard]] Result<void> drawSimulation(studies::SimulatedStation& station, const assets::Avatar& avatar,
                                          const std::string& size,
                                          const std::shared_ptr<Screenshots>& screenshots);

}  // namespace deixis::app
