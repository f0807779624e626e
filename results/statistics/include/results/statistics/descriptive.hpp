// Means, spreads and quantiles.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "results/statistics/rational.hpp"

namespace deixis::results {

[[nodiscard]] double mean(std::span<const double> x);            ///< 0 of no values
[[nodiscard]] double sampleSd(std::span<const double> x);        ///< n - 1; 0 for fewer than two
[[nodiscard]] double quantile(std::vector<double> x, double q);  ///< R's type 7; 0 of no values
/// Likewise, of values that are sorted already.
[[nodiscard]] double quantileOfSorted(std::span<const double> sorted, double q);

/// The exact mean; of at least one value.
[[nodiscard]] Rational exactMean(std::span<const Rational> x);

/// Sums, differences and quantiles are exact; only the results are rounded, to the nearest double.
struct Description {
    int n = 0;
    std::optional<double> mean{};  ///< this and all below: none of no values
    std::optional<double> sd{};    ///< n - 1; none for fewer than two values
    std::optional<double> se{};    ///< sd / sqrt(n); likewise
    std::optional<double> min{}, q05{}, q25{}, median{}, q75{}, q95{}, max{};  ///< quantiles of type 7
    /// 1.4826 times the median of the distances from the median, as R's mad().
    std::optional<double> mad{};
};

[[nodiscard]] Description describe(std::span<const Rational> x);

/// What a box plot draws; quantiles of type 7.
struct BoxSummary {
    int n = 0;
    double mean = 0.0;
    double median = 0.0;
    double q25 = 0.0, q75 = 0.0;  ///< the box
    double q05 = 0.0, q95 = 0.0;  ///< the whiskers' ends
    /// The median's notch, -+ 1.57 (q75 - q25) / sqrt(n): where those of two samples do not overlap, their
    /// medians differ at about 5 % (McGill, Tukey & Larsen 1978). May reach beyond the box.
    double notch_low = 0.0, notch_high = 0.0;

    /// Whether the notch lies within the box; beyond it it would fold back, and is not drawn.
    [[nodiscard]] bool notched() const { return notch_low >= q25 && notch_high <= q75; }
};

[[nodiscard]] std::optional<BoxSummary> boxSummary(const std::vector<double>& x);  ///< none of no values

}  // namespace deixis::results
