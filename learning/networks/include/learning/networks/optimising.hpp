// What trainings' updates have in common.
#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <string>

#include "core/random.hpp"

namespace deixis::learning {

/// Of this process, before a training. Memory that tensors free stays with it: each page that the system
/// gives anew costs time, in all a tenth of a training's. LSTMs are LibTorch's own, not oneDNN's.
void setUpTorch(int threads);

/// LibTorch's own generator, which all threads share.
void seedTorch(std::uint64_t seed, const std::string& label);

void setRate(torch::optim::Adam& optimiser, double rate);

/// `count` whole numbers from 0 to below - 1, with repetitions.
[[nodiscard]] torch::Tensor drawnIndices(Random& random, std::int64_t below, std::int64_t count);

}  // namespace deixis::learning
