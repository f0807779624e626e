// The balls of a trial that shows its target among distractors; private to studies.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "studies/design/plan.hpp"

namespace deixis::studies {

/// Puts the item's balls of a band (of Study::distances) into the trial, in an order of chance.
void drawBalls(Trial& trial, const Study& study, const TargetItem& item, int band, Random& random);

/// What is seen of the balls, and how far the distractors look from the target, of all trials that have any.
void noteBalls(const Study& study, std::vector<Trial>& trials);

/// Trial::distractors, the balls as shown, and which of them is the target.
[[nodiscard]] std::vector<KeptValue> ballValues(const Trial& trial);

}  // namespace deixis::studies
