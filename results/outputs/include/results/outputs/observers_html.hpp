// How the pages show what simulated observers read; private to results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/answers/observers.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// Where the observers agree and where they do not: how far each system's accuracy depends on the observer,
/// and which one gives which ranking. One list item of the findings, HTML; empty without readings.
[[nodiscard]] std::string observersFinding(const std::vector<ObserverReading>& readings);

/// The table, with what no reader can exceed. `trials`: what is counted in it, "choices" or "clips and
/// places".
[[nodiscard]] std::string observersTable(const std::vector<ObserverReading>& readings, const char* trials,
                                         Numbering& tables);

/// A sentence on nearest demonstrations, HTML text.
[[nodiscard]] std::string nearestText(const NearestCeiling& ceiling);

}  // namespace deixis::results
