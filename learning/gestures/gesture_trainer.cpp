#include "gesture_trainer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "learning/networks/optimising.hpp"
#include "learning/networks/tensors.hpp"

namespace deixis::learning {

namespace {

using motion::gesture_overlap;
using torch::Tensor;

constexpr std::size_t tried_at_once = 128;  // windows, where nothing is learned

motion::UpperBodyPose poseOfTensor(const Tensor& numbers) {
    motion::UpperBodyPose out;
    for (std::size_t b = 0; b < motion::upper_bone_count; ++b)
        for (int axis = 0; axis < 3; ++axis)
            out.directions[b][axis] = numbers[static_cast<std::int64_t>(3 * b) + axis].item<double>();
    return out;
}

std::unique_ptr<torch::optim::Adam> adam(const torch::nn::Module& module, const GestureSettings& settings) {
    constexpr double second_beta = 0.999;
    return std::make_unique<torch::optim::Adam>(
        module.parameters(),
        torch::optim::AdamOptions(settings.learning_rate).betas({settings.beta, second_beta}));
}

/// Cross-entropy of logits that should all say `real`.
Tensor entropyOf(const Tensor& logits, bool real) {
    return torch::binary_cross_entropy_with_logits(logits, torch::full_like(logits, real ? 1.0 : 0.0));
}

/// Over the elements that are controlled; without controls over all.
Tensor styleLoss(const Tensor& apart, const Tensor& controls) {
    if (!controls.defined()) return apart.mean();
    const Tensor mask = controls.narrow(-1, motion::control_style_mask, 3);
    return (apart * mask).sum() / mask.sum().clamp_min(1.0);
}

template <typename Each>
void forRangesOf(const GestureWindows& windows, const Each& each) {
    for (std::size_t first = 0; first < windows.count(); first += tried_at_once)
        each(windows.range(first, tried_at_once));
}

Tensor allPosesOf(const GestureWindows& windows) {
    std::vector<Tensor> out;
    forRangesOf(windows, [&out](const WindowBatch& batch) { out.push_back(batch.poses); });
    return torch::cat(out);
}

Tensor scoredPart(const Tensor& windows) {
    return windows.narrow(1, scored_first, scored_frames);
}

}  // namespace

GestureTrainer::GestureTrainer(const GestureTakes& takes, const GestureSettings& settings)
    : settings_(settings),
      words_(takes.words),
      mean_(meanPoseOf(takes.training)),
      training_(takes.training, takes.words, mean_, settings.stride),
      validation_(takes.validation, takes.words, mean_, gesture_overlap),
      held_out_(allPosesOf(validation_)),
      updates_per_epoch_(std::max(1, static_cast<int>(training_.count()) / settings.batch)),
      order_(training_.count()) {
    setUpTorch(settings.threads);
    // Convolutions of hundreds of thousands of samples take a third less time by oneDNN, which leaves GRUs
    // alone.
    at::globalContext().setUserEnabledMkldnn(true);
    {
        const torch::NoGradGuard no_gradient;
        norm_ = normOf(measure_.of(allPosesOf(training_) + mean_));
    }
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    seedTorch(settings.seed, "gestures model");
    model_ = std::make_shared<GestureModule>(settings.shape, settings.dropout);
    discriminator_ =
        std::make_shared<GestureDiscriminator>(settings.discriminator_hidden, settings.discriminator_layers);
    autoencoder_ = std::make_shared<MotionAutoencoder>();
    optimiser_ = adam(*model_, settings);
    discriminator_optimiser_ = adam(*discriminator_, settings);
}

Tensor GestureTrainer::stylesOf(const Tensor& poses) const {
    return normalisedStyles(measure_.of(poses + mean_), norm_);
}

Tensor GestureTrainer::unit(const Tensor& poses) const {
    const Tensor directions = (poses + mean_).reshape({poses.size(0), poses.size(1), -1, 3});
    return torch::nn::functional::normalize(directions, torch::nn::functional::NormalizeFuncOptions().dim(-1))
               .reshape(poses.sizes()) -
           mean_;
}

bool GestureTrainer::adversarialAt(int number) const {
    return settings_.gan_weight > 0.0 && number > settings_.gan_after * updates_per_epoch_;
}

void GestureTrainer::trainAutoencoder() {
    constexpr double rate = 1e-3;
    seedTorch(settings_.seed, "gestures autoencoder");
    Random random(settings_.seed, "gestures autoencoder");
    autoencoder_ = std::make_shared<MotionAutoencoder>();
    torch::optim::Adam optimiser(autoencoder_->parameters(), torch::optim::AdamOptions(rate));
    const Tensor all = allPosesOf(training_);
    for (int i = 0; i < settings_.autoencoder_updates; ++i) {
        const Tensor windows = all.index_select(0, drawnIndices(random, all.size(0), settings_.batch));
        const auto first = static_cast<std::int64_t>(random.below(gesture_overlap + 1));
        const Tensor part = windows.narrow(1, first, scored_frames);
        optimiser.zero_grad();
        torch::mse_loss(autoencoder_->decode(autoencoder_->encode(part)), part).backward();
        optimiser.step();
    }
}

WindowBatch GestureTrainer::drawn(int number, Random& random) {
    const int epoch = (number - 1) / updates_per_epoch_ + 1;
    if (epoch != shuffled_epoch_) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        Random(settings_.seed, fmt::format("gestures epoch {}", epoch)).shuffle(std::span(order_));
        shuffled_epoch_ = epoch;
    }
    const auto size = std::min(order_.size(), static_cast<std::size_t>(settings_.batch));
    const std::size_t begin = static_cast<std::size_t>((number - 1) % updates_per_epoch_) * size;
    return training_.batch(std::span(order_).subspan(begin, size), random);
}

