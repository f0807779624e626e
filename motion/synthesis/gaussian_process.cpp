#include "motion/synthesis/gaussian_process.hpp"

#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/pose.hpp"

namespace deixis::motion {

namespace {

std::vector<double> covariances(const std::vector<std::vector<double>>& inputs, const Kernel& kernel) {
    std::vector<double> lower;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            lower.push_back(kernel(inputs[i], inputs[j]) + (i == j ? kernel.noise : 0.0));
    return lower;
}

}  // namespace

Cholesky::Cholesky(std::vector<double> lower_triangle, std::size_t size)
    : lower_(std::move(lower_triangle)), size_(size) {
    for (std::size_t i = 0; i < size_; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double& entry = lower_[i * (i + 1) / 2 + j];
            for (std::size_t k = 0; k < j; ++k) entry -= at(i, k) * at(j, k);
            if (i > j) {
                entry /= at(j, j);
            } else {
                if (!(entry > 0.0)) throw std::logic_error("a covariance is not positive definite");
                entry = std::sqrt(entry);
            }
        }
}

std::vector<double> Cholesky::solve(std::vector<double> right) const {
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t k = 0; k < i; ++k) right[i] -= at(i, k) * right[k];
        right[i] /= at(i, i);
    }
    for (std::size_t i = size_; i-- > 0;) {
        for (std::size_t k = i + 1; k < size_; ++k) right[i] -= at(k, i) * right[k];
        right[i] /= at(i, i);
    }
    return right;
}

double Cholesky::logDeterminant() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size_; ++i) sum += 2.0 * std::log(at(i, i));
    return sum;
}

double Kernel::operator()(std::span<const double> a, std::span<const double> b) const {
    double product = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        product += a[i] * b[i];
        apart += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return constant + linear * product + std::exp(-0.5 * apart / (length * length));
}

GaussianProcess::GaussianProcess(std::vector<std::vector<double>> inputs,
                                 std::vector<std::vector<double>> outputs, const Kernel& kernel)
    : inputs_(std::move(inputs)),
      outputs_(std::move(outputs)),
      kernel_(kernel),
      factor_(covariances(inputs_, kernel), inputs_.size()) {}

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
    std::vector<double> covariance;
    for (const auto& other : inputs_) covariance.push_back(kernel_(input, other));
    const std::vector<double> weights = factor_.solve(std::move(covariance));
    std::vector<double> out(outputs_.front().size(), 0.0);
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        for (std::size_t d = 0; d < out.size(); ++d) out[d] += weights[i] * outputs_[i][d];
    return out;
}

double GaussianProcess::logMarginalLikelihood() const {
    const std::size_t n = outputs_.size();
    const std::size_t dimensions = outputs_.front().size();
    double squares = 0.0;
    for (std::size_t d = 0; d < dimensions; ++d) {
        std::vector<double> column;
        for (const auto& row : outputs_) column.push_back(row[d]);
        const std::vector<double> solved = factor_.solve(column);
        squares += std::inner_product(column.begin(), column.end(), solved.begin(), 0.0);
    }
    const auto count = static_cast<double>(n * dimensions);
    const double variance = squares / count;
    return -0.5 * (count * (std::log(2.0 * pi * variance) + 1.0) +
                   static_cast<double>(dimensions) * factor_.logDeterminant());
}

}  // namespace deixis::motion
