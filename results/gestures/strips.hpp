// Motions as strips of poses over time.
#pragma once

#include <string>

#include "results/gestures/gesture_evaluation.hpp"

namespace deixis::results {

/// An SVG picture: loudness and words above, under them a row of figures for each strip, seen from the front,
/// on one axis of time; stretches with poses green, with styles red, as in figure 3 of Yoon et al. (2021).
[[nodiscard]] std::string stripsSvg(const GestureEvaluationPage& page);

}  // namespace deixis::results