void GestureTrainer::setRates(int number) {
    constexpr double least = 0.05;
    const double done = double(number) / updates();
    const double late = std::max(0.0, (done - settings_.decay_from) / (1.0 - settings_.decay_from));
    const double rate = settings_.learning_rate * (1.0 - (1.0 - least) * late);
    for (auto* optimiser : {optimiser_.get(), discriminator_optimiser_.get()})
        for (auto& group : optimiser->param_groups())
            static_cast<torch::optim::AdamOptions&>(group.options()).lr(rate);
}

double GestureTrainer::updateDiscriminator(const Tensor& real, const Tensor& made) {
    discriminator_optimiser_->zero_grad();
    const Tensor loss = entropyOf(discriminator_->forward(real), true) +
                        entropyOf(discriminator_->forward(made.detach()), false);
    const auto value = loss.item<double>();
    if (!std::isfinite(value)) return value;
    loss.backward();
    discriminator_optimiser_->step();
    return value;
}

GestureLosses GestureTrainer::update(int number) {
    const std::string label = fmt::format("gestures update {}", number);
    Random random(settings_.seed, label);
    seedTorch(settings_.seed, label);
    const WindowBatch batch = drawn(number, random);
    Tensor reference = batch.poses, styles, controls;
    {
        const torch::NoGradGuard no_gradient;
        if (settings_.shape.controls) {
            const ForeignPoses foreign = withForeignPoses(batch.poses, settings_.foreign_share, random);
            if (!foreign.runs.empty()) reference = unit(foreign.poses);
            styles = stylesOf(reference);
            controls = simulatedControls(reference, styles, settings_.control_share, random);
            setForeignControls(controls, foreign);
        } else {
            styles = stylesOf(reference);
        }
    }
    setRates(number);
    model_->train();
    optimiser_->zero_grad();
    const Tensor made = model_->forward(batch.sound, batch.words, controls);
    const bool adversarial = adversarialAt(number);
    GestureLosses out;
    if (adversarial) out.discriminator = updateDiscriminator(batch.poses, made);

    const double grown = std::min(1.0, number / (settings_.decay_from * updates()));
    Tensor apart = torch::smooth_l1_loss(made, reference, at::Reduction::None, settings_.huber_limit);
    if (controls.defined())
        apart =
            apart * (1.0 + grown * settings_.pose_weight * controls.narrow(-1, motion::control_pose_mask, 1));
    const Tensor huber = apart.mean();
    const Tensor style = styleLoss((stylesOf(made) - styles).abs(), controls);
    Tensor loss = settings_.huber_weight * huber + grown * settings_.style_weight * style;
    if (adversarial) {
        const Tensor gan = entropyOf(discriminator_->forward(made), true);
        loss = loss + settings_.gan_weight * gan;
        out.gan = gan.item<double>();
    }
    out.huber = huber.item<double>();
    out.style = style.item<double>();
    if (!std::isfinite(loss.item<double>()) || !std::isfinite(out.discriminator)) {
        out.huber = std::numeric_limits<double>::quiet_NaN();
        return out;
    }
    loss.backward();
    optimiser_->step();
    return out;
}

