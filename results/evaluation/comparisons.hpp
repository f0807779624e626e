// Systems of an evaluation against each other.
#pragma once

#include <vector>

#include "results/evaluation/evaluation.hpp"

namespace deixis::results {

/// All pairs, in the order of SystemComparison's members.
[[nodiscard]] std::vector<SystemComparison> compareSystems(const std::vector<SystemEvaluation>& systems);

}  // namespace deixis::results
