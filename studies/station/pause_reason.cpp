#include "studies/station/pause_reason.hpp"

#include <array>
#include <cstddef>

namespace deixis::studies {

std::string_view pauseReasonName(PauseReason reason) {
    constexpr std::array<std::string_view, 8> names{
        "paused",        "escape",   "menu",         "focus lost", "headset taken off",
        "tracking lost", "operator", "for a picture"};
    static_assert(names.size() == static_cast<std::size_t>(PauseReason::picture) + 1);
    return names.at(static_cast<std::size_t>(reason));
}

}  // namespace deixis::studies
