#include "motion/networks/sequence_layers.hpp"

#include <cmath>

namespace deixis::motion {

Result<Convolution> Convolution::read(const NetworkWeights& weights, const std::string& name, int inputs,
                                      int outputs, const ConvolutionPlaces& places) {
    const auto array =
        weights.array(name + ".weight", {static_cast<std::size_t>(outputs), static_cast<std::size_t>(inputs),
                                         static_cast<std::size_t>(places.kernel)});
    if (!array) return tl::unexpected(array.error());
    auto bias = readVector(weights, name + ".bias", outputs);
    if (!bias) return tl::unexpected(bias.error());
    Convolution out;
    out.inputs_ = inputs;
    out.places_ = places;
    out.bias_ = std::move(*bias);
    out.weight_.resize(outputs, static_cast<Eigen::Index>(places.kernel) * inputs);
    auto value = (*array)->values.begin();
    for (Eigen::Index to = 0; to < outputs; ++to)
        for (Eigen::Index from = 0; from < inputs; ++from)
            for (Eigen::Index tap = 0; tap < places.kernel; ++tap)
                out.weight_(to, tap * inputs + from) = *value++;
    return out;
}

MatrixXf Convolution::forward(const MatrixXf& x) const {
    const auto [kernel, stride, dilation, padding] = places_;
    MatrixXf padded = MatrixXf::Zero(inputs_, x.cols() + 2L * padding);
    padded.middleCols(padding, x.cols()) = x;
    const Eigen::Index reach = Eigen::Index{kernel - 1} * dilation + 1;
    if (padded.cols() < reach) return MatrixXf(bias_.size(), 0);
    const Eigen::Index count = (padded.cols() - reach) / stride + 1;
    MatrixXf out = bias_.replicate(1, count);
    // The columns that a tap, or without dilation the whole kernel, meets are a matrix where they lie.
    using Met = Eigen::Map<const MatrixXf, 0, Eigen::OuterStride<>>;
    const Eigen::OuterStride<> apart(Eigen::Index{stride} * inputs_);
    if (dilation == 1) {
        out.noalias() += weight_ * Met(padded.data(), weight_.cols(), count, apart);
        return out;
    }
    for (Eigen::Index tap = 0; tap < kernel; ++tap)
        out.noalias() += weight_.middleCols(tap * inputs_, inputs_) *
                         Met(padded.data() + tap * dilation * inputs_, inputs_, count, apart);
    return out;
}

Result<GruLayer> GruLayer::read(const NetworkWeights& weights, const std::string& name, int inputs,
                                int size) {
    auto input_weight = readMatrix(weights, name + ".input_weight", 3 * size, inputs);
    if (!input_weight) return tl::unexpected(input_weight.error());
    auto hidden_weight = readMatrix(weights, name + ".hidden_weight", 3 * size, size);
    if (!hidden_weight) return tl::unexpected(hidden_weight.error());
    auto input_bias = readVector(weights, name + ".input_bias", 3 * size);
    if (!input_bias) return tl::unexpected(input_bias.error());
    auto hidden_bias = readVector(weights, name + ".hidden_bias", 3 * size);
    if (!hidden_bias) return tl::unexpected(hidden_bias.error());
    return GruLayer{std::move(*input_weight), std::move(*hidden_weight), std::move(*input_bias),
                    std::move(*hidden_bias)};
}

MatrixXf GruLayer::forward(const MatrixXf& x, bool backward) const {
    const Eigen::Index size = hidden_weight.cols();
    MatrixXf seen = input_bias.replicate(1, x.cols());
    seen.noalias() += input_weight * x;
    MatrixXf out(size, x.cols());
    VectorXf state = VectorXf::Zero(size);
    for (Eigen::Index step = 0; step < x.cols(); ++step) {
        const Eigen::Index t = backward ? x.cols() - 1 - step : step;
        VectorXf recalled = hidden_bias;
        recalled.noalias() += hidden_weight * state;
        for (Eigen::Index i = 0; i < size; ++i) {
            const float reset = sigmoid(seen(i, t) + recalled[i]);
            const float update = sigmoid(seen(size + i, t) + recalled[size + i]);
            const float candidate = std::tanh(seen(2 * size + i, t) + reset * recalled[2 * size + i]);
            state[i] = (1.0F - update) * candidate + update * state[i];
        }
        out.col(t) = state;
    }
    return out;
}

Result<BidirectionalGru> BidirectionalGru::read(const NetworkWeights& weights, const std::string& name,
                                                int inputs, int size, int layers) {
    BidirectionalGru out;
    for (int layer = 0; layer < layers; ++layer) {
        const std::string of_layer = name + "." + std::to_string(layer);
        const int seen = layer == 0 ? inputs : 2 * size;
        auto forward = GruLayer::read(weights, of_layer + ".forward", seen, size);
        if (!forward) return tl::unexpected(forward.error());
        auto backward = GruLayer::read(weights, of_layer + ".backward", seen, size);
        if (!backward) return tl::unexpected(backward.error());
        out.layers_.push_back({std::move(*forward), std::move(*backward)});
    }
    return out;
}

MatrixXf BidirectionalGru::forward(const MatrixXf& x) const {
    MatrixXf both = x;
    for (const Layer& layer : layers_) {
        const MatrixXf forward = layer.forward.forward(both, false);
        const MatrixXf backward = layer.backward.forward(both, true);
        if (&layer == &layers_.back()) return forward + backward;
        both.resize(2 * forward.rows(), forward.cols());
        both << forward, backward;
    }
    return both;
}

MatrixXf leakyRectified(const MatrixXf& x, float slope) {
    return x.unaryExpr([slope](float value) { return value > 0.0F ? value : slope * value; });
}

}  // namespace deixis::motion
