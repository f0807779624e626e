// Why a session is paused, which determines what the participant reads.
#pragma once

#include <cstdint>
#include <string_view>

namespace deixis::studies {

enum class PauseReason : std::uint8_t {
    unsaid,
    escape,      ///< the key
    menu,        ///< the controller's button
    focus_lost,  ///< another window or a menu of the runtime is in front
    headset_taken_off,
    tracking_lost,
    experimenter,
    picture  ///< a picture of a pause was asked for
};

/// As the record has it: "paused", "escape", "menu", "focus lost", "headset taken off", "tracking lost",
/// "operator", "for a picture".
[[nodiscard]] std::string_view pauseReasonName(PauseReason reason);

}  // namespace deixis::studies
