// The figures of the evaluation's page; private to the evaluation.
#pragma once

#include "results/evaluation/evaluation.hpp"
#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// "Scott's rule ... [0.80, 0.36, 0.35] m", HTML.
[[nodiscard]] std::string bandwidthWords(const Evaluation& evaluation);

/// Accuracy by system as box plots, as the paper's Figure 9.
[[nodiscard]] Figure accuracyBoxes(const Evaluation& evaluation, Numbering& figures);
/// Differences of accuracy between each pair of systems. Some pair has a target in common.
[[nodiscard]] Figure accuracyDifferences(const Evaluation& evaluation, Numbering& figures);

/// Which of a profile's two courses.
enum class ProfileKind : unsigned char { reward, speed };
/// Mean and band of one standard deviation, by hand, as the paper's Figures 2 and 3, of
/// Evaluation::systems[index]; one scale for all systems.
[[nodiscard]] Figure profileFigure(const Evaluation& evaluation, std::size_t index, ProfileKind kind,
                                   Numbering& figures);

/// Accuracy against density, a point a clip, as Figure 10 A.
[[nodiscard]] Figure densityScatter(const Evaluation& evaluation, std::size_t index, Numbering& figures);

/// The test points in a view from the front and above, coloured by density, as Figure 8.
[[nodiscard]] Figure densitySpace(const Evaluation& evaluation, Numbering& figures);
/// Means of the density from above and from behind, with the training targets, as Figure 10 B.
[[nodiscard]] Figure densityMap(const Evaluation& evaluation, Numbering& figures);
/// Means of the systems' accuracy from above and from behind, as Figure 10 C; one scale for all.
[[nodiscard]] Figure accuracyMaps(const Evaluation& evaluation, Numbering& figures);

}  // namespace deixis::results
