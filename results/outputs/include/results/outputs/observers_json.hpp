// What simulated observers read, as JSON; private to results.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "results/answers/observers.hpp"

namespace deixis::results {

/// One object for each reading: system, layout, trials, and by observer "accuracy" and "without_error".
[[nodiscard]] nlohmann::ordered_json readingsJson(const std::vector<ObserverReading>& readings);

}  // namespace deixis::results
