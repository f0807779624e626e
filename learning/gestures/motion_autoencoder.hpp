// What the Frechet gesture distance looks at motions with.
#pragma once

#include <torch/torch.h>

#include <Eigen/Core>
#include <vector>

#include "motion/networks/weights_file.hpp"

namespace deixis::learning {

/// A convolutional autoencoder of 30 frames of 27 numbers through a latent of 32.
class MotionAutoencoder : public torch::nn::Module {
  public:
    MotionAutoencoder();

    /// Windows x frames x 27 -> windows x 32.
    [[nodiscard]] torch::Tensor encode(const torch::Tensor& poses);
    [[nodiscard]] torch::Tensor decode(const torch::Tensor& latents);
    /// The latents, a row for each window.
    [[nodiscard]] Eigen::MatrixXd features(const torch::Tensor& poses);
    /// The encoder, as MotionEncoder reads it.
    void append(std::vector<motion::NamedArray>& out) const;

  private:
    torch::nn::Sequential encoder_;
    torch::nn::Linear to_latent_{nullptr};
    torch::nn::Linear from_latent_{nullptr};
    torch::nn::Sequential decoder_;
};

}  // namespace deixis::learning
