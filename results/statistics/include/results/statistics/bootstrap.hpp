// Bootstrap intervals, resampling whole participants: of means, and what other estimates' intervals need.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace deixis::results {

struct BootstrapOptions {
    int resamples = 10000;  ///< at least 1
    std::uint64_t seed = 1;
    double level = 0.95;  ///< between 0 and 1
};

struct BootstrapInterval {
    double lower = 0.0;
    double upper = 0.0;
};

/// Of one column. Nothing is estimated of a column without values, or of values whose sums exceed a double.
struct BootstrapMean {
    int n = 0;  ///< participants with a value
    std::optional<double> estimate{};
    std::optional<double> se{};                     ///< standard deviation of the resampled means
    std::optional<BootstrapInterval> percentile{};  ///< type-7 quantiles of the resampled means
    /// Bias-corrected and accelerated (Efron 1987): the bias from the share of resampled means below the
    /// estimate, equal ones counting half; the acceleration from the jackknife. None if that share is 0 or
    /// 1.
    std::optional<BootstrapInterval> bca{};
};

/// `rows`: one a participant, all of one length; NaN where a value is missing. A resample draws as many
/// participants as there are, with replacement, the same ones for all columns; its mean of a column is over
/// the values drawn, and a resample without any is skipped. The same seed gives the same result on every
/// machine.
[[nodiscard]] std::vector<BootstrapMean> bootstrapMeans(std::span<const std::vector<double>> rows,
                                                        const BootstrapOptions& options);

/// The acceleration of BCa intervals from the jackknife. `influences`: of each participant, the mean of the
/// estimates that leave out one participant less the one that leaves out this one.
[[nodiscard]] double bootstrapAcceleration(std::span<const double> influences);

/// The BCa interval of an estimate; see BootstrapMean::bca. `sorted`: the resampled estimates, at least one;
/// those within `allowance` of the estimate count as equal to it.
[[nodiscard]] std::optional<BootstrapInterval> correctedInterval(const std::vector<double>& sorted,
                                                                 double estimate, double acceleration,
                                                                 double allowance, double level);

}  // namespace deixis::results
