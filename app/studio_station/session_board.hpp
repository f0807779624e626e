// What is shown of a session, as its page is told.
#pragma once

#include <nlohmann/json.hpp>

#include "studies/station/station.hpp"

namespace deixis::app {

/// All but the revision, the work on a project and the time that is left.
[[nodiscard]] nlohmann::ordered_json sessionBoard(const studies::PresentedFrame& frame);

}  // namespace deixis::app
