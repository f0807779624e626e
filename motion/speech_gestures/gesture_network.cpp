#include "motion/speech_gestures/gesture_network.hpp"

#include <fmt/format.h>

#include "motion/networks/taking.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"

namespace deixis::motion {

void appendShape(const GestureShape& shape, NetworkWeights& weights) {
    weights.settings["sound_channels"] = static_cast<double>(shape.sound_channels);
    weights.settings["sound_size"] = static_cast<double>(shape.sound_size);
    weights.settings["word_size"] = static_cast<double>(shape.word_size);
    weights.settings["word_channels"] = static_cast<double>(shape.word_channels);
    weights.settings["word_levels"] = static_cast<double>(shape.word_levels);
    weights.settings["text_size"] = static_cast<double>(shape.text_size);
    weights.settings["hidden"] = static_cast<double>(shape.hidden);
    weights.settings["layers"] = static_cast<double>(shape.layers);
    weights.settings["controls"] = shape.controls ? 1.0 : 0.0;
}

Result<GestureShape> readShape(const NetworkWeights& weights) {
    constexpr int most = 4096, most_levels = 8;
    GestureShape out;
    int controls = 0;
    Taking take;
    take(out.sound_channels, weights.count("sound_channels", 1, most));
    take(out.sound_size, weights.count("sound_size", 1, most));
    take(out.word_size, weights.count("word_size", 1, most));
    take(out.word_channels, weights.count("word_channels", 1, most));
    take(out.word_levels, weights.count("word_levels", 1, most_levels));
    take(out.text_size, weights.count("text_size", 1, most));
    take(out.hidden, weights.count("hidden", 2, most));
    take(out.layers, weights.count("layers", 1, most_levels));
    take(controls, weights.count("controls", 0, 1));
    if (take.problem()) return tl::unexpected(*take.problem());
    out.controls = controls == 1;
    return out;
}

Result<GestureNetwork> GestureNetwork::read(const NetworkWeights& weights, const GestureShape& shape) {
    GestureNetwork out;
    out.shape_ = shape;
    const auto channels = shape.soundChannels();
    Taking take;
    out.sound_.resize(sound_strides.size());
    for (std::size_t i = 0; i < sound_strides.size(); ++i)
        take(out.sound_[i],
             Convolution::read(weights, fmt::format("sound.{}", i), channels[i], channels[i + 1],
                               {.kernel = sound_kernel, .stride = sound_strides[i]}));
    take(out.word_entry_, Linear::read(weights, "words.entry", shape.word_size, shape.word_channels));
    out.words_.resize(static_cast<std::size_t>(shape.word_levels));
    for (int level = 0; level < shape.word_levels; ++level)
        take(out.words_[static_cast<std::size_t>(level)],
             Convolution::read(weights, fmt::format("words.{}", level), shape.word_channels,
                               shape.word_channels,
                               {.kernel = word_kernel, .dilation = 1 << level, .padding = 1 << level}));
    take(out.text_, Linear::read(weights, "words.output", shape.word_channels, shape.text_size));
    take(out.gru_, BidirectionalGru::read(weights, "gru", shape.inputs(), shape.hidden, shape.layers));
    take(out.middle_, Linear::read(weights, "middle", shape.hidden, shape.hidden / 2));
    take(out.output_, Linear::read(weights, "output", shape.hidden / 2, upper_body_numbers));
    if (take.problem()) return tl::unexpected(*take.problem());
    return out;
}

MatrixXf GestureNetwork::encodeSound(const std::vector<float>& heard_around) const {
    MatrixXf x =
        Eigen::Map<const MatrixXf>(heard_around.data(), 1, static_cast<Eigen::Index>(heard_around.size()));
    for (const Convolution& convolution : sound_) {
        x = convolution.forward(x);
        if (&convolution != &sound_.back()) x = leakyRectified(x, sound_slope);
    }
    return x;
}

MatrixXf GestureNetwork::encodeWords(const MatrixXf& words) const {
    MatrixXf x = (word_entry_.weight * words).colwise() + word_entry_.bias;
    for (const Convolution& convolution : words_) x += leakyRectified(convolution.forward(x), 0.0F);
    return (text_.weight * x).colwise() + text_.bias;
}

MatrixXf GestureNetwork::forward(const MatrixXf& sound, const MatrixXf& words,
                                 const MatrixXf& controls) const {
    MatrixXf x(shape_.inputs(), sound.cols());
    x.topRows(shape_.sound_size) = sound;
    x.middleRows(shape_.sound_size, shape_.text_size) = encodeWords(words);
    if (shape_.controls) x.bottomRows(control_numbers) = controls;
    const MatrixXf hidden = gru_.forward(x);
    const MatrixXf middle = leakyRectified((middle_.weight * hidden).colwise() + middle_.bias, output_slope);
    return (output_.weight * middle).colwise() + output_.bias;
}

}  // namespace deixis::motion
