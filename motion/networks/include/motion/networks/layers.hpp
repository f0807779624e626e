// Layers of trained networks, in Eigen, for one input at a time. Each reads its arrays from a file of
// weights, where they stand under `name` and a dot, row by row as LibTorch lays them out.
#pragma once

#include <Eigen/Core>
#include <string>

#include "motion/networks/weights_file.hpp"

namespace deixis::motion {

using Eigen::MatrixXf;
using Eigen::VectorXf;

[[nodiscard]] Result<VectorXf> readVector(const NetworkWeights& weights, const std::string& name, int size);
[[nodiscard]] Result<MatrixXf> readMatrix(const NetworkWeights& weights, const std::string& name, int rows,
                                          int columns);

[[nodiscard]] float sigmoid(float x);

/// weight x + bias.
struct Linear {
    MatrixXf weight;  ///< outputs x inputs
    VectorXf bias;

    /// NAME.weight and NAME.bias
    [[nodiscard]] static Result<Linear> read(const NetworkWeights& weights, const std::string& name,
                                             int inputs, int outputs);
    [[nodiscard]] VectorXf forward(const VectorXf& x) const { return weight * x + bias; }
};

/// What an LSTM cell keeps from one step to the next.
struct LstmState {
    VectorXf hidden;
    VectorXf cell;

    [[nodiscard]] static LstmState zero(int size) { return {VectorXf::Zero(size), VectorXf::Zero(size)}; }
};

/// Long short-term memory (Hochreiter & Schmidhuber 1997) with a forget gate. The rows of weights and bias
/// are those of the input gate, the forget gate, the candidate and the output gate, in this order.
struct LstmCell {
    MatrixXf input_weight;   ///< 4 x size rows, one column for each input
    MatrixXf hidden_weight;  ///< 4 x size rows, size columns
    VectorXf bias;

    /// NAME.input_weight, NAME.hidden_weight and NAME.bias
    [[nodiscard]] static Result<LstmCell> read(const NetworkWeights& weights, const std::string& name,
                                               int inputs, int size);
    /// One step; the output is the new state's `hidden`.
    void step(const VectorXf& x, LstmState& state) const;
};

}  // namespace deixis::motion
