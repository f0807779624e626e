// Multivariate Gaussian kernel density estimates, with the bandwidth conventions of common libraries.
#pragma once

#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

/// Points of one dimension d >= 1: every row has d finite numbers.
using Points = std::vector<std::vector<double>>;

/// How a bandwidth is found from n points in d dimensions.
enum class BandwidthRule : unsigned char {
    /// h_j = 1.06 s_j n^(-1/(d+4)), s_j with division by n: statsmodels' KDEMultivariate, "normal_reference".
    normal_reference,
    /// h_j = s_j n^(-1/(d+4)), s_j with division by n - 1 (Scott 1992, equation 6.42).
    scott,
    /// H = n^(-2/(d+4)) S, S the sample covariance, all of it: SciPy's gaussian_kde with its default.
    scott_covariance,
};
[[nodiscard]] std::string_view bandwidthRuleName(BandwidthRule rule);  ///< "normal-reference", "scott", ...
[[nodiscard]] Result<BandwidthRule> bandwidthRuleFromName(std::string_view name);

/// f(x) = 1/n sum_i N(x; x_i, H): a normal kernel on each point.
class GaussianDensity {
  public:
    /// With one bandwidth (standard deviation of the kernel) for each axis: H is diagonal. Fails if there
    /// are no points, rows differ in length, a number is not finite or a bandwidth not above 0.
    [[nodiscard]] static Result<GaussianDensity> fit(const Points& points,
                                                     const std::vector<double>& bandwidths);
    /// With the bandwidths of a rule. Fails further where there are fewer than two points, or where they lie
    /// in a plane of fewer dimensions (an axis without spread).
    [[nodiscard]] static Result<GaussianDensity> fit(const Points& points, BandwidthRule rule);

    /// The density at a point of d numbers, in 1 / unit^d. Throws std::invalid_argument on another length.
    [[nodiscard]] double operator()(const std::vector<double>& x) const;

    /// The kernel's standard deviation along each axis: the square roots of H's diagonal.
    [[nodiscard]] const std::vector<double>& bandwidths() const { return bandwidths_; }

  private:
    GaussianDensity(const Points& points, std::vector<double> bandwidths, std::vector<double> factor);

    std::vector<double> bandwidths_;
    std::vector<double> factor_;  ///< lower triangle L with H = L L^T, column by column
    std::vector<double> white_;   ///< L^-1 of the points, one after the other
    double scale_ = 1.0;
};

}  // namespace deixis::results
