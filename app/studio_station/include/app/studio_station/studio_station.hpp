// The studio's page as a station: a participant reads and fills in boards in a browser, and makes gestures
// there (Yoon et al. 2021, 7.1).
#pragma once

#include <memory>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

struct StudioStationOptions {
    int port = 0;  ///< 0: a free one
    bool open_browser = true;
    std::string participant;
};

/// A server of the studio whose page is in the session, on this machine alone. Prints the address with its
/// token, and opens it. Ctrl-C and SIGTERM end the session as closing a window does. A frame begins 20 times
/// a second, and when the page tells something; it counts as shown once a page has it.
class StudioStation : public studies::Station {
  public:
    /// `study` in the language that is shown; its avatar as it was loaded. Errors: the port is in use, or
    /// this build has no page.
    [[nodiscard]] static Result<std::unique_ptr<StudioStation>> open(const StudioStationOptions& options,
                                                                     const studies::Study& study,
                                                                     const assets::Avatar& avatar);
    ~StudioStation() override;
    [[nodiscard]] studies::StationInfo info() const override;
    [[nodiscard]] studies::InputFrame beginFrame() override;
    studies::FrameReport present(const studies::PresentedFrame& frame) override;
    std::vector<studies::StationNote> close() override;

  private:
    struct State;
    explicit StudioStation(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace deixis::app
