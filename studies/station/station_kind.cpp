#include "studies/station/station_kind.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace deixis::studies {

namespace {

constexpr std::array<std::string_view, 4> station_names{"desktop", "headset", "simulated", "studio"};

}  // namespace

std::string_view stationKindName(StationKind kind) {
    return station_names.at(static_cast<std::size_t>(kind));
}

std::optional<StationKind> stationKindNamed(std::string_view name) {
    const auto* const found = std::find(station_names.begin(), station_names.end(), name);
    if (found == station_names.end()) return std::nullopt;
    return static_cast<StationKind>(found - station_names.begin());
}

}  // namespace deixis::studies
