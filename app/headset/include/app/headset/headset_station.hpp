// The headset station: a participant in VR through an OpenXR runtime, and the experimenter's window on the
// monitor.
//
// Everything that the participant sees and does in a frame is for its predicted display time. The trigger
// selects, the menu button pauses, and the recentre button held for a second makes the current place the
// layout's.
#pragma once

#include <memory>
#include <string>

#include "app/session/operator_feed.hpp"
#include "app/window/gl_window.hpp"
#include "assets/avatar/avatar.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

struct HeadsetStationOptions {
    std::string participant;
    std::string title;
    WindowSize window_size{1280, 900};
    double resolution_scale = 1.0;
    studies::HeadsetOptions study{};
    /// In the participant's language: how to take part, at the foot of the first pages; and what hangs before
    /// the face while sight of the room is lost.
    std::string hint = "Aim the ray at a button and pull the trigger.";
    std::string tracking_lost = "The headset has lost sight of the room. Look around slowly.";
    std::shared_ptr<const OperatorFeed> operator_feed{};  ///< what the session tells the experimenter
};

class HeadsetStation : public studies::Station {
  public:
    /// Fails with what a person can do about it: no runtime, no headset, no window. Never falls back to
    /// anything.
    [[nodiscard]] static Result<std::unique_ptr<HeadsetStation>> open(const assets::Avatar& avatar,
                                                                      const HeadsetStationOptions& options);
    ~HeadsetStation() override;

    [[nodiscard]] studies::StationInfo info() const override;
    /// The first call waits until somebody wears the headset (or the experimenter ends the session).
    [[nodiscard]] studies::InputFrame beginFrame() override;
    studies::FrameReport present(const studies::PresentedFrame& frame) override;
    /// Lets the runtime end its session, state by state.
    std::vector<studies::StationNote> close() override;
    [[nodiscard]] std::optional<Error> failure() const override;

  private:
    struct State;
    explicit HeadsetStation(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace deixis::app
