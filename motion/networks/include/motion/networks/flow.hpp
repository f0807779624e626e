// A conditional normalising flow of frames, as MoGlow's (Henter, Alexanderson & Beskow 2020): each step is
// actnorm, an invertible linear map and an affine coupling (Kingma & Dhariwal 2018), whose shift and scale
// come from a two-layer LSTM. The log-determinants are of the direction from data to latent.
#pragma once

#include <vector>

#include "motion/networks/layers.hpp"

namespace deixis::motion {

/// y = (x + bias) e^log_scale, number by number.
struct ActNorm {
    VectorXf bias;
    VectorXf log_scale;

    [[nodiscard]] VectorXf forward(const VectorXf& x) const;
    [[nodiscard]] VectorXf inverse(const VectorXf& y) const;
    [[nodiscard]] float logDeterminant() const { return log_scale.sum(); }
};

/// y = P L U x, where P permutes: number i of y is number permutation[i] of L U x. L has ones on its
/// diagonal, that of U is sign e^log_size. Only its triangle of `lower` and `upper` counts.
struct InvertibleLinear {
    Eigen::VectorXi permutation;
    MatrixXf lower;
    MatrixXf upper;
    VectorXf sign;
    VectorXf log_size;

    [[nodiscard]] VectorXf forward(const VectorXf& x) const;
    [[nodiscard]] VectorXf inverse(const VectorXf& y) const;
    [[nodiscard]] float logDeterminant() const { return log_size.sum(); }
};

/// The first half of x stays; the second becomes (x2 + shift) scale with scale = sigmoid(s + 2) + 1e-6, where
/// shift and s come from an LSTM that sees the first half and the condition.
struct AffineCoupling {
    LstmCell first;
    LstmCell second;
    Linear output;

    struct State {
        LstmState first;
        LstmState second;
    };
    [[nodiscard]] VectorXf forward(const VectorXf& x, const VectorXf& condition, State& state,
                                   float& log_determinant) const;
    [[nodiscard]] VectorXf inverse(const VectorXf& y, const VectorXf& condition, State& state) const;
};

struct FlowShape {
    int size = 0;       ///< of a frame, 2 or more
    int condition = 0;  ///< of what each frame is conditioned on
    int steps = 0;      ///< K
    int hidden = 0;     ///< H, of each LSTM layer

    [[nodiscard]] int kept() const { return size / 2; }
    [[nodiscard]] int changed() const { return size - kept(); }
};

class ConditionalFlow {
  public:
    using State = std::vector<AffineCoupling::State>;

    /// From the arrays flow.0.actnorm.bias and so on.
    [[nodiscard]] static Result<ConditionalFlow> read(const NetworkWeights& weights, const FlowShape& shape);

    [[nodiscard]] const FlowShape& shape() const { return shape_; }
    /// Before the first frame.
    [[nodiscard]] State zeroState() const;
    /// The latent of the next frame; `log_determinant` is set.
    [[nodiscard]] VectorXf forward(VectorXf x, const VectorXf& condition, State& state,
                                   float& log_determinant) const;
    /// The next frame of a latent.
    [[nodiscard]] VectorXf inverse(VectorXf z, const VectorXf& condition, State& state) const;

  private:
    struct Step {
        ActNorm actnorm;
        InvertibleLinear linear;
        AffineCoupling coupling;
    };
    [[nodiscard]] static Result<Step> readStep(const NetworkWeights& weights, const std::string& name,
                                               const FlowShape& shape);

    FlowShape shape_;
    std::vector<Step> steps_;
};

}  // namespace deixis::motion
