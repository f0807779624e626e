#include "network_module.hpp"

#include <fmt/format.h>

#include "learning/networks/tensors.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"

namespace deixis::learning {

namespace {

using torch::Tensor;

/// A convolution and the normalisation after it as one convolution.
void appendFolded(const torch::nn::Conv1d& convolution, const torch::nn::BatchNorm1d* norm,
                  const std::string& name, std::vector<motion::NamedArray>& out) {
    Tensor weight = convolution->weight, bias = convolution->bias;
    if (norm != nullptr) {
        const auto& of = **norm;
        const Tensor scale = of.weight / (of.running_var + of.options.eps()).sqrt();
        weight = weight * scale.reshape({-1, 1, 1});
        bias = (bias - of.running_mean) * scale + of.bias;
    }
    out.push_back(arrayOf(name + ".weight", weight));
    out.push_back(arrayOf(name + ".bias", bias));
}

/// frames x windows x numbers through it, the directions summed.
Tensor summed(torch::nn::GRU& gru, const Tensor& x) {
    const Tensor both = std::get<0>(gru->forward(x));
    const std::int64_t size = both.size(-1) / 2;
    return both.narrow(-1, 0, size) + both.narrow(-1, size, size);
}

}  // namespace

GestureModule::GestureModule(const motion::GestureShape& shape, double dropout) : shape_(shape) {
    const auto channels = shape.soundChannels();
    for (std::size_t i = 0; i < motion::sound_strides.size(); ++i) {
        sound_.push_back(register_module(
            fmt::format("sound{}", i),
            torch::nn::Conv1d(torch::nn::Conv1dOptions(channels[i], channels[i + 1], motion::sound_kernel)
                                  .stride(motion::sound_strides[i]))));
        if (i + 1 < motion::sound_strides.size())
            norms_.push_back(
                register_module(fmt::format("norm{}", i), torch::nn::BatchNorm1d(channels[i + 1])));
    }
    word_entry_ = register_module("word_entry", torch::nn::Linear(shape.word_size, shape.word_channels));
    for (int level = 0; level < shape.word_levels; ++level)
        words_.push_back(register_module(
            fmt::format("words{}", level),
            torch::nn::Conv1d(
                torch::nn::Conv1dOptions(shape.word_channels, shape.word_channels, motion::word_kernel)
                    .dilation(1 << level)
                    .padding(1 << level))));
    text_ = register_module("text", torch::nn::Linear(shape.word_channels, shape.text_size));
    gru_ = register_module("gru", torch::nn::GRU(torch::nn::GRUOptions(shape.inputs(), shape.hidden)
                                                     .num_layers(shape.layers)
                                                     .bidirectional(true)
                                                     .dropout(shape.layers > 1 ? dropout : 0.0)));
    middle_ = register_module("middle", torch::nn::Linear(shape.hidden, shape.hidden / 2));
    output_ = register_module(
        "output", torch::nn::Linear(shape.hidden / 2, static_cast<std::int64_t>(motion::upper_body_numbers)));
}

Tensor GestureModule::encodeSound(const Tensor& sound) {
    Tensor x = sound.unsqueeze(1);
    for (std::size_t i = 0; i < sound_.size(); ++i) {
        x = sound_[i]->forward(x);
        if (i < norms_.size()) x = torch::leaky_relu(norms_[i]->forward(x), motion::sound_slope);
    }
    return x;
}

Tensor GestureModule::forward(const Tensor& sound, const Tensor& words, const Tensor& controls) {
    const Tensor heard = encodeSound(sound).permute({2, 0, 1});
    Tensor said = word_entry_->forward(words).permute({0, 2, 1});
    for (auto& level : words_) said = said + torch::relu(level->forward(said));
    said = text_->forward(said.permute({2, 0, 1}));
    std::vector<Tensor> inputs{heard, said};
    if (shape_.controls) inputs.push_back(controls.transpose(0, 1));
    const Tensor hidden = summed(gru_, torch::cat(inputs, -1));
    const Tensor middle = torch::leaky_relu(middle_->forward(hidden), motion::output_slope);
    return output_->forward(middle).transpose(0, 1);
}

void GestureModule::append(std::vector<motion::NamedArray>& out) const {
    const torch::NoGradGuard no_gradient;
    for (std::size_t i = 0; i < sound_.size(); ++i)
        appendFolded(sound_[i], i < norms_.size() ? &norms_[i] : nullptr, fmt::format("sound.{}", i), out);
    appendLinear(word_entry_, "words.entry", out);
    for (std::size_t i = 0; i < words_.size(); ++i)
        appendFolded(words_[i], nullptr, fmt::format("words.{}", i), out);
    appendLinear(text_, "words.output", out);
    appendGru(gru_, "gru", out);
    appendLinear(middle_, "middle", out);
    appendLinear(output_, "output", out);
}

GestureDiscriminator::GestureDiscriminator(int hidden, int layers) {
    constexpr std::array<std::int64_t, 4> channels{motion::upper_body_numbers, 16, 8, 8};
    constexpr int kernel = 3;
    for (std::size_t i = 0; i + 1 < channels.size(); ++i)
        convolutions_.push_back(register_module(fmt::format("convolution{}", i),
                                                torch::nn::Conv1d(channels[i], channels[i + 1], kernel)));
    gru_ = register_module(
        "gru", torch::nn::GRU(
                   torch::nn::GRUOptions(channels.back(), hidden).num_layers(layers).bidirectional(true)));
    output_ = register_module("output", torch::nn::Linear(hidden, 1));
}

Tensor GestureDiscriminator::forward(const Tensor& poses) {
    constexpr double slope = 0.2;
    Tensor x = poses.transpose(1, 2);
    for (auto& convolution : convolutions_) x = torch::leaky_relu(convolution->forward(x), slope);
    return output_->forward(summed(gru_, x.permute({2, 0, 1}))).mean(0).squeeze(-1);
}

void appendGru(const torch::nn::GRU& gru, const std::string& name, std::vector<motion::NamedArray>& out) {
    // Input weight, hidden weight and the two biases, of each layer forwards and then backwards.
    const auto numbers = gru->parameters();
    const char* const parts[] = {"input_weight", "hidden_weight", "input_bias", "hidden_bias"};
    const char* const directions[] = {"forward", "backward"};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out.push_back(arrayOf(fmt::format("{}.{}.{}.{}", name, i / 8, directions[i / 4 % 2], parts[i % 4]),
                              numbers[i]));
}

StyleMeasure::StyleMeasure(int frames)
    : over_frames_(torch::zeros({frames, frames})), over_steps_(torch::zeros({frames - 1, frames})) {
    constexpr int half = motion::style_window / 2;
    constexpr double whole = 2.0 * half + 1.0;
    for (int i = 0; i < frames; ++i) {
        const int first = std::max(0, i - half), last = std::min(frames - 1, i + half);
        const int first_step = std::max(first, 1);
        for (int j = first; j <= last; ++j)
            over_frames_[j][i] = whole / ((last - first + 1) * double(motion::style_window));
        for (int j = first_step; j <= last; ++j)
            over_steps_[j - 1][i] = whole / ((last - first_step + 1) * double(motion::style_window));
    }
}

Tensor StyleMeasure::of(const Tensor& directions) const {
    constexpr double least = 1e-12;  // below the root, whose slope is infinite at 0
    const auto lengthOf = [](const Tensor& vectors) { return (vectors.square().sum(-1) + least).sqrt(); };
    std::vector<Tensor> joints(motion::upper_joint_count);
    joints[static_cast<std::size_t>(motion::UpperJoint::spine)] =
        torch::zeros_like(directions.narrow(-1, 0, 3));
    for (std::size_t b = 0; b < motion::upper_bone_count; ++b) {
        const Tensor direction = directions.narrow(-1, static_cast<std::int64_t>(3 * b), 3);
        const auto& bone = motion::upper_bones[b];
        joints[static_cast<std::size_t>(bone.to)] =
            joints[static_cast<std::size_t>(bone.from)] +
            bone.length_m * direction / lengthOf(direction).unsqueeze(-1);
    }
    const Tensor positions = torch::stack(joints, 1);  // windows x joints x frames x 3
    const std::int64_t steps = directions.size(1) - 1;
    const Tensor paths = lengthOf(positions.narrow(2, 1, steps) - positions.narrow(2, 0, steps));
    const auto wrist = [](motion::UpperJoint joint) { return static_cast<std::int64_t>(joint); };
    const std::int64_t l = wrist(motion::UpperJoint::left_wrist), r = wrist(motion::UpperJoint::right_wrist);
    const Tensor speed = paths.sum(1).matmul(over_steps_);
    const Tensor space = lengthOf(positions.select(1, l) - positions.select(1, r)).matmul(over_frames_);
    const Tensor left = paths.select(1, l).matmul(over_steps_),
                 right = paths.select(1, r).matmul(over_steps_);
    // Hands that do not move have the least length as their paths, and are alike.
    const Tensor handedness = torch::where(right > left, left / right - 1.0, 1.0 - right / left);
    return torch::stack({speed, space, handedness}, -1);
}

Tensor normalisedStyles(const Tensor& styles, const motion::StyleNorm& norm) {
    constexpr double limit = 3.0;
    const auto inverse = [](double sd) { return sd > 0.0 ? 1.0 / sd : 0.0; };
    const Tensor mean =
        torch::tensor({norm.mean.speed, norm.mean.space, norm.mean.handedness}, torch::kFloat32);
    const Tensor scale = torch::tensor(
        {inverse(norm.sd.speed), inverse(norm.sd.space), inverse(norm.sd.handedness)}, torch::kFloat32);
    return ((styles - mean) * scale).clamp(-limit, limit);
}

}  // namespace deixis::learning
