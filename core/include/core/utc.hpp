// The time of day, as databases store it.
#pragma once

#include <chrono>

namespace deixis {

/// Seconds since 1970-01-01 00:00 UTC, by this machine's clock.
[[nodiscard]] inline double utcNow_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace deixis
