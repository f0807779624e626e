// What the Frechet gesture distance of Yoon et al. (2021, section 5.3) looks at motions with: the encoder of
// an autoencoder that was trained on the training motions. It stands in the file of the weights that were
// chosen by it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/gesture_scores/scores.hpp"
#include "motion/networks/sequence_layers.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::learning {

class MotionEncoder {
  public:
    static constexpr int latents = 32;

    /// The arrays motion.0 to motion.2 and motion.latent. Fails, naming the file, where one is missing.
    [[nodiscard]] static Result<MotionEncoder> read(const motion::NetworkWeights& weights);

    /// Of scored_frames columns with 27 numbers each, relative to the mean pose of the training motions.
    [[nodiscard]] Eigen::VectorXd encode(const motion::MatrixXf& poses) const;

  private:
    std::vector<motion::Convolution> convolutions_;
    motion::Linear latent_;
};

}  // namespace deixis::learning
