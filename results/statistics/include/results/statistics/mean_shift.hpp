// MeanShift clusters (Comaniciu & Meer 2002) with a flat kernel, by the conventions of scikit-learn's
// MeanShift(bin_seeding=False, cluster_all=True): the same labels and centres.
#pragma once

#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct MeanShiftClusters {
    std::vector<std::vector<double>> centres;  ///< the one with the most points within the bandwidth first
    std::vector<int> labels;                   ///< of each point: its nearest centre
};

/// From every point the mean of all points within `bandwidth` (ends included) is taken, and again from there,
/// until it moves by less than a thousandth of the bandwidth, or 300 times. Of means within a bandwidth of
/// each other the one with the most points stays. Rows hold the same number of finite numbers. Fails on no
/// points, rows of different length, or a bandwidth that is not above 0.
[[nodiscard]] Result<MeanShiftClusters> meanShift(const std::vector<std::vector<double>>& points,
                                                  double bandwidth);

/// scikit-learn's estimate_bandwidth: the mean over the points of the distance to the k-th nearest, the
/// point itself being the first; k = floor(quantile n), at least 1. `quantile` in (0, 1]. 0 if all such
/// neighbours coincide.
[[nodiscard]] double estimateBandwidth(const std::vector<std::vector<double>>& points, double quantile = 0.3);

}  // namespace deixis::results
