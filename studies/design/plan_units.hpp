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

/// Whether participants of mirrored conditions can get the same items: authoring in blocks of systems, in the
/// order of a Williams square, whose items are nested in them and divide by them.
[[nodiscard]] bool mirrorsConditions(const Stage& stage);
/// The trials of such a stage in their order, where no other stage takes of the targets: over the
/// participants of a square (two for two systems) every item that counts is met by every system. `row` as
/// above. The items that count go round, so that all of them come equally often.
[[nodiscard]] std::vector<PlannedTrial> mirroredTrials(const Study& study, const Stage& stage,
                                                       const std::vector<TargetItem>& targets, int row);

}  // namespace deixis::studies
