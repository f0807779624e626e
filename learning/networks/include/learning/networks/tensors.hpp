// Tensors in and out of files.
#pragma once

#include <torch/torch.h>

#include <string>
#include <vector>

#include "motion/networks/weights_file.hpp"

namespace deixis::learning {

[[nodiscard]] motion::NamedArray arrayOf(const std::string& name, const torch::Tensor& tensor);
/// NAME.weight and NAME.bias of a linear layer.
void appendLinear(const torch::nn::Linear& layer, const std::string& name,
                  std::vector<motion::NamedArray>& out);

/// Whether all numbers are finite and a file can hold them as float16.
[[nodiscard]] bool fitFloat16(const std::vector<torch::Tensor>& tensors);

[[nodiscard]] std::string bytesOf(torch::serialize::OutputArchive& archive);

}  // namespace deixis::learning
