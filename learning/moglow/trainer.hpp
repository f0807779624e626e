// The model and its optimiser through the updates.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "learning/moglow/training.hpp"
#include "learning/networks/flow_module.hpp"
#include "training_frames.hpp"

namespace deixis::learning {

class MoglowModule : public torch::nn::Module {
  public:
    MoglowModule(int features, const motion::MoglowShape& shape);

    [[nodiscard]] FlowModule& flow() { return *flow_; }
    [[nodiscard]] torch::Tensor encoded(const torch::Tensor& condition) {
        return encoder_->forward(condition);
    }
    /// Bits a frame of each: frames x sequences.
    [[nodiscard]] torch::Tensor bits(const torch::Tensor& x, const torch::Tensor& condition);
    void append(std::vector<motion::NamedArray>& out) const;

  private:
    torch::nn::Linear encoder_{nullptr};
    std::shared_ptr<FlowModule> flow_;
};

/// Sequences with what each frame is conditioned on, frames x sequences x numbers.
struct Sequences {
    torch::Tensor x;
    torch::Tensor condition;
};

class MoglowTrainer {
  public:
    MoglowTrainer(const DemonstrationSets& data, const motion::PoseFeatures& features,
                  const MoglowSettings& settings);

    /// One update, the same whenever it is made from the same model. Its loss, bits a frame, which may not be
    /// finite: then the model is no longer of use.
    [[nodiscard]] double update(int number);
    /// Over the held-out demonstrations, as wholes.
    [[nodiscard]] double validationBits();
    /// Without provenance, hash and metrics.
    [[nodiscard]] motion::NetworkWeights weights() const;
    /// Whether all numbers are finite and a file can hold them.
    [[nodiscard]] bool sound() const;

    void save(torch::serialize::OutputArchive& archive) const;
    void load(torch::serialize::InputArchive& archive);

  private:
    struct Window {
        std::size_t clip = 0;
        std::int64_t begin = 0;
    };
    [[nodiscard]] Sequences batch(int number) const;
    void dropPast(torch::Tensor& condition) const;

    MoglowSettings settings_;
    const motion::PoseFeatures& features_;
    FeatureScale scale_;
    double raise_s_;
    double hold_s_;
    std::vector<Sequences> clips_;
    std::vector<Sequences> validation_;
    std::vector<Window> windows_;
    std::int64_t window_frames_;
    std::shared_ptr<MoglowModule> model_;
    std::unique_ptr<torch::optim::Adam> optimiser_;
};

}  // namespace deixis::learning
