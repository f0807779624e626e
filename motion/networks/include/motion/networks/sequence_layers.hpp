// Layers over sequences, in Eigen. A sequence is a matrix with a column for each moment and a row for each
// channel. Arrays stand in files as LibTorch lays them out; the results are LibTorch's.
#pragma once

#include <vector>

#include "motion/networks/layers.hpp"

namespace deixis::motion {

/// Where a convolution looks, in columns.
struct ConvolutionPlaces {
    int kernel = 1;    ///< taps
    int stride = 1;    ///< from one output to the next
    int dilation = 1;  ///< from one tap to the next
    int padding = 0;   ///< zeros before and after the sequence
};

/// A convolution over time: output t is the sum over taps k of weight_k x[t stride + k dilation - padding],
/// plus the bias.
class Convolution {
  public:
    /// NAME.weight (outputs x inputs x kernel) and NAME.bias.
    [[nodiscard]] static Result<Convolution> read(const NetworkWeights& weights, const std::string& name,
                                                  int inputs, int outputs, const ConvolutionPlaces& places);
    /// `x` must have as many rows as inputs; without any column where the kernel does not fit in.
    [[nodiscard]] MatrixXf forward(const MatrixXf& x) const;

  private:
    int inputs_ = 0;
    ConvolutionPlaces places_;
    MatrixXf weight_;  ///< outputs x (kernel inputs): tap after tap
    VectorXf bias_;
};

/// A gated recurrent unit (Cho et al. 2014) over a sequence, from the zero state. The rows of weights and
/// biases are those of the reset gate, the update gate and the candidate, in this order.
struct GruLayer {
    MatrixXf input_weight;   ///< 3 x size rows, one column for each input
    MatrixXf hidden_weight;  ///< 3 x size rows, size columns
    VectorXf input_bias;
    VectorXf hidden_bias;

    /// NAME.input_weight, NAME.hidden_weight, NAME.input_bias and NAME.hidden_bias
    [[nodiscard]] static Result<GruLayer> read(const NetworkWeights& weights, const std::string& name,
                                               int inputs, int size);
    /// The state after each moment; `backward`: from the last moment to the first.
    [[nodiscard]] MatrixXf forward(const MatrixXf& x, bool backward) const;
};

/// Layers of two such units, one in each direction. Each layer sees both states of the one before; what comes
/// out is the sum of the last layer's two.
class BidirectionalGru {
  public:
    /// NAME.0.forward.input_weight and so on, NAME.0.backward...., NAME.1....
    [[nodiscard]] static Result<BidirectionalGru> read(const NetworkWeights& weights, const std::string& name,
                                                       int inputs, int size, int layers);
    [[nodiscard]] MatrixXf forward(const MatrixXf& x) const;

  private:
    struct Layer {
        GruLayer forward;
        GruLayer backward;
    };
    std::vector<Layer> layers_;
};

/// x where it is positive, else slope x.
[[nodiscard]] MatrixXf leakyRectified(const MatrixXf& x, float slope);

}  // namespace deixis::motion
