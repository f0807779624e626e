// The gesture model while it is trained, its discriminator, and style that can be differentiated.
#pragma once

#include <torch/torch.h>

#include <string>
#include <vector>

#include "motion/gestures/gesture_style.hpp"
#include "motion/speech_gestures/gesture_network.hpp"

namespace deixis::learning {

/// motion::GestureNetwork over many windows. Draws its first numbers from LibTorch's generator.
class GestureModule : public torch::nn::Module {
  public:
    /// `dropout`: share of the numbers between two layers of the GRU that are dropped in training.
    GestureModule(const motion::GestureShape& shape, double dropout);

    /// `sound`: windows x samples, as motion::heardAround() has them; `words`: windows x frames x numbers;
    /// `controls` likewise, not looked at where the shape has none. Gives windows x frames x 27.
    [[nodiscard]] torch::Tensor forward(const torch::Tensor& sound, const torch::Tensor& words,
                                        const torch::Tensor& controls);
    [[nodiscard]] torch::Tensor encodeSound(const torch::Tensor& sound);  ///< windows x numbers x frames
    /// What motion::GestureNetwork reads, the normalisation folded into the convolutions.
    void append(std::vector<motion::NamedArray>& out) const;

  private:
    motion::GestureShape shape_;
    std::vector<torch::nn::Conv1d> sound_;
    std::vector<torch::nn::BatchNorm1d> norms_;  ///< one fewer
    torch::nn::Linear word_entry_{nullptr};
    std::vector<torch::nn::Conv1d> words_;
    torch::nn::Linear text_{nullptr};
    torch::nn::GRU gru_{nullptr};
    torch::nn::Linear middle_{nullptr};
    torch::nn::Linear output_{nullptr};
};

/// Tells people's motion from the model's: three convolutions (16, 8, 8), a bidirectional GRU with its
/// directions summed, and of each moment a number.
class GestureDiscriminator : public torch::nn::Module {
  public:
    GestureDiscriminator(int hidden, int layers);

    /// Windows x frames x 27; the logit of being people's, for each window.
    [[nodiscard]] torch::Tensor forward(const torch::Tensor& poses);

  private:
    std::vector<torch::nn::Conv1d> convolutions_;
    torch::nn::GRU gru_{nullptr};
    torch::nn::Linear output_{nullptr};
};

/// The numbers of a bidirectional GRU as motion::BidirectionalGru reads them.
void appendGru(const torch::nn::GRU& gru, const std::string& name, std::vector<motion::NamedArray>& out);

/// Equations 4 to 6 as motion::gestureStyle() has them, for windows of one length.
class StyleMeasure {
  public:
    explicit StyleMeasure(int frames);

    /// Of windows x frames x 27 directions, of unit length or not: windows x frames x (speed, space,
    /// handedness).
    [[nodiscard]] torch::Tensor of(const torch::Tensor& directions) const;

  private:
    torch::Tensor over_frames_;  ///< frames x frames: what each frame's window takes of each position
    torch::Tensor over_steps_;   ///< frames - 1 x frames
};

/// Less the mean, over the standard deviation, clamped to [-3, 3].
[[nodiscard]] torch::Tensor normalisedStyles(const torch::Tensor& styles, const motion::StyleNorm& norm);

}  // namespace deixis::learning
