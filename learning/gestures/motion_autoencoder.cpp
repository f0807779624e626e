#include "motion_autoencoder.hpp"

#include <fmt/format.h>

#include "learning/networks/tensors.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::learning {

namespace {

constexpr std::int64_t latent_size = 32;
constexpr std::int64_t pose_size = motion::upper_body_numbers;
constexpr std::int64_t narrow_channels = 32, wide_channels = 64;
constexpr std::int64_t short_frames = 7;  // 30 -> 15 -> 7

torch::nn::LeakyReLU rectifier() {
    return torch::nn::LeakyReLU(torch::nn::LeakyReLUOptions().negative_slope(0.2));
}

}  // namespace

MotionAutoencoder::MotionAutoencoder() {
    using torch::nn::Conv1d, torch::nn::Conv1dOptions;
    using torch::nn::ConvTranspose1d, torch::nn::ConvTranspose1dOptions;
    encoder_ = register_module(
        "encoder",
        torch::nn::Sequential(
            Conv1d(Conv1dOptions(pose_size, narrow_channels, 3).padding(1)), rectifier(),
            Conv1d(Conv1dOptions(narrow_channels, wide_channels, 4).stride(2).padding(1)), rectifier(),
            Conv1d(Conv1dOptions(wide_channels, wide_channels, 4).stride(2).padding(1)), rectifier()));
    to_latent_ = register_module("to_latent", torch::nn::Linear(wide_channels * short_frames, latent_size));
    from_latent_ =
        register_module("from_latent", torch::nn::Linear(latent_size, wide_channels * short_frames));
    decoder_ = register_module(
        "decoder",
        torch::nn::Sequential(
            rectifier(),
            ConvTranspose1d(ConvTranspose1dOptions(wide_channels, wide_channels, 5).stride(2).padding(1)),
            rectifier(),
            ConvTranspose1d(ConvTranspose1dOptions(wide_channels, narrow_channels, 4).stride(2).padding(1)),
            rectifier(), Conv1d(Conv1dOptions(narrow_channels, pose_size, 3).padding(1))));
}

torch::Tensor MotionAutoencoder::encode(const torch::Tensor& poses) {
    return to_latent_->forward(encoder_->forward(poses.transpose(1, 2)).flatten(1));
}

torch::Tensor MotionAutoencoder::decode(const torch::Tensor& latents) {
    const torch::Tensor wide = from_latent_->forward(latents).reshape({-1, wide_channels, short_frames});
    return decoder_->forward(wide).transpose(1, 2);
}

void MotionAutoencoder::append(std::vector<motion::NamedArray>& out) const {
    const torch::NoGradGuard no_gradient;
    int number = 0;
    for (const auto& layer : *encoder_) {
        const auto* convolution = layer.ptr()->as<torch::nn::Conv1d>();
        if (convolution == nullptr) continue;
        out.push_back(arrayOf(fmt::format("motion.{}.weight", number), convolution->weight));
        out.push_back(arrayOf(fmt::format("motion.{}.bias", number), convolution->bias));
        ++number;
    }
    appendLinear(to_latent_, "motion.latent", out);
}

Eigen::MatrixXd MotionAutoencoder::features(const torch::Tensor& poses) {
    const torch::NoGradGuard no_gradient;
    const torch::Tensor latents = encode(poses).to(torch::kFloat64).contiguous();
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(latents.data_ptr<double>(), latents.size(0), latents.size(1));
}

}  // namespace deixis::learning
