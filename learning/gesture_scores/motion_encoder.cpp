#include "learning/gesture_scores/motion_encoder.hpp"

#include <fmt/format.h>

#include "motion/networks/taking.hpp"

namespace deixis::learning {

namespace {

constexpr int narrow = 32, wide = 64;
constexpr int short_frames = 7;  // 30 -> 15 -> 7
constexpr float encoder_slope = 0.2F;

}  // namespace

Result<MotionEncoder> MotionEncoder::read(const motion::NetworkWeights& weights) {
    struct Step {
        int inputs, outputs;
        motion::ConvolutionPlaces places;
    };
    const std::array<Step, 3> steps{{{motion::upper_body_numbers, narrow, {.kernel = 3, .padding = 1}},
                                     {narrow, wide, {.kernel = 4, .stride = 2, .padding = 1}},
                                     {wide, wide, {.kernel = 4, .stride = 2, .padding = 1}}}};
    MotionEncoder out;
    out.convolutions_.resize(steps.size());
    motion::Taking take;
    for (std::size_t i = 0; i < steps.size(); ++i)
        take(out.convolutions_[i],
             motion::Convolution::read(weights, fmt::format("motion.{}", i), steps[i].inputs,
                                       steps[i].outputs, steps[i].places));
    take(out.latent_, motion::Linear::read(weights, "motion.latent", wide * short_frames, latents));
    if (take.problem()) return tl::unexpected(*take.problem());
    return out;
}

Eigen::VectorXd MotionEncoder::encode(const motion::MatrixXf& poses) const {
    motion::MatrixXf x = poses;
    for (const auto& convolution : convolutions_)
        x = motion::leakyRectified(convolution.forward(x), encoder_slope);
    // All frames of a channel stand before those of the next one.
    const motion::MatrixXf by_channel = x.transpose();
    const auto flat = by_channel.reshaped();
    return (latent_.weight * flat + latent_.bias).cast<double>();
}

}  // namespace deixis::learning
