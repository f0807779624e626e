#include "motion/networks/layers.hpp"

#include <cmath>

namespace deixis::motion {

namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

Result<VectorXf> readVector(const NetworkWeights& weights, const std::string& name, int size) {
    const auto array = weights.array(name, {static_cast<std::size_t>(size)});
    if (!array) return tl::unexpected(array.error());
    return VectorXf(Eigen::Map<const VectorXf>((*array)->values.data(), size));
}

Result<MatrixXf> readMatrix(const NetworkWeights& weights, const std::string& name, int rows, int columns) {
    const auto array =
        weights.array(name, {static_cast<std::size_t>(rows), static_cast<std::size_t>(columns)});
    if (!array) return tl::unexpected(array.error());
    return MatrixXf(Eigen::Map<const RowMajor>((*array)->values.data(), rows, columns));
}

float sigmoid(float x) {
    return 1.0F / (1.0F + std::exp(-x));
}

Result<Linear> Linear::read(const NetworkWeights& weights, const std::string& name, int inputs, int outputs) {
    auto weight = readMatrix(weights, name + ".weight", outputs, inputs);
    if (!weight) return tl::unexpected(weight.error());
    auto bias = readVector(weights, name + ".bias", outputs);
    if (!bias) return tl::unexpected(bias.error());
    return Linear{std::move(*weight), std::move(*bias)};
}

Result<LstmCell> LstmCell::read(const NetworkWeights& weights, const std::string& name, int inputs,
                                int size) {
    auto input_weight = readMatrix(weights, name + ".input_weight", 4 * size, inputs);
    if (!input_weight) return tl::unexpected(input_weight.error());
    auto hidden_weight = readMatrix(weights, name + ".hidden_weight", 4 * size, size);
    if (!hidden_weight) return tl::unexpected(hidden_weight.error());
    auto bias = readVector(weights, name + ".bias", 4 * size);
    if (!bias) return tl::unexpected(bias.error());
    return LstmCell{std::move(*input_weight), std::move(*hidden_weight), std::move(*bias)};
}

void LstmCell::step(const VectorXf& x, LstmState& state) const {
    VectorXf gates = bias;
    gates.noalias() += input_weight * x;
    gates.noalias() += hidden_weight * state.hidden;
    const Eigen::Index size = state.cell.size();
    for (Eigen::Index i = 0; i < size; ++i) {
        const float input = sigmoid(gates[i]);
        const float forget = sigmoid(gates[size + i]);
        const float candidate = std::tanh(gates[2 * size + i]);
        const float output = sigmoid(gates[3 * size + i]);
        state.cell[i] = forget * state.cell[i] + input * candidate;
        state.hidden[i] = output * std::tanh(state.cell[i]);
    }
}

}  // namespace deixis::motion
