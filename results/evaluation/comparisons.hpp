// Systems of an evaluation against each other.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "results/evaluation/evaluation.hpp"

namespace deixis::results {

/// A system's clips at one target that have an accuracy.
struct AtTarget {
    std::vector<double> accuracy;
    std::vector<double> error_deg;
};
/// By the target's place: manifests may name one place differently.
using ByTarget = std::map<std::tuple<double, double, double>, AtTarget>;
[[nodiscard]] ByTarget byTarget(const SystemEvaluation& system);

/// All pairs, in the order of SystemComparison's members.
[[nodiscard]] std::vector<SystemComparison> compareSystems(const std::vector<SystemEvaluation>& systems);

}  // namespace deixis::results
