// Weights of a small gesture model, drawn at random: of no use but to test what is made of them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "flow_fixture.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"

namespace deixis::tests {

inline motion::GestureShape smallGestureShape() {
    return {.sound_channels = 2,
            .sound_size = 4,
            .word_size = 3,
            .word_channels = 6,
            .word_levels = 2,
            .text_size = 4,
            .hidden = 16,
            .layers = 2,
            .controls = true};
}

/// Every array of the network, each with a spread at which signals neither die out nor grow.
inline void appendRandomNetwork(const motion::GestureShape& shape, std::uint64_t seed,
                                motion::NetworkWeights& weights) {
    Random random(seed);
    const auto add = [&](const std::string& name, const std::vector<int>& sizes, double gain = 1.0) {
        double inputs = 1.0;
        for (std::size_t i = 1; i < sizes.size(); ++i) inputs *= sizes[i];
        weights.arrays.push_back(randomArray(name, std::vector<std::size_t>(sizes.begin(), sizes.end()),
                                             sizes.size() > 1 ? gain / std::sqrt(inputs) : 0.02, random));
    };
    const auto addLayer = [&](const std::string& name, const std::vector<int>& sizes, double gain = 1.0) {
        add(name + ".weight", sizes, gain);
        add(name + ".bias", {sizes.front()});
    };
    const auto channels = shape.soundChannels();
    for (std::size_t i = 0; i < motion::sound_strides.size(); ++i)
        addLayer(fmt::format("sound.{}", i), {channels[i + 1], channels[i], motion::sound_kernel}, 1.4);
    addLayer("words.entry", {shape.word_channels, shape.word_size});
    for (int level = 0; level < shape.word_levels; ++level)
        addLayer(fmt::format("words.{}", level),
                 {shape.word_channels, shape.word_channels, motion::word_kernel});
    addLayer("words.output", {shape.text_size, shape.word_channels});
    for (int layer = 0; layer < shape.layers; ++layer)
        for (const char* direction : {"forward", "backward"}) {
            const std::string name = fmt::format("gru.{}.{}.", layer, direction);
            add(name + "input_weight", {3 * shape.hidden, layer == 0 ? shape.inputs() : 2 * shape.hidden},
                1.5);
            add(name + "hidden_weight", {3 * shape.hidden, shape.hidden});
            add(name + "input_bias", {3 * shape.hidden});
            add(name + "hidden_bias", {3 * shape.hidden});
        }
    addLayer("middle", {shape.hidden / 2, shape.hidden}, 2.0);
    addLayer("output", {motion::upper_body_numbers, shape.hidden / 2});
}

inline motion::NetworkWeights randomGestureWeights(const motion::GestureShape& shape,
                                                   std::uint64_t seed = 1) {
    motion::NetworkWeights out;
    out.file = "random.weights";
    out.architecture = motion::speech_gestures_architecture;
    motion::appendShape(shape, out);
    motion::appendPosture(motion::relaxedUpperBody(), {{0.3, 0.5, 0.0}, {0.1, 0.2, 0.4}}, out);
    motion::MatrixXf vectors = motion::MatrixXf::Zero(shape.word_size, 2);
    vectors.col(0).setOnes();
    vectors.col(1).setConstant(-2.0F);
    motion::WordVectors({"yes", "shelf"}, vectors).append(out);
    appendRandomNetwork(shape, seed, out);
    return out;
}

/// A model of which one knows what it makes: a posed frame is as posed; before and after it each frame has
/// the share sigmoid(3) of how far the next one is from the mean pose, until a frame that is posed, too. It
/// hears nothing.
inline motion::NetworkWeights copyingGestureWeights() {
    motion::GestureShape shape = smallGestureShape();
    shape.hidden = 54;
    shape.layers = 1;
    motion::NetworkWeights out = randomGestureWeights(shape);
    const auto hidden = static_cast<std::size_t>(shape.hidden),
               inputs = static_cast<std::size_t>(shape.inputs());
    const std::size_t controls = inputs - motion::control_numbers;
    constexpr float small = 0.01F;  // where tanh is a straight line
    for (motion::NamedArray& array : out.arrays) {
        const auto ends = [&](const char* end) { return array.name.ends_with(end); };
        if (!array.name.starts_with("gru.") && !array.name.starts_with("middle.") &&
            !array.name.starts_with("output."))
            continue;
        std::ranges::fill(array.values, 0.0F);
        for (std::size_t i = 0; i < motion::upper_body_numbers; ++i) {
            if (ends("input_weight")) {
                array.values[(hidden + i) * inputs + controls + motion::control_pose_mask] = -40.0F;
                array.values[(2 * hidden + i) * inputs + controls + i] = small;
            }
            if (ends("input_bias")) array.values[hidden + i] = 3.0F;
            // Both directions' sum, kept positive between the layers.
            if (array.name == "middle.weight") array.values[i * hidden + i] = 0.5F / small;
            if (array.name == "middle.bias") array.values[i] = 8.0F;
            if (array.name == "output.weight") array.values[i * (hidden / 2) + i] = 1.0F;
            if (array.name == "output.bias") array.values[i] = -8.0F;
        }
    }
    return out;
}

}  // namespace deixis::tests
