// A plain network, in LibTorch.
#pragma once

#include <torch/torch.h>

#include <string>
#include <vector>

#include "motion/networks/weights_file.hpp"

namespace deixis::learning {

/// Fully connected layers with rectified units between them.
class Mlp : public torch::nn::Module {
  public:
    Mlp(int inputs, const std::vector<int>& hidden, int outputs, double last_scale);

    [[nodiscard]] torch::Tensor forward(torch::Tensor x);
    void append(const std::string& name, std::vector<motion::NamedArray>& out) const;

  private:
    std::vector<torch::nn::Linear> layers_;
};

}  // namespace deixis::learning
