#include "motion/synthesis/gaussian_process.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/pose.hpp"

namespace deixis::motion {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd covariances(const std::vector<std::vector<double>>& inputs, const Kernel& kernel) {
    const auto n = static_cast<Index>(inputs.size());
    MatrixXd out(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            out(i, j) = kernel(inputs[static_cast<std::size_t>(i)], inputs[static_cast<std::size_t>(j)]) +
                        (i == j ? kernel.noise : 0.0);
    return out;
}

MatrixXd matrixOf(const std::vector<std::vector<double>>& rows) {
    MatrixXd out(static_cast<Index>(rows.size()), static_cast<Index>(rows.front().size()));
    for (Index i = 0; i < out.rows(); ++i)
        out.row(i) = VectorXd::Map(rows[static_cast<std::size_t>(i)].data(), out.cols());
    return out;
}

}  // namespace

double Kernel::operator()(std::span<const double> a, std::span<const double> b) const {
    double product = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        product += a[i] * b[i];
        apart += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return constant + linear * product + std::exp(-0.5 * apart / (length * length));
}

GaussianProcess::GaussianProcess(std::vector<std::vector<double>> inputs,
                                 const std::vector<std::vector<double>>& outputs, const Kernel& kernel)
    : inputs_(std::move(inputs)),
      outputs_(matrixOf(outputs)),
      kernel_(kernel),
      factor_(covariances(inputs_, kernel)) {
    if (factor_.info() != Eigen::Success) throw std::logic_error("a covariance is not positive definite");
}

GaussianProcess GaussianProcess::fitted(const std::vector<std::vector<double>>& inputs,
                                        const std::vector<std::vector<double>>& outputs,
                                        std::span<const double> lengths, std::span<const double> noises) {
    std::optional<GaussianProcess> best;
    double highest = 0.0;
    for (const double length : lengths)
        for (const double noise : noises) {
            Kernel kernel;
            kernel.length = length;
            kernel.noise = noise;
            GaussianProcess one(inputs, outputs, kernel);
            const double likelihood = one.logMarginalLikelihood();
            if (best && likelihood <= highest) continue;
            highest = likelihood;
            best = std::move(one);
        }
    return std::move(best).value();
}

std::vector<double> GaussianProcess::predict(std::span<const double> input) const {
    VectorXd covariance(outputs_.rows());
    for (Index i = 0; i < covariance.size(); ++i)
        covariance[i] = kernel_(input, inputs_[static_cast<std::size_t>(i)]);
    const VectorXd mean = outputs_.transpose() * factor_.solve(covariance);
    return {mean.begin(), mean.end()};
}

MatrixXd GaussianProcess::leftOutErrors() const {
    const MatrixXd inverse = factor_.solve(MatrixXd::Identity(outputs_.rows(), outputs_.rows()));
    return inverse.diagonal().cwiseInverse().asDiagonal() * (inverse * outputs_);
}

double GaussianProcess::logMarginalLikelihood() const {
    const double squares = outputs_.cwiseProduct(factor_.solve(outputs_)).sum();
    const auto count = static_cast<double>(outputs_.size());
    const double variance = squares / count;
    const double log_determinant = 2.0 * factor_.matrixLLT().diagonal().array().log().sum();
    return -0.5 * (count * (std::log(2.0 * pi * variance) + 1.0) +
                   static_cast<double>(outputs_.cols()) * log_determinant);
}

}  // namespace deixis::motion
