// Figures of the reproduction's page: the paper's means beside ours.
#pragma once

#include <string>

#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"
#include "results/reproduction/reproduction.hpp"

namespace deixis::results {

/// Box plots of Equation 2, and the paper's means. `name` is Figure::name.
[[nodiscard]] Figure accuracyBesidePaper(const GridFigures& grid, const std::string& name,
                                         Numbering& figures);
/// Means of "accuracy" or "naturalness" with their intervals by each kind of participants, and the paper's.
[[nodiscard]] Figure studyBesidePaper(const ReproductionInput& input, const std::string& measure,
                                      Numbering& figures);

/// Accuracy on the first grid against the arm's distance from the held-out demonstrations', a point for each
/// trained system.
[[nodiscard]] Figure accuracyAndImitation(const ReproductionInput& input, Numbering& figures);

}  // namespace deixis::results
