#include "motion/learned/moglow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/networks/taking.hpp"

namespace deixis::motion {

namespace {

Result<MoglowShape> shapeOf(const NetworkWeights& weights) {
    MoglowShape shape;
    Taking take;
    take(shape.steps, weights.count("steps", 1, 256));
    take(shape.hidden, weights.count("hidden", 1, 4096));
    take(shape.past_frames, weights.count("past_frames", 1, 1000));
    take(shape.look_ahead, weights.count("look_ahead", 0, 1000));
    take(shape.frame_time_s, weights.number("frame_time_s"));
    if (take.problem()) return tl::unexpected(*take.problem());
    if (!(shape.frame_time_s >= 0.001 && shape.frame_time_s <= 1.0))
        return fail(weights.file + ": settings.frame_time_s",
                    fmt::format("found {}, expected 0.001 to 1 s", shape.frame_time_s));
    return shape;
}

Result<double> seconds(const NetworkWeights& weights, const std::string& key) {
    const auto value = weights.number(key);
    if (value && !(*value > 0.0 && *value <= 60.0))
        return fail(weights.file + ": settings." + key,
                    fmt::format("found {}, expected more than 0 and at most 60 s", *value));
    return value;
}

}  // namespace

std::vector<float> moglowCondition(const ControlledFrames& frames, std::size_t at,
                                   std::span<const double> at_ease, const MoglowShape& shape) {
    std::vector<float> out;
    out.reserve(static_cast<std::size_t>(shape.conditionSize(static_cast<int>(at_ease.size()))));
    const auto past = static_cast<std::ptrdiff_t>(shape.past_frames);
    const auto now = static_cast<std::ptrdiff_t>(at);
    for (std::ptrdiff_t i = now - past; i < now; ++i)
        for (std::size_t d = 0; d < at_ease.size(); ++d)
            out.push_back(
                static_cast<float>(i < 0 ? at_ease[d] : frames.features[static_cast<std::size_t>(i)][d]));
    for (int axis = 0; axis < 3; ++axis) out.push_back(static_cast<float>(frames.target[axis]));
    for (std::ptrdiff_t i = now - past; i <= now + shape.look_ahead; ++i) {
        const bool on = i >= 0 && i < static_cast<std::ptrdiff_t>(frames.pointing.size()) &&
                        frames.pointing[static_cast<std::size_t>(i)];
        out.push_back(on ? 1.0F : 0.0F);
    }
    return out;
}

Result<Moglow> Moglow::of(const NetworkWeights& weights, const PoseFeatures& features) {
    if (weights.architecture != moglow_architecture)
        return fail(weights.file, fmt::format("these are weights of '{}', expected '{}'",
                                              weights.architecture, moglow_architecture));
    const auto shape = shapeOf(weights);
    if (!shape) return tl::unexpected(shape.error());
    if (const auto same = weights.checkFeatures(features.names()); !same) return tl::unexpected(same.error());
    const int size = static_cast<int>(features.size());
    Moglow out;
    out.shape_ = *shape;
    Taking take;
    take(out.raise_s_, seconds(weights, "raise_s"));
    take(out.hold_s_, seconds(weights, "hold_s"));
    take(out.temperature_, weights.number("temperature"));
    take(out.mean_, readVector(weights, "feature_mean", size));
    take(out.sd_, readVector(weights, "feature_sd", size));
    take(out.encoder_, Linear::read(weights, "encoder", shape->conditionSize(size), shape->hidden));
    take(out.flow_, ConditionalFlow::read(weights, {size, shape->hidden, shape->steps, shape->hidden}));
    if (take.problem()) return tl::unexpected(*take.problem());
    if (!(out.sd_.array() > 0.0F).all())
        return fail(weights.file + ": feature_sd", "found a standard deviation of 0 or less");
    out.at_ease_ = out.standardised(std::vector<double>(features.size(), 0.0));
    return out;
}

std::vector<double> Moglow::standardised(std::span<const double> features) const {
    std::vector<double> out;
    for (std::size_t d = 0; d < features.size(); ++d) {
        const auto i = static_cast<Eigen::Index>(d);
        out.push_back((features[d] - static_cast<double>(mean_[i])) / static_cast<double>(sd_[i]));
    }
    return out;
}

VectorXf Moglow::condition(const ControlledFrames& frames, std::size_t at) const {
    const std::vector<float> numbers = moglowCondition(frames, at, at_ease_, shape_);
    return encoder_.forward(
        Eigen::Map<const VectorXf>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
}

std::vector<std::vector<double>> Moglow::draw(const Vec3& target, std::vector<bool> pointing,
                                              Random& random) const {
    ControlledFrames frames{target, std::move(pointing), {}};
    ConditionalFlow::State state = flow_.zeroState();
    std::vector<std::vector<double>> out;
    for (std::size_t at = 0; at < frames.pointing.size(); ++at) {
        VectorXf latent(flow_.shape().size);
        for (float& value : latent) value = static_cast<float>(random.normal(0.0, temperature_));
        const VectorXf x = flow_.inverse(std::move(latent), condition(frames, at), state);
        frames.features.emplace_back(x.begin(), x.end());
        std::vector<double> plain;
        for (Eigen::Index d = 0; d < x.size(); ++d)
            plain.push_back(static_cast<double>(mean_[d]) +
                            static_cast<double>(sd_[d]) * static_cast<double>(x[d]));
        out.push_back(std::move(plain));
    }
    return out;
}

std::vector<double> Moglow::logLikelihoods(const ControlledFrames& frames) const {
    ConditionalFlow::State state = flow_.zeroState();
    std::vector<double> out;
    const double log_root = 0.5 * std::log(2.0 * pi) * flow_.shape().size;
    for (std::size_t at = 0; at < frames.features.size(); ++at) {
        const std::vector<float> x(frames.features[at].begin(), frames.features[at].end());
        float log_determinant = 0.0F;
        const VectorXf z =
            flow_.forward(Eigen::Map<const VectorXf>(x.data(), static_cast<Eigen::Index>(x.size())),
                          condition(frames, at), state, log_determinant);
        out.push_back(static_cast<double>(log_determinant) - 0.5 * static_cast<double>(z.squaredNorm()) -
                      log_root);
    }
    return out;
}

}  // namespace deixis::motion
