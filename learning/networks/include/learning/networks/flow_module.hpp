// Networks while they are trained, in LibTorch: each writes its numbers into the arrays that motion/networks
// reads, and computes what that does.
#pragma once

#include <torch/torch.h>

#include <string>
#include <vector>

#include "motion/networks/weights_file.hpp"

namespace deixis::learning {

struct FlowSizes {
    int size = 0;       ///< numbers of a frame
    int condition = 0;  ///< numbers that a frame is conditioned on
    int steps = 0;
    int hidden = 0;
};

/// motion::ConditionalFlow over whole sequences. Begins as a random rotation at each step and couplings that
/// only scale.
class FlowModule : public torch::nn::Module {
  public:
    /// Draws its first numbers from LibTorch's generator.
    explicit FlowModule(const FlowSizes& sizes);

    struct Latents {
        torch::Tensor z;                ///< frames x sequences x size
        torch::Tensor log_determinant;  ///< frames x sequences
    };
    /// `x`: frames x sequences x size; `condition` likewise. Each sequence begins from the zero state.
    [[nodiscard]] Latents forward(torch::Tensor x, const torch::Tensor& condition);
    /// Sets the actnorms so that each gives these frames mean 0 and standard deviation 1.
    void initialiseFrom(torch::Tensor x, const torch::Tensor& condition);
    /// flow.0.actnorm.bias and so on.
    void append(std::vector<motion::NamedArray>& out) const;

  private:
    struct Step {
        torch::Tensor bias, log_scale;
        torch::Tensor permutation, lower, upper, sign, log_size;
        torch::nn::LSTM lstm{nullptr};
        torch::nn::Linear output{nullptr};
    };
    [[nodiscard]] torch::Tensor linear(const Step& step, const torch::Tensor& x) const;
    /// Adds the coupling's log-determinant.
    [[nodiscard]] torch::Tensor coupled(Step& step, const torch::Tensor& x, const torch::Tensor& condition,
                                        torch::Tensor& log_determinant);

    FlowSizes sizes_;
    std::vector<Step> steps_;
};

}  // namespace deixis::learning
