// Gaussian process regression of many outputs that share one kernel (Rasmussen & Williams 2006, algorithm
// 2.1). Each prediction is the training outputs, weighted by the same weights for all of them.
#pragma once

#include <span>
#include <vector>

#include "core/error.hpp"

namespace deixis::motion {

/// Lower triangle of a symmetric positive definite matrix, row by row: 1, 2, 3 ... numbers.
class Cholesky {
  public:
    /// Takes the matrix's lower triangle. Throws where it is not positive definite.
    explicit Cholesky(std::vector<double> lower_triangle, std::size_t size);
    [[nodiscard]] std::vector<double> solve(std::vector<double> right) const;
    [[nodiscard]] double logDeterminant() const;

  private:
    [[nodiscard]] const double& at(std::size_t row, std::size_t column) const {
        return lower_[row * (row + 1) / 2 + column];
    }
    std::vector<double> lower_;
    std::size_t size_;
};

/// k(a, b) = constant + linear a.b + exp(-|a - b|^2 / (2 length^2)), with `noise` added where a and b are one
/// observation; all in units of the outputs' own variance, which is estimated.
struct Kernel {
    double constant = 10.0;
    double linear = 10.0;
    double length = 1.0;
    double noise = 0.01;

    [[nodiscard]] double operator()(std::span<const double> a, std::span<const double> b) const;
};

class GaussianProcess {
  public:
    /// One input and one row of outputs for each observation; at least two.
    GaussianProcess(std::vector<std::vector<double>> inputs, std::vector<std::vector<double>> outputs,
                    const Kernel& kernel);
    /// The one of the lengths and noises whose marginal likelihood is the highest: the first of equal ones.
    [[nodiscard]] static GaussianProcess fitted(const std::vector<std::vector<double>>& inputs,
                                                const std::vector<std::vector<double>>& outputs,
                                                std::span<const double> lengths,
                                                std::span<const double> noises);

    [[nodiscard]] const Kernel& kernel() const { return kernel_; }
    /// The posterior's mean.
    [[nodiscard]] std::vector<double> predict(std::span<const double> input) const;
    /// Of the outputs together, the variance that they share being the most likely one.
    [[nodiscard]] double logMarginalLikelihood() const;

  private:
    std::vector<std::vector<double>> inputs_;
    std::vector<std::vector<double>> outputs_;
    Kernel kernel_;
    Cholesky factor_;
};

}  // namespace deixis::motion
