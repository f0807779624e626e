// The statistical tests of `deixis stats`: from the columns of a table to one JSON object each.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "results/statistics/rational.hpp"
#include "stats_table.hpp"

namespace deixis::app {

struct StatsOptions {
    double level = 0.95;                        ///< of intervals
    std::optional<results::Rational> chance{};  ///< of a proportion
    int resamples = 10000;                      ///< of a bootstrap
    std::uint64_t seed = 1;                     ///< likewise
};

/// What every test's object begins with: its name and the columns'.
[[nodiscard]] nlohmann::ordered_json statsObject(const StatsTable& table, const std::string& test);

/// Undefined values are null, and `note` says why. The keys stand in docs/statistics.md. Errors: too few or
/// too many columns, cells that the test cannot take.
using StatsTest = Result<nlohmann::ordered_json> (*)(const StatsTable& table, const StatsOptions& options);

[[nodiscard]] Result<nlohmann::ordered_json> statsSignedRank(const StatsTable& table,
                                                             const StatsOptions& options);
[[nodiscard]] Result<nlohmann::ordered_json> statsRankSum(const StatsTable& table,
                                                          const StatsOptions& options);
[[nodiscard]] Result<nlohmann::ordered_json> statsFriedman(const StatsTable& table,
                                                           const StatsOptions& options);
/// Of one column, or of the differences of two.
[[nodiscard]] Result<nlohmann::ordered_json> statsShapiro(const StatsTable& table,
                                                          const StatsOptions& options);
[[nodiscard]] Result<nlohmann::ordered_json> statsSpearman(const StatsTable& table,
                                                           const StatsOptions& options);
[[nodiscard]] Result<nlohmann::ordered_json> statsHolm(const StatsTable& table, const StatsOptions& options);
/// Means of each column, and of the differences of each pair of them.
[[nodiscard]] Result<nlohmann::ordered_json> statsBootstrap(const StatsTable& table,
                                                            const StatsOptions& options);
[[nodiscard]] Result<nlohmann::ordered_json> statsProportion(const StatsTable& table,
                                                             const StatsOptions& options);
/// Of one column the numbers themselves; of several an object of such objects by name.
[[nodiscard]] Result<nlohmann::ordered_json> statsDescribe(const StatsTable& table,
                                                           const StatsOptions& options);

}  // namespace deixis::app
