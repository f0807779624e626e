// The games of a study that the clips were made for; private to the evaluation.
#pragma once

#include "core/error.hpp"
#include "results/evaluation/evaluation.hpp"

namespace deixis::results {

/// Lets observers read every clip for whose target the study has a game, in each of its layouts, and finds
/// what nearest demonstrations could reach. Nothing without a study; fails where no clip is for one of its
/// targets.
[[nodiscard]] Result<void> readGames(Evaluation& evaluation);

}  // namespace deixis::results
