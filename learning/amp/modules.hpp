// The networks of a training, in LibTorch.
#pragma once

#include <torch/torch.h>

#include <vector>

#include "learning/networks/mlp.hpp"

namespace deixis::learning {

/// How much each of four sets of weights counts at a phase in [0, 1]: the cubic of Catmull & Rom through
/// them on a circle (Holden, Komura & Saito 2017, Eq. 7). N -> N x 4.
[[nodiscard]] torch::Tensor phaseShares(const torch::Tensor& phase);

/// A discriminator: one number, the higher the more it takes its input for a demonstration's. Without
/// `phase_functioned` it has one set of weights.
class Discriminator : public torch::nn::Module {
  public:
    Discriminator(int inputs, const std::vector<int>& hidden, bool phase_functioned);

    /// x: N x inputs, phase: N. -> N
    [[nodiscard]] torch::Tensor forward(const torch::Tensor& x, const torch::Tensor& phase);
    /// Of the last layer, for its decay.
    [[nodiscard]] const torch::Tensor& lastWeight() const { return weights_.back(); }

  private:
    std::int64_t sets_;
    std::vector<torch::Tensor> weights_;  ///< sets x outputs x inputs
    std::vector<torch::Tensor> biases_;   ///< sets x outputs
};

}  // namespace deixis::learning
