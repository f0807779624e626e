// Drawing what a simulated participant sees: the same scene and renderer as the desktop's, off screen.
#pragma once

#include <string>

#include "assets/avatar.hpp"
#include "core/error.hpp"
#include "stations.hpp"
#include "studies/simulated_participant.hpp"

namespace deixis::app {

/// Attaches a renderer without a window to the station. `size` is "WIDTHxHEIGHT" or empty. Pictures are taken
/// of the first frame that is in the named state, a moment after it began so that what fades has settled.
[[nodiscard]] Result<void> drawSimulation(studies::SimulatedStation& station, const assets::Avatar& avatar,
                                          const std::string& size, const Screenshots& screenshots);

}  // namespace deixis::app
