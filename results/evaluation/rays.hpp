// How far off the target each pointing ray is, side by side; private to the evaluation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/evaluation/evaluation.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// The rays that are compared, forearm (the paper's) first.
inline constexpr std::array compared_rays{motion::PointingRay::forearm,
                                          motion::PointingRay::elbow_fingertip,
                                          motion::PointingRay::index_finger,
                                          motion::PointingRay::shoulder_hand,
                                          motion::PointingRay::shoulder_fingertip,
                                          motion::PointingRay::eye_fingertip};

/// Angles to the target of a system's clips that have the ray, degrees.
[[nodiscard]] std::vector<double> rayErrors_deg(const SystemEvaluation& system, motion::PointingRay ray);

/// An item of the list at the page's head: which system each ray puts first and last.
[[nodiscard]] std::string raysFinding(const Evaluation& evaluation);

[[nodiscard]] std::string raysHtml(const Evaluation& evaluation, Numbering& tables);

}  // namespace deixis::results
