// Box plots of clips' accuracy, Equation 2 of Deichler et al. (2023), in the evaluation's scale.
#pragma once

#include <string>
#include <vector>

#include "results/page/figure_boxes.hpp"

namespace deixis::results {

/// The scale goes from the least accuracy, to the 0.05 below, past the ceiling; the angles that accuracies
/// mean stand on the right. Of many clips points stand for some: BoxPlot::max_points.
[[nodiscard]] BoxPlot accuracyBoxPlot(std::vector<BoxPlot::Box> boxes);

/// Three decimals.
[[nodiscard]] std::string accuracyText(double value);

}  // namespace deixis::results
