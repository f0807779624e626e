#include "trainer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "learning/networks/optimising.hpp"
#include "learning/networks/tensors.hpp"

namespace deixis::learning {

namespace {

using motion::ControlledFrames;

Sequences asSequence(const ControlledFrames& frames, const std::vector<double>& at_ease,
                     const motion::MoglowShape& shape) {
    std::vector<float> x, condition;
    for (std::size_t i = 0; i < frames.features.size(); ++i) {
        x.insert(x.end(), frames.features[i].begin(), frames.features[i].end());
        const auto one = motion::moglowCondition(frames, i, at_ease, shape);
        condition.insert(condition.end(), one.begin(), one.end());
    }
    const auto count = static_cast<std::int64_t>(frames.features.size());
    return {torch::tensor(x).reshape({count, 1, -1}), torch::tensor(condition).reshape({count, 1, -1})};
}

/// Vaswani et al. (2017): a linear rise, then a fall with the root of the updates; 1 at the end of the rise.
double noam(int update, int warm_up) {
    const double n = update, w = warm_up;
    return std::sqrt(w) * std::min(1.0 / std::sqrt(n), n / (w * std::sqrt(w)));
}

}  // namespace

MoglowModule::MoglowModule(int features, const motion::MoglowShape& shape) {
    encoder_ = register_module("encoder", torch::nn::Linear(shape.conditionSize(features), shape.hidden));
    flow_ = register_module(
        "flow", std::make_shared<FlowModule>(FlowSizes{features, shape.hidden, shape.steps, shape.hidden}));
}

torch::Tensor MoglowModule::bits(const torch::Tensor& x, const torch::Tensor& condition) {
    const auto latents = flow_->forward(x, encoded(condition));
    const double log_root = 0.5 * std::log(2.0 * pi) * static_cast<double>(x.size(-1));
    const torch::Tensor nats = 0.5 * latents.z.square().sum(-1) + log_root - latents.log_determinant;
    return nats / std::log(2.0);
}

void MoglowModule::append(std::vector<motion::NamedArray>& out) const {
    appendLinear(encoder_, "encoder", out);
    flow_->append(out);
}

MoglowTrainer::MoglowTrainer(const DemonstrationSets& data, const motion::PoseFeatures& features,
                             const MoglowSettings& settings)
    : settings_(settings),
      features_(features),
      scale_(scaleOf(data.training, features)),
      raise_s_(meanRaise_s(data.training)),
      hold_s_(meanHold_s(data.training)) {
    setUpTorch(settings.threads);
    const std::vector<double> at_ease = scale_.standardised(std::vector<double>(features.size(), 0.0));
    const auto sequenceOf = [&](const motion::Demonstration& one) {
        return asSequence(framesOf(one, features, scale_, settings), at_ease, settings.shape);
    };
    const double frame_time_s = settings.shape.frame_time_s;
    window_frames_ = std::lround(settings.window_s / frame_time_s);
    const std::int64_t step = std::max(1L, std::lround(settings.window_step_s / frame_time_s));
    for (const auto& one : data.training) {
        clips_.push_back(sequenceOf(one));
        const std::int64_t last = std::max<std::int64_t>(0, clips_.back().x.size(0) - window_frames_);
        for (std::int64_t begin = 0; begin <= last; begin += step)
            windows_.push_back({clips_.size() - 1, begin});
    }
    for (const auto& one : data.validation) validation_.push_back(sequenceOf(one));
    window_frames_ = std::min(window_frames_, std::ranges::min(clips_, {}, [](const Sequences& clip) {
                                                  return clip.x.size(0);
                                              }).x.size(0));

    seedTorch(settings.seed, "moglow model");
    model_ = std::make_shared<MoglowModule>(static_cast<int>(features.size()), settings.shape);
    const Sequences first = batch(0);
    {
        torch::NoGradGuard no_gradient;
        model_->flow().initialiseFrom(first.x, model_->encoded(first.condition));
    }
    optimiser_ = std::make_unique<torch::optim::Adam>(model_->parameters(),
                                                      torch::optim::AdamOptions(settings.learning_rate));
}

void MoglowTrainer::dropPast(torch::Tensor& condition) const {
    const auto past = static_cast<std::int64_t>(settings_.shape.past_frames);
    const auto size = static_cast<std::int64_t>(features_.size());
    const torch::Tensor kept =
        (torch::rand({condition.size(0), condition.size(1), past, 1}) >= settings_.dropout)
            .to(torch::kFloat32);
    torch::Tensor poses = condition.narrow(-1, 0, past * size);
    torch::Tensor by_pose = poses.reshape({condition.size(0), condition.size(1), past, size});
    by_pose = (by_pose + settings_.noise * torch::randn_like(by_pose)) * kept;
    poses.copy_(by_pose.reshape(poses.sizes()));
}

Sequences MoglowTrainer::batch(int number) const {
    const std::string label = fmt::format("moglow update {}", number);
    Random random(settings_.seed, label);
    seedTorch(settings_.seed, label);
    std::vector<torch::Tensor> x, condition;
    for (int i = 0; i < settings_.batch; ++i) {
        const Window& window = windows_[random.below(windows_.size())];
        const Sequences& clip = clips_[window.clip];
        x.push_back(clip.x.narrow(0, window.begin, window_frames_));
        condition.push_back(clip.condition.narrow(0, window.begin, window_frames_));
    }
    Sequences out{torch::cat(x, 1), torch::cat(condition, 1)};
    out.x += settings_.noise * torch::randn_like(out.x);
    dropPast(out.condition);
    return out;
}

double MoglowTrainer::update(int number) {
    const Sequences sequences = batch(number);
    setRate(*optimiser_, settings_.learning_rate * noam(number, settings_.warm_up));
    optimiser_->zero_grad();
    const torch::Tensor loss = model_->bits(sequences.x, sequences.condition).mean();
    const auto bits = loss.item<double>();
    if (!std::isfinite(bits)) return bits;
    loss.backward();
    torch::nn::utils::clip_grad_value_(model_->parameters(), settings_.max_gradient);
    torch::nn::utils::clip_grad_norm_(model_->parameters(), settings_.max_gradient_norm);
    optimiser_->step();
    return bits;
}

double MoglowTrainer::validationBits() {
    torch::NoGradGuard no_gradient;
    double sum = 0.0, count = 0.0;
    seedTorch(settings_.seed, "moglow validation");
    for (const Sequences& one : validation_) {
        const torch::Tensor noisy = one.x + settings_.noise * torch::randn_like(one.x);
        sum += model_->bits(noisy, one.condition).sum().item<double>();
        count += static_cast<double>(one.x.size(0));
    }
    return sum / count;
}

motion::NetworkWeights MoglowTrainer::weights() const {
    motion::NetworkWeights out;
    out.architecture = motion::moglow_architecture;
    out.seed = settings_.seed;
    const motion::MoglowShape& shape = settings_.shape;
    out.settings = {{"steps", double(shape.steps)},
                    {"hidden", double(shape.hidden)},
                    {"past_frames", double(shape.past_frames)},
                    {"look_ahead", double(shape.look_ahead)},
                    {"frame_time_s", shape.frame_time_s},
                    {"temperature", settings_.temperature},
                    {"raise_s", raise_s_},
                    {"hold_s", hold_s_},
                    {"features", features_.names()},
                    {"window_s", settings_.window_s},
                    {"window_step_s", settings_.window_step_s},
                    {"rest_before_s", settings_.rest_before_s},
                    {"rest_after_s", settings_.rest_after_s},
                    {"batch", double(settings_.batch)},
                    {"learning_rate", settings_.learning_rate},
                    {"warm_up", double(settings_.warm_up)},
                    {"max_gradient", settings_.max_gradient},
                    {"max_gradient_norm", settings_.max_gradient_norm},
                    {"dropout", settings_.dropout},
                    {"noise", settings_.noise}};
    const auto vector = [](const char* name, const std::vector<double>& values) {
        return motion::NamedArray{name, {values.size()}, std::vector<float>(values.begin(), values.end())};
    };
    out.arrays = {vector("feature_mean", scale_.mean), vector("feature_sd", scale_.sd)};
    model_->append(out.arrays);
    return out;
}

bool MoglowTrainer::sound() const {
    return fitFloat16(model_->parameters());
}

void MoglowTrainer::save(torch::serialize::OutputArchive& archive) const {
    torch::serialize::OutputArchive model, optimiser;
    model_->save(model);
    optimiser_->save(optimiser);
    archive.write("model", model);
    archive.write("optimiser", optimiser);
}

void MoglowTrainer::load(torch::serialize::InputArchive& archive) {
    torch::serialize::InputArchive model, optimiser;
    archive.read("model", model);
    archive.read("optimiser", optimiser);
    model_->load(model);
    optimiser_->load(optimiser);
}

}  // namespace deixis::learning
