#include "learning/networks/optimising.hpp"

#include <vector>

namespace deixis::learning {

void seedTorch(std::uint64_t seed, const std::string& label) {
    torch::manual_seed(deriveSeed(seed, label) >> 1U);
}

void setRate(torch::optim::Adam& optimiser, double rate) {
    for (auto& group : optimiser.param_groups())
        static_cast<torch::optim::AdamOptions&>(group.options()).lr(rate);
}

torch::Tensor drawnIndices(Random& random, std::int64_t below, std::int64_t count) {
    std::vector<std::int64_t> out;
    for (std::int64_t i = 0; i < count; ++i)
        out.push_back(static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(below))));
    return torch::tensor(out);
}

}  // namespace deixis::learning
