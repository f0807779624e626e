// Weights of a small flow, drawn at random: of no use but to test arithmetic with.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "motion/networks/flow.hpp"

namespace deixis::tests {

inline motion::NamedArray randomArray(const std::string& name, std::vector<std::size_t> shape, double sd,
                                      Random& random) {
    motion::NamedArray out{name, shape, {}};
    std::size_t count = 1;
    for (const std::size_t size : shape) count *= size;
    for (std::size_t i = 0; i < count; ++i) out.values.push_back(static_cast<float>(random.normal(0.0, sd)));
    return out;
}

inline std::vector<motion::NamedArray> randomFlowArrays(const motion::FlowShape& shape, std::uint64_t seed) {
    Random random(seed);
    std::vector<motion::NamedArray> out;
    const auto n = static_cast<std::size_t>(shape.size);
    const auto h = static_cast<std::size_t>(shape.hidden);
    const auto inputs = static_cast<std::size_t>(shape.kept() + shape.condition);
    const auto changed = static_cast<std::size_t>(shape.changed());
    for (int k = 0; k < shape.steps; ++k) {
        const auto add = [&](const char* name, const std::vector<std::size_t>& sizes, double sd) {
            out.push_back(randomArray(fmt::format("flow.{}.{}", k, name), sizes, sd, random));
        };
        add("actnorm.bias", {n}, 0.5);
        add("actnorm.log_scale", {n}, 0.3);
        // Larger ones would make a matrix that no one can invert in float.
        add("linear.lower", {n, n}, 0.6 / std::sqrt(shape.size));
        add("linear.upper", {n, n}, 0.6 / std::sqrt(shape.size));
        add("linear.log_size", {n}, 0.2);
        add("coupling.first.input_weight", {4 * h, inputs}, 0.4);
        add("coupling.first.hidden_weight", {4 * h, h}, 0.4);
        add("coupling.first.bias", {4 * h}, 0.2);
        add("coupling.second.input_weight", {4 * h, h}, 0.4);
        add("coupling.second.hidden_weight", {4 * h, h}, 0.4);
        add("coupling.second.bias", {4 * h}, 0.2);
        add("coupling.output.weight", {2 * changed, h}, 0.4);
        add("coupling.output.bias", {2 * changed}, 0.2);
        std::vector<float> permutation(n), sign(n);
        std::iota(permutation.begin(), permutation.end(), 0.0F);
        random.shuffle(std::span<float>(permutation));
        for (float& one : sign) one = random.below(2) == 0 ? 1.0F : -1.0F;
        out.push_back({fmt::format("flow.{}.linear.permutation", k), {n}, permutation});
        out.push_back({fmt::format("flow.{}.linear.sign", k), {n}, sign});
    }
    return out;
}

inline motion::VectorXf randomVector(int size, Random& random) {
    motion::VectorXf out(size);
    for (float& value : out) value = static_cast<float>(random.normal());
    return out;
}

}  // namespace deixis::tests
