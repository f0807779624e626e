// The trials of one stage that shows clips.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "studies/design/plan.hpp"

namespace deixis::studies {

/// How many targets a participant needs for a stage that shows clips.
struct ItemNeed {
    int scored = 0;  ///< items of the design; of practice: of all its attempts
    int catches = 0;
    bool placed = false;  ///< whether they must have a place in the room
    bool balls = false;   ///< and distractors

    [[nodiscard]] int total() const { return scored + catches; }
};
/// Which stage's design a stage with clips follows: its own, or that of the stage which it practises.
[[nodiscard]] Result<const Stage*> designOf(const Study& study, const Stage& stage);

[[nodiscard]] ItemNeed itemsNeeded(const Stage& stage, const Stage& design);

/// Practice shows the systems in turn, from one practice stage to the next: a few trials then show them all.
/// By system, how often it has been practised, in an order that chance gave.
using PracticeTurns = std::vector<std::pair<std::string, int>>;

/// `items` as itemsNeeded() says, those for catch trials last; `row` is the participant's in Williams
/// squares, from 1. Trials are numbered from 0, as is TrialCheck::of_trial.
[[nodiscard]] Result<std::vector<Trial>> scoredTrials(const Study& study, const Stage& stage,
                                                      const std::vector<const TargetItem*>& items, int row,
                                                      std::uint64_t seed);
/// Of a stage that mirrorsConditions(), from all targets.
[[nodiscard]] Result<std::vector<Trial>> authoredTrials(const Study& study, const Stage& stage,
                                                        const std::vector<TargetItem>& targets, int row,
                                                        std::uint64_t seed);
[[nodiscard]] Result<std::vector<Trial>> practiceTrials(const Study& study, const Stage& stage,
                                                        const std::vector<const TargetItem*>& items,
                                                        PracticeTurns& turns, std::uint64_t seed);

}  // namespace deixis::studies
