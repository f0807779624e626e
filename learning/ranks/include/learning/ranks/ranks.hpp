// Several processes, on one machine or many, that share a training: each tries out bodies of its own, and
// what they learn from is the mean of their gradients. By LibTorch's c10d over Gloo.
#pragma once

#include <torch/torch.h>

#include <memory>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "learning/training/training.hpp"

namespace deixis::learning {

/// This process among those of a training. All of them make the same calls in the same order: each call waits
/// for all, and throws where one of them is gone.
class Ranks {
  public:
    /// Waits until all have come, at most five minutes. Without a place: this process alone, for which every
    /// call leaves things as they are.
    [[nodiscard]] static Result<std::shared_ptr<Ranks>> join(const std::optional<RankPlace>& place);
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int count() const { return count_; }
    /// Each tensor becomes the mean of all ranks'.
    void average(std::vector<torch::Tensor> tensors);
    /// Likewise of parameters' gradients.
    void averageGradients(const std::vector<torch::Tensor>& parameters);
    /// Each tensor becomes that of rank 0, in place.
    void takeFirst(std::vector<torch::Tensor> tensors);
    /// Whether it is so in any rank.
    [[nodiscard]] bool any(bool here);
    /// Rank 0's text.
    [[nodiscard]] std::string firstText(const std::string& here);

  private:
    struct Group;
    Ranks(int rank, int count);
    int rank_;
    int count_;
    std::unique_ptr<Group> group_;
};

}  // namespace deixis::learning
