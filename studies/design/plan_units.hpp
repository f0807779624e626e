// What a stage's trials are made of, before they have an order: items met by levels.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "studies/design/plan.hpp"

namespace deixis::studies {

/// The levels of a design's factors.
struct DesignLevels {
    /// What one trial shows, as indices into TrialDesign::systems: each system by itself; pairwise each pair;
    /// parallel all of them, which is a single level.
    std::vector<std::vector<int>> shown;
    int layouts = 0;
    std::vector<int> bands;  ///< indices into Study::distances; {-1} where no balls are shown
};
[[nodiscard]] DesignLevels levelsOf(const Study& study, const Stage& design);

/// A trial in the making.
struct PlannedTrial {
    const TargetItem* item = nullptr;
    int shown = 0;   ///< of DesignLevels::shown
    int layout = 0;  ///< of TrialDesign::layouts
    int band = -1;   ///< of Study::distances
    int block = 0;
    bool is_catch = false;
    int repeat_of = -1;  ///< unit
};

/// A stage's trials but for repeats, with their blocks in the order of presentation. `items` as itemsNeeded()
/// says; `row` as in scoredTrials().
[[nodiscard]] std::vector<PlannedTrial> makeUnits(const Study& study, const Stage& stage,
                                                  const std::vector<const TargetItem*>& items, int row,
                                                  std::uint64_t seed);

}  // namespace deixis::studies
