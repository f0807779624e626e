// Training targets in groups, each of which has a policy of its own (Deichler et al. 2023, section 2.2.2).
#pragma once

#include <optional>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "learning/training/training.hpp"

namespace deixis::learning {

/// Scott's rule (1992) for a spread of points, the mean over the axes. Fails where they have none.
[[nodiscard]] Result<double> scottBandwidth_m(const std::vector<Vec3>& points);

/// The paper's bandwidth, which it says to be Scott's for the univariate estimate.
constexpr double paper_bandwidth_m = 0.78;

/// The cluster of each demonstration, numbered from 0.
struct AmpClusters {
    int count = 1;
    double bandwidth_m = 0.0;  ///< 0: they were not clustered, as there is one alone
    std::vector<int> training{};
    std::vector<int> validation{};
};

/// MeanShift (results/statistics) of the targets as given, before any was mirrored; a mirrored demonstration
/// joins the cluster of the nearest of them. Without a bandwidth the paper's, where it gives `count`
/// clusters, else the widest whole number of centimetres that does; with a bandwidth and no count as many as
/// it makes; with neither one. Fails where the count cannot be made or the bandwidth makes another, and where
/// a cluster is left without a demonstration to train on.
[[nodiscard]] Result<AmpClusters> clustersOf(const DemonstrationSets& data, std::optional<int> count,
                                             std::optional<double> bandwidth_m);

}  // namespace deixis::learning
