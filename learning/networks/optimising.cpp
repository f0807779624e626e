#include "learning/networks/optimising.hpp"

#include <malloc.h>

#include <limits>
#include <vector>

namespace deixis::learning {

void setUpTorch(int threads) {
    torch::set_num_threads(threads);
    // Where no gradients are kept, LibTorch 2.6 of Debian 13 has oneDNN run LSTMs, and they come out wrong by
    // tenths.
    at::globalContext().setUserEnabledMkldnn(false);
#ifdef M_MMAP_THRESHOLD  // the GNU library's
    constexpr int largest_threshold = 32 << 20;
    mallopt(M_MMAP_THRESHOLD, largest_threshold);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

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
