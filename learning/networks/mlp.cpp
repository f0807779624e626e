#include "learning/networks/mlp.hpp"

#include <fmt/format.h>

#include "learning/networks/tensors.hpp"

namespace deixis::learning {

Mlp::Mlp(int inputs, const std::vector<int>& hidden, int outputs, double last_scale) {
    int from = inputs;
    for (std::size_t i = 0; i <= hidden.size(); ++i) {
        const int to = i < hidden.size() ? hidden[i] : outputs;
        layers_.push_back(register_module(fmt::format("layer{}", i), torch::nn::Linear(from, to)));
        from = to;
    }
    torch::NoGradGuard no_gradient;
    layers_.back()->weight *= last_scale;
    layers_.back()->bias *= 0.0;
}

torch::Tensor Mlp::forward(torch::Tensor x) {
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        x = layers_[i]->forward(x);
        if (i + 1 < layers_.size()) x = torch::relu(x);
    }
    return x;
}

void Mlp::append(const std::string& name, std::vector<motion::NamedArray>& out) const {
    for (std::size_t i = 0; i < layers_.size(); ++i)
        appendLinear(layers_[i], fmt::format("{}.layer{}", name, i), out);
}

}  // namespace deixis::learning
