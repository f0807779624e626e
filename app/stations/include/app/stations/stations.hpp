// Making the station that a command needs.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/session/operator_feed.hpp"
#include "app/session/screenshots.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "speech/sound/sound.hpp"
#include "studies/design/plan.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

struct StationRequest {
    studies::StationKind kind = studies::StationKind::desktop;
    std::string size;  ///< "WIDTHxHEIGHT" of the window or of what the simulated participant sees; or empty
    bool fullscreen = false;
    bool operator_window = false;  ///< desktop: the experimenter's beside the participant's
    std::shared_ptr<const OperatorFeed> operator_feed{};  ///< what the session tells the experimenter
    int port = 0;                                         ///< studio: 0: a free one
    bool no_browser = false;                              ///< studio: none is opened
    double resolution_scale = 1.0;  ///< headset: of the size that the runtime recommends
    std::string simulated_parameters;
    /// What is heard with the clips, by ClipSound::id; empty: nothing is. Simulated participants hear
    /// nothing.
    std::map<std::string, speech::Sound> sounds{};
    std::shared_ptr<Screenshots> screenshots = std::make_shared<Screenshots>();  ///< simulated only
};

/// Opens the station. The simulated one draws nothing but the pictures wanted, by the desktop's renderer.
[[nodiscard]] Result<std::unique_ptr<studies::Station>> openStation(const StationRequest& request,
                                                                    const studies::Study& study,
                                                                    const studies::StudyPlan& plan,
                                                                    const assets::Avatar& avatar);

}  // namespace deixis::app
