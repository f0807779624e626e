// How nested levels are shared out over items.
#pragma once

#include <vector>

#include "core/random.hpp"

namespace deixis::studies {

/// For each of `count` items one level (0..n-1) of every factor, where `levels` holds each factor's n. A
/// factor's levels come equally often, to within one, and so do the combinations of any two factors; with
/// three, as nearly as a search finds. Chance decides which levels are the odd ones out and which item gets
/// what.
[[nodiscard]] std::vector<std::vector<int>> counterbalanceLevels(const std::vector<int>& levels, int count,
                                                                 Random& random);

}  // namespace deixis::studies
