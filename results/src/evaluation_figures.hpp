// The figures of the evaluation's page, each an SVG element.
#pragma once

#include <string>

#include "results/evaluation.hpp"

namespace deixis::results {

/// The greatest value of Equation 2: (e - 1)/e.
inline constexpr double reward_ceiling = 0.63212055882855767;

/// Accuracy by system as box plots, as the paper's Figure 9; lying, so that names and narrow screens fit.
[[nodiscard]] std::string accuracyBoxesSvg(const Evaluation& evaluation);

/// Which of a profile's two courses.
enum class ProfileKind : unsigned char { accuracy, speed };
/// Mean and band of one standard deviation, by hand, as the paper's Figures 2 and 3. `index` names the
/// system.
[[nodiscard]] std::string profileSvg(const Evaluation& evaluation, std::size_t index, ProfileKind kind);

/// Accuracy against density, a point a clip, as Figure 10 A.
[[nodiscard]] std::string densityScatterSvg(const Evaluation& evaluation, std::size_t index);

/// The test points in a view from the front and above, coloured by density, as Figure 8.
[[nodiscard]] std::string densityGridSvg(const Evaluation& evaluation);

/// Density over x and z, mean over y, with the training targets, as Figure 10 B.
[[nodiscard]] std::string densityMapSvg(const Evaluation& evaluation);
/// A system's accuracy over x and z, mean over y, as Figure 10 C; one colour scale for all systems.
[[nodiscard]] std::string accuracyMapSvg(const Evaluation& evaluation, std::size_t index);

}  // namespace deixis::results
