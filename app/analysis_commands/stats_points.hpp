// `deixis stats kde` and `meanshift`: rows of a table as points.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "stats_table.hpp"

namespace deixis::app {

struct DensityOptions {
    std::string bandwidth =
        "normal-reference";  ///< a rule's name, or one number for each column, as in 0.1,0.2
    std::string
        at{};  ///< CSV file of the points at which the density is wanted; empty: the points themselves
};

/// n, n_missing, dimensions, rule, bandwidths, densities (in the order of the rows, null where one is
/// missing).
[[nodiscard]] Result<nlohmann::ordered_json> statsDensity(const StatsTable& table,
                                                          const DensityOptions& options);

struct ClusterOptions {
    std::string bandwidth = "auto";  ///< or a number above 0
    double quantile = 0.3;           ///< of the estimate, in (0, 1]
};

/// n, n_missing, dimensions, bandwidth, clusters, centres and counts (largest first), labels (of each row,
/// from 0; null where a cell is missing).
[[nodiscard]] Result<nlohmann::ordered_json> statsMeanShift(const StatsTable& table,
                                                            const ClusterOptions& options);

}  // namespace deixis::app
