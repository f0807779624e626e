// Where answers were given: at a desktop, in a headset, by simulated participants. They are analysed
// separately.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// The name under which simulated participants' answers stand, wherever they were given.
inline constexpr const char* simulated_station = "simulated";
/// The factor that the kinds of station are, of people.
inline constexpr const char* station_factor = "station";

/// The kinds of station of the answers that count, people's by name, simulated participants' last. Answers
/// whose station is not known are of a kind without a name.
[[nodiscard]] std::vector<std::string> stationKinds(const ResponseTable& table);

/// The answers given at one kind of station; without `kind` all of people. What was planned is then what was
/// answered, for plans do not tell at which station a session will be.
[[nodiscard]] ResponseTable onlyAt(ResponseTable table, const std::optional<std::string>& kind);

/// People's answers at all stations, which are a between-participants factor. Who sat at two kinds is in no
/// group. Simulated participants' answers go.
[[nodiscard]] ResponseTable withStations(ResponseTable table);

}  // namespace deixis::results
