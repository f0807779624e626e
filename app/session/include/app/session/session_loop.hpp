// The main loop of a session: station -> session -> station, and its events to the recorders.
#pragma once

#include "studies/session/session.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

/// Keeps what happens.
class Recorder {
  public:
    virtual ~Recorder() = default;
    /// Called in the order of happening.
    virtual void record(const studies::SessionEvent& event) = 0;
    virtual void sample(const studies::TrackingSample& sample, int trial_index) = 0;
    /// Whether every answer given so far is on the disk; the next trial does not begin before.
    [[nodiscard]] virtual bool answersKept() const = 0;
    /// Why nothing more can be kept; empty: nothing is wrong.
    [[nodiscard]] virtual std::string failure() const { return {}; }
    /// Called once, when the session is over: waits until all is kept.
    virtual void finish() {}
    /// Told of every frame as it was presented.
    virtual void presented(const studies::InputFrame&, const studies::PresentedFrame&) {}
};

/// Runs until the session has an outcome; where nothing more can be kept that is soon. Returns the last
/// frame's time.
studies::Moment runSession(studies::SessionRunner& session, studies::Station& station, Recorder& recorder);

}  // namespace deixis::app
