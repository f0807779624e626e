#include "results/statistics/density.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace deixis::results {

namespace {

constexpr std::array<std::pair<BandwidthRule, std::string_view>, 3> rule_names{
    {{BandwidthRule::normal_reference, "normal-reference"},
     {BandwidthRule::scott, "scott"},
     {BandwidthRule::scott_covariance, "scott-covariance"}}};

Result<void> checkPoints(const Points& points) {
    if (points.empty()) return fail("", "a density needs points; there are none");
    const std::size_t d = points.front().size();
    if (d == 0) return fail("", "a density needs points of at least one dimension");
    for (const auto& point : points) {
        if (point.size() != d)
            return fail("", fmt::format("found a point of {} numbers among points of {}", point.size(), d));
        for (const double value : point)
            if (!std::isfinite(value))
                return fail("", fmt::format("found {}, expected finite numbers", value));
    }
    return {};
}

/// Sums of products of deviations, divided by n - 1.
Points sampleCovariance(const Points& points) {
    const std::size_t d = points.front().size();
    const auto n = static_cast<double>(points.size());
    std::vector<double> centre(d, 0.0);
    for (const auto& point : points)
        for (std::size_t j = 0; j < d; ++j) centre[j] += point[j] / n;
    Points covariance(d, std::vector<double>(d, 0.0));
    for (const auto& point : points)
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t k = 0; k < d; ++k)
                covariance[j][k] += (point[j] - centre[j]) * (point[k] - centre[k]) / (n - 1.0);
    return covariance;
}

/// Cholesky's factor; fails where the matrix is not positive definite, up to rounding.
Result<Points> lowerFactor(const Points& matrix) {
    const std::size_t d = matrix.size();
    Points lower(d, std::vector<double>(d, 0.0));
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t k = 0; k <= j; ++k) {
            double rest = matrix[j][k];
            for (std::size_t i = 0; i < k; ++i) rest -= lower[j][i] * lower[k][i];
            if (j != k) {
                lower[j][k] = rest / lower[k][k];
                continue;
            }
            if (!(rest > 1e-12 * matrix[j][j]))
                return fail("",
                            "the points lie in a subspace of fewer dimensions: no bandwidth can be estimated "
                            "from their spread",
                            "Give a bandwidth for each axis");
            lower[j][j] = std::sqrt(rest);
        }
    return lower;
}

}  // namespace

std::string_view bandwidthRuleName(BandwidthRule rule) {
    return rule_names[static_cast<std::size_t>(rule)].second;
}

Result<BandwidthRule> bandwidthRuleFromName(std::string_view name) {
    for (const auto& [rule, its_name] : rule_names)
        if (its_name == name) return rule;
    return fail("", fmt::format("unknown bandwidth rule '{}'", name),
                "Expected normal-reference, scott or scott-covariance");
}

GaussianDensity::GaussianDensity(Points points, std::vector<double> bandwidths, Points factor)
    : points_(std::move(points)), bandwidths_(std::move(bandwidths)), factor_(std::move(factor)) {
    scale_ = 1.0 / static_cast<double>(points_.size());
    for (std::size_t j = 0; j < factor_.size(); ++j)
        scale_ /= std::sqrt(2.0 * 3.14159265358979323846) * factor_[j][j];
}

Result<GaussianDensity> GaussianDensity::fit(Points points, const std::vector<double>& bandwidths) {
    if (auto checked = checkPoints(points); !checked) return tl::unexpected(checked.error());
    const std::size_t d = points.front().size();
    if (bandwidths.size() != d)
        return fail("",
                    fmt::format("found {} bandwidths for points of {} numbers, expected one for each axis",
                                bandwidths.size(), d));
    Points factor(d, std::vector<double>(d, 0.0));
    for (std::size_t j = 0; j < d; ++j) {
        if (!(bandwidths[j] > 0.0) || !std::isfinite(bandwidths[j]))
            return fail("", fmt::format("found bandwidth {}, expected a number above 0", bandwidths[j]));
        factor[j][j] = bandwidths[j];
    }
    return GaussianDensity(std::move(points), bandwidths, std::move(factor));
}

Result<GaussianDensity> GaussianDensity::fit(Points points, BandwidthRule rule) {
    if (auto checked = checkPoints(points); !checked) return tl::unexpected(checked.error());
    if (points.size() < 2)
        return fail("", "no bandwidth can be estimated from a single point",
                    "Give a bandwidth for each axis");
    const std::size_t d = points.front().size();
    const auto n = static_cast<double>(points.size());
    const double shrink = std::pow(n, -1.0 / (static_cast<double>(d) + 4.0));
    Points covariance = sampleCovariance(points);
    std::vector<double> bandwidths(d);
    for (std::size_t j = 0; j < d; ++j) {
        if (!(covariance[j][j] > 0.0))
            return fail(
                "",
                fmt::format("all points have the same value on axis {}: no bandwidth can be estimated",
                            j + 1),
                "Give a bandwidth for each axis");
        bandwidths[j] = shrink * std::sqrt(covariance[j][j]);
        if (rule == BandwidthRule::normal_reference) bandwidths[j] *= 1.06 * std::sqrt((n - 1.0) / n);
    }
    if (rule != BandwidthRule::scott_covariance) return fit(std::move(points), bandwidths);
    for (auto& row : covariance)
        for (double& value : row) value *= shrink * shrink;
    auto factor = lowerFactor(covariance);
    if (!factor) return tl::unexpected(factor.error());
    return GaussianDensity(std::move(points), std::move(bandwidths), std::move(*factor));
}

double GaussianDensity::operator()(const std::vector<double>& x) const {
    const std::size_t d = factor_.size();
    if (x.size() != d)
        throw std::invalid_argument("the density was requested at a point of another dimension");
    std::vector<double> z(d);
    double sum = 0.0;
    for (const auto& point : points_) {
        double squares = 0.0;
        for (std::size_t j = 0; j < d; ++j) {
            double rest = x[j] - point[j];
            for (std::size_t k = 0; k < j; ++k) rest -= factor_[j][k] * z[k];
            z[j] = rest / factor_[j][j];
            squares += z[j] * z[j];
        }
        sum += std::exp(-0.5 * squares);
    }
    return scale_ * sum;
}

}  // namespace deixis::results
