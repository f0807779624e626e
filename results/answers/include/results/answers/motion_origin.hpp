// Whether a system's motion is synthetic, as far as a study's generators and manifests tell.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// "synthetic": by rules or formulas; "learned from synthetic": by what learned from such; "synthetic or
/// learned from synthetic": made by this program, in a database that does not tell which; empty: nothing is
/// said of it.
[[nodiscard]] std::string motionText(const ResponseTable& table, const std::string& system);

/// Of all systems, in their order, those of which something is said; systems that are not compared come last.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> syntheticSystems(const ResponseTable& table);

}  // namespace deixis::results
