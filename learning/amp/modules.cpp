#include "modules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace deixis::learning {

torch::Tensor phaseShares(const torch::Tensor& phase) {
    const torch::Tensor place = 4.0 * phase;
    const torch::Tensor first = torch::floor(place);
    const torch::Tensor t = place - first;
    const torch::Tensor t2 = t * t, t3 = t2 * t;
    const torch::Tensor shares = torch::stack({-0.5 * t + t2 - 0.5 * t3, 1.0 - 2.5 * t2 + 1.5 * t3,
                                               0.5 * t + 2.0 * t2 - 1.5 * t3, -0.5 * t2 + 0.5 * t3},
                                              1);
    // Column i of them belongs to set first - 1 + i, counted round the circle.
    const torch::Tensor sets =
        torch::remainder(first.to(torch::kInt64).unsqueeze(1) + torch::arange(-1, 3).unsqueeze(0), 4);
    return torch::zeros_like(shares).scatter_add(1, sets, shares);
}

Discriminator::Discriminator(int inputs, const std::vector<int>& hidden, bool phase_functioned)
    : sets_(phase_functioned ? 4 : 1) {
    std::int64_t from = inputs;
    for (std::size_t i = 0; i <= hidden.size(); ++i) {
        const std::int64_t to = i < hidden.size() ? hidden[i] : 1;
        const double reach = 1.0 / std::sqrt(static_cast<double>(from));
        weights_.push_back(register_parameter(fmt::format("weight{}", i),
                                              (2.0 * torch::rand({sets_, to, from}) - 1.0) * reach));
        biases_.push_back(register_parameter(fmt::format("bias{}", i), torch::zeros({sets_, to})));
        from = to;
    }
}

torch::Tensor Discriminator::forward(const torch::Tensor& x, const torch::Tensor& phase) {
    const torch::Tensor shares = sets_ > 1 ? phaseShares(phase).unsqueeze(2) : torch::Tensor();
    torch::Tensor h = x;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const std::int64_t to = weights_[i].size(1);
        if (sets_ == 1) {
            h = torch::addmm(biases_[i][0], h, weights_[i][0].t());
        } else {
            const torch::Tensor each =
                torch::addmm(biases_[i].reshape({-1}), h, weights_[i].reshape({sets_ * to, -1}).t());
            h = (each.reshape({-1, sets_, to}) * shares).sum(1);
        }
        if (i + 1 < weights_.size()) h = torch::relu(h);
    }
    return h.squeeze(1);
}

}  // namespace deixis::learning
