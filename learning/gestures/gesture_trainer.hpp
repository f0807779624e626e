// The model, its discriminator and their optimisers through the updates.
#pragma once

#include <vector>

#include "gesture_windows.hpp"
#include "motion_autoencoder.hpp"
#include "network_module.hpp"

namespace deixis::learning {

class GestureTrainer {
  public:
    GestureTrainer(const GestureTakes& takes, const GestureSettings& settings);

    [[nodiscard]] int updatesPerEpoch() const { return updates_per_epoch_; }
    [[nodiscard]] int updates() const { return updates_per_epoch_ * settings_.epochs; }
    [[nodiscard]] std::size_t validationWindows() const { return validation_.count(); }

    /// What the scores look at motions with, the same for the same training motions and seed. Needed before
    /// validate(), unless load() brought it.
    void trainAutoencoder();
    /// One update, from 1, the same whenever it is made from the same model. Losses may not be finite: then
    /// the model is no longer of use.
    [[nodiscard]] GestureLosses update(int number);
    [[nodiscard]] GestureScores validate();
    [[nodiscard]] GestureScores meanPoseScores();
    /// Without provenance, hash and metrics.
    [[nodiscard]] motion::NetworkWeights weights() const;
    /// Whether all numbers are finite and a file can hold them.
    [[nodiscard]] bool sound() const;

    void save(torch::serialize::OutputArchive& archive) const;
    void load(torch::serialize::InputArchive& archive);

  private:
    [[nodiscard]] torch::Tensor stylesOf(const torch::Tensor& poses) const;
    [[nodiscard]] WindowBatch drawn(int number, Random& random);
    [[nodiscard]] bool adversarialAt(int number) const;
    void setRates(int number);
    [[nodiscard]] double updateDiscriminator(const torch::Tensor& real, const torch::Tensor& made);
    /// Relative poses of all held-out windows, with unit directions.
    [[nodiscard]] torch::Tensor generated(GivenControls given);
    [[nodiscard]] torch::Tensor unit(const torch::Tensor& poses) const;
    [[nodiscard]] double distanceOf(const torch::Tensor& poses);

    GestureSettings settings_;
    const motion::WordVectors& words_;
    torch::Tensor mean_;
    GestureWindows training_;
    GestureWindows validation_;
    torch::Tensor held_out_;  ///< relative poses of the held-out windows
    StyleMeasure measure_{motion::gesture_window};
    motion::StyleNorm norm_;
    int updates_per_epoch_ = 1;
    int shuffled_epoch_ = 0;
    std::vector<std::size_t> order_;  ///< of that epoch
    std::shared_ptr<GestureModule> model_;
    std::shared_ptr<GestureDiscriminator> discriminator_;
    std::shared_ptr<MotionAutoencoder> autoencoder_;
    std::unique_ptr<torch::optim::Adam> optimiser_;
    std::unique_ptr<torch::optim::Adam> discriminator_optimiser_;
};

}  // namespace deixis::learning