Tensor GestureTrainer::generated(GivenControls given) {
    const torch::NoGradGuard no_gradient;
    model_->eval();
    std::vector<Tensor> out;
    forRangesOf(validation_, [&](const WindowBatch& batch) {
        Tensor controls;
        if (settings_.shape.controls) controls = heldOutControls(batch.poses, stylesOf(batch.poses), given);
        out.push_back(unit(model_->forward(batch.sound, batch.words, controls)));
    });
    return torch::cat(out);
}

double GestureTrainer::distanceOf(const Tensor& poses) {
    return frechetDistance(autoencoder_->features(scoredPart(held_out_)),
                           autoencoder_->features(scoredPart(poses)));
}

GestureScores GestureTrainer::validate() {
    const torch::NoGradGuard no_gradient;
    GestureScores out;
    out.controls = settings_.shape.controls;
    out.fgd_no_controls = distanceOf(generated(GivenControls::none));
    if (!out.controls) return out;
    const Tensor posed = generated(GivenControls::poses);
    out.fgd_pose_controls = distanceOf(posed);
    out.pcs =
        (posed - held_out_).narrow(1, scored_first + posed_first, posed_frames).abs().mean().item<double>();
    const Tensor styled = generated(GivenControls::styles);
    out.fgd_style_controls = distanceOf(styled);
    out.scs = scoredPart(stylesOf(styled) - stylesOf(held_out_)).abs().mean().item<double>();
    return out;
}

GestureScores GestureTrainer::meanPoseScores() {
    const torch::NoGradGuard no_gradient;
    const Tensor still = torch::zeros_like(held_out_);
    GestureScores out;
    out.fgd_no_controls = out.fgd_pose_controls = out.fgd_style_controls = distanceOf(still);
    out.pcs = held_out_.narrow(1, scored_first + posed_first, posed_frames).abs().mean().item<double>();
    out.scs = scoredPart(stylesOf(still) - stylesOf(held_out_)).abs().mean().item<double>();
    return out;
}

motion::NetworkWeights GestureTrainer::weights() const {
    motion::NetworkWeights out;
    out.architecture = motion::speech_gestures_architecture;
    out.seed = settings_.seed;
    const GestureSettings& s = settings_;
    out.settings = {{"discriminator_hidden", double(s.discriminator_hidden)},
                    {"discriminator_layers", double(s.discriminator_layers)},
                    {"stride", double(s.stride)},
                    {"epochs", double(s.epochs)},
                    {"batch", double(s.batch)},
                    {"learning_rate", s.learning_rate},
                    {"decay_from", s.decay_from},
                    {"pose_weight", s.pose_weight},
                    {"beta", s.beta},
                    {"huber_weight", s.huber_weight},
                    {"huber_limit", s.huber_limit},
                    {"gan_weight", s.gan_weight},
                    {"gan_after", double(s.gan_after)},
                    {"style_weight", s.style_weight},
                    {"control_share", s.control_share},
                    {"foreign_share", s.foreign_share},
                    {"dropout", s.dropout},
                    {"autoencoder_updates", double(s.autoencoder_updates)}};
    motion::appendShape(s.shape, out);
    motion::appendPosture(poseOfTensor(mean_), norm_, out);
    words_.append(out);
    model_->append(out.arrays);
    autoencoder_->append(out.arrays);
    return out;
}

bool GestureTrainer::sound() const {
    return fitFloat16(model_->parameters()) && fitFloat16(model_->buffers()) &&
           fitFloat16(discriminator_->parameters());
}

void GestureTrainer::save(torch::serialize::OutputArchive& archive) const {
    const auto write = [&archive](const char* name, const auto& from) {
        torch::serialize::OutputArchive part;
        from.save(part);
        archive.write(name, part);
    };
    write("model", *model_);
    write("discriminator", *discriminator_);
    write("autoencoder", *autoencoder_);
    write("optimiser", *optimiser_);
    write("discriminator_optimiser", *discriminator_optimiser_);
}

void GestureTrainer::load(torch::serialize::InputArchive& archive) {
    const auto read = [&archive](const char* name, auto& to) {
        torch::serialize::InputArchive part;
        archive.read(name, part);
        to.load(part);
    };
    read("model", *model_);
    read("discriminator", *discriminator_);
    read("autoencoder", *autoencoder_);
    read("optimiser", *optimiser_);
    read("discriminator_optimiser", *discriminator_optimiser_);
}

}  // namespace deixis::learning
