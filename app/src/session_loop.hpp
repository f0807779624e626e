// The main loop of a session: station -> session -> station, and what happened to whoever keeps it.
#pragma once

#include <functional>

#include "studies/session.hpp"
#include "studies/station.hpp"

namespace deixis::app {

/// Keeps one event; called in the order of happening. An answer must be durable when it returns.
using Recorder = std::function<void(const studies::SessionEvent&)>;

/// Runs until the session has finished or was ended. Returns the last frame's time.
studies::Moment runSession(studies::SessionRunner& session, studies::Station& station,
                           const Recorder& record);

}  // namespace deixis::app
