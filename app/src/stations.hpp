// Making the station that a command asks for.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assets/avatar.hpp"
#include "core/error.hpp"
#include "studies/plan.hpp"
#include "studies/simulated_participant.hpp"
#include "studies/station.hpp"
#include "studies/study.hpp"

namespace deixis::app {

/// Pictures wanted of states of a session: state name -> PNG file.
using Screenshots = std::map<std::string, std::string>;

struct StationRequest {
    std::string kind = "desktop";  ///< "desktop" or "simulated"
    std::string size;  ///< "WIDTHxHEIGHT" of the window or of what the simulated participant sees; or empty
    bool fullscreen = false;
    std::string simulated_parameters;
    Screenshots screenshots;  ///< simulated station only
};

/// Opens the station. The simulated one draws each key moment and several frames a second through the same
/// renderer as the desktop, off screen, where the program was built with it.
[[nodiscard]] Result<std::unique_ptr<studies::Station>> openStation(const StationRequest& request,
                                                                    const studies::Study& study,
                                                                    const studies::StudyPlan& plan,
                                                                    const assets::Avatar& avatar);

}  // namespace deixis::app
