// The kinds of stations.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace deixis::studies {

enum class StationKind : std::uint8_t { desktop, headset, simulated, studio };

/// "desktop", "headset", "simulated", "studio": on the command line, in databases and in reports.
[[nodiscard]] std::string_view stationKindName(StationKind kind);
[[nodiscard]] std::optional<StationKind> stationKindNamed(std::string_view name);

}  // namespace deixis::studies
