#include "results/statistics/density.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/pose.hpp"

namespace deixis::results {

namespace {

using Eigen::MatrixXd;
using MatrixOf = Eigen::Map<const MatrixXd>;
using VectorOf = Eigen::Map<const Eigen::VectorXd>;

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

/// A column for each point.
MatrixXd matrixOf(const Points& points) {
    MatrixXd out(points.front().size(), points.size());
    for (Eigen::Index i = 0; i < out.cols(); ++i)
        out.col(i) = VectorOf(points[static_cast<std::size_t>(i)].data(), out.rows());
    return out;
}

MatrixXd sampleCovariance(const Points& points) {
    const MatrixXd all = matrixOf(points);
    const MatrixXd off = all.colwise() - all.rowwise().mean();
    return off * off.transpose() / static_cast<double>(points.size() - 1);
}

std::vector<double> numbersOf(const MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
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

GaussianDensity::GaussianDensity(const Points& points, std::vector<double> bandwidths,
                                 std::vector<double> factor)
    : bandwidths_(std::move(bandwidths)), factor_(std::move(factor)) {
    const auto d = static_cast<Eigen::Index>(bandwidths_.size());
    const MatrixOf lower(factor_.data(), d, d);
    white_ = numbersOf(lower.triangularView<Eigen::Lower>().solve(matrixOf(points)));
    scale_ =
        1.0 / (static_cast<double>(points.size()) * (std::sqrt(2.0 * pi) * lower.diagonal().array()).prod());
}

Result<GaussianDensity> GaussianDensity::fit(const Points& points, const std::vector<double>& bandwidths) {
    if (auto checked = checkPoints(points); !checked) return tl::unexpected(checked.error());
    const std::size_t d = points.front().size();
    if (bandwidths.size() != d)
        return fail("",
                    fmt::format("found {} bandwidths for points of {} numbers, expected one for each axis",
                                bandwidths.size(), d));
    for (const double h : bandwidths)
        if (!(h > 0.0) || !std::isfinite(h))
            return fail("", fmt::format("found bandwidth {}, expected a number above 0", h));
    const VectorOf diagonal(bandwidths.data(), static_cast<Eigen::Index>(d));
    return GaussianDensity(points, bandwidths, numbersOf(diagonal.asDiagonal()));
}

Result<GaussianDensity> GaussianDensity::fit(const Points& points, BandwidthRule rule) {
    if (auto checked = checkPoints(points); !checked) return tl::unexpected(checked.error());
    if (points.size() < 2)
        return fail("", "no bandwidth can be estimated from a single point",
                    "Give a bandwidth for each axis");
    const std::size_t d = points.front().size();
    const auto n = static_cast<double>(points.size());
    const double shrink = std::pow(n, -1.0 / (static_cast<double>(d) + 4.0));
    const MatrixXd covariance = sampleCovariance(points);
    std::vector<double> bandwidths;
    for (const double variance : covariance.diagonal()) {
        if (!(variance > 0.0))
            return fail(
                "",
                fmt::format("all points have the same value on axis {}: no bandwidth can be estimated",
                            bandwidths.size() + 1),
                "Give a bandwidth for each axis");
        bandwidths.push_back(shrink * std::sqrt(variance));
        if (rule == BandwidthRule::normal_reference) bandwidths.back() *= 1.06 * std::sqrt((n - 1.0) / n);
    }
    if (rule != BandwidthRule::scott_covariance) return fit(points, bandwidths);
    const Eigen::LLT<MatrixXd> cholesky(covariance);
    const MatrixXd lower = cholesky.matrixL();
    // Up to rounding: what is left of the variance on an axis, given those before.
    if (cholesky.info() != Eigen::Success ||
        !(lower.diagonal().array().square() > 1e-12 * covariance.diagonal().array()).all())
        return fail("",
                    "the points lie in a plane of fewer dimensions than they have numbers: no bandwidth "
                    "follows from their spread",
                    "Give a bandwidth for each axis");
    return GaussianDensity(points, std::move(bandwidths), numbersOf(shrink * lower));
}

double GaussianDensity::operator()(const std::vector<double>& x) const {
    const auto d = static_cast<Eigen::Index>(bandwidths_.size());
    if (x.size() != bandwidths_.size())
        throw std::invalid_argument("the density was requested at a point of another dimension");
    const MatrixOf lower(factor_.data(), d, d);
    const MatrixOf points(white_.data(), d, static_cast<Eigen::Index>(white_.size()) / d);
    const Eigen::VectorXd here = lower.triangularView<Eigen::Lower>().solve(VectorOf(x.data(), d));
    return scale_ * (-0.5 * (points.colwise() - here).colwise().squaredNorm().array()).exp().sum();
}

}  // namespace deixis::results
