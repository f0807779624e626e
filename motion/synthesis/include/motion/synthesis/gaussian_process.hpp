// Gaussian process regression of many outputs that share one kernel (Rasmussen & Williams 2006, algorithm
// 2.1). Each prediction is the training outputs, weighted by the same weights for all of them.
#pragma once

#include <Eigen/Cholesky>
#include <span>
#include <vector>

#include "core/error.hpp"

namespace deixis::motion {

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
    /// One input and one row of outputs for each observation; at least two. Throws where their covariance is
    /// not positive definite: two of the same input without noise.
    GaussianProcess(std::vector<std::vector<double>> inputs, const std::vector<std::vector<double>>& outputs,
                    const Kernel& kernel);
    /// The one of the lengths and noises whose marginal likelihood is the highest: the first of equal ones.
    [[nodiscard]] static GaussianProcess fitted(const std::vector<std::vector<double>>& inputs,
                                                const std::vector<std::vector<double>>& outputs,
                                                std::span<const double> lengths,
                                                std::span<const double> noises);

    [[nodiscard]] const Kernel& kernel() const { return kernel_; }
    [[nodiscard]] const std::vector<std::vector<double>>& inputs() const { return inputs_; }
    /// The posterior's mean.
    [[nodiscard]] std::vector<double> predict(std::span<const double> input) const;
    /// By how much each observation is off what the others alone predict for its input, a row for each
    /// (Rasmussen & Williams 2006, Eq. 5.12, with this kernel).
    [[nodiscard]] Eigen::MatrixXd leftOutErrors() const;
    /// Of the outputs together, the variance that they share being the most likely one.
    [[nodiscard]] double logMarginalLikelihood() const;

  private:
    std::vector<std::vector<double>> inputs_;
    Eigen::MatrixXd outputs_;  ///< a row for each observation
    Kernel kernel_;
    Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace deixis::motion
