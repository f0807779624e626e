#include "physics/policy/policy.hpp"

#include <fmt/format.h>

#include <utility>

#include "motion/networks/taking.hpp"

namespace deixis::physics {

using motion::VectorXf;

Result<Policy> Policy::read(const motion::NetworkWeights& weights, const std::string& name, int inputs,
                            std::span<const int> hidden, int outputs) {
    Policy out;
    motion::Taking take;
    take(out.input_mean_, motion::readVector(weights, name + ".input_mean", inputs));
    take(out.input_sd_, motion::readVector(weights, name + ".input_sd", inputs));
    take(out.output_mean_, motion::readVector(weights, name + ".output_mean", outputs));
    take(out.output_sd_, motion::readVector(weights, name + ".output_sd", outputs));
    int from = inputs;
    for (std::size_t i = 0; i <= hidden.size(); ++i) {
        const int to = i < hidden.size() ? hidden[i] : outputs;
        take(out.layers_.emplace_back(),
             motion::Linear::read(weights, fmt::format("{}.layer{}", name, i), from, to));
        from = to;
    }
    if (take.problem()) return tl::unexpected(*take.problem());
    if (!(out.input_sd_.array() > 0.0F).all() || !(out.output_sd_.array() > 0.0F).all())
        return fail(weights.file + ": " + name, "found a standard deviation of 0 or less");
    return out;
}

void Policy::act(std::span<const float> seen, std::span<double> targets_rad) const {
    VectorXf x = Eigen::Map<const VectorXf>(seen.data(), static_cast<Eigen::Index>(seen.size()));
    x = ((x - input_mean_).array() / input_sd_.array()).max(-largest_input).min(largest_input);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        x = layers_[i].forward(x);
        if (i + 1 < layers_.size()) x = x.cwiseMax(0.0F);
    }
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        targets_rad[i] = static_cast<double>(output_mean_[at] + output_sd_[at] * x[at]);
    }
}

}  // namespace deixis::physics
