#include "motion/learned/flow_matching.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/networks/taking.hpp"

namespace deixis::motion {

namespace {

constexpr int most_observations = 100'000;

Result<GaussianProcess> processOf(const NetworkWeights& weights, std::size_t trajectory_size) {
    int count = 0;
    Kernel kernel;
    Taking take;
    take(count, weights.count("demonstrations", 2, most_observations));
    take(kernel.length, weights.number("kernel_length"));
    take(kernel.noise, weights.number("kernel_noise"));
    if (take.problem()) return tl::unexpected(*take.problem());
    if (!(kernel.length > 0.0) || !(kernel.noise > 0.0))
        return fail(weights.file + ": settings.kernel_length", "found a kernel of no length or no noise");
    const auto n = static_cast<std::size_t>(count);
    const auto rows = [&](const char* name, std::size_t columns) -> Result<std::vector<std::vector<double>>> {
        const auto array = weights.array(name, {n, columns});
        if (!array) return tl::unexpected(array.error());
        std::vector<std::vector<double>> out;
        for (std::size_t i = 0; i < n; ++i) {
            const auto begin = (*array)->values.begin() + static_cast<std::ptrdiff_t>(i * columns);
            out.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(columns));
        }
        return out;
    };
    const auto seen = rows("seen", 3);
    if (!seen) return tl::unexpected(seen.error());
    const auto trajectories = rows("courses", trajectory_size);
    if (!trajectories) return tl::unexpected(trajectories.error());
    return GaussianProcess(*seen, *trajectories, kernel);
}

VectorXf rectified(const VectorXf& x) {
    return x.cwiseMax(0.0F);
}

class FlowSystem : public Generator {
  public:
    explicit FlowSystem(FlowMatching model) : model_(std::move(model)) {}

    std::string_view name() const override { return flow_architecture; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        Random random(asked.seed, "flow");
        return model_.trajectories().perform(
            asked, name(), [&](const Vec3& target_m) { return model_.draw(target_m, random, true); });
    }

  private:
    FlowMatching model_;
};

}  // namespace

Result<FlowMatching> FlowMatching::of(const NetworkWeights& weights, GestureTrajectories trajectories) {
    if (weights.architecture != flow_architecture)
        return fail(weights.file, fmt::format("these are weights of '{}', expected '{}'",
                                              weights.architecture, flow_architecture));
    if (const auto same = weights.checkFeatures(trajectories.features().names()); !same)
        return tl::unexpected(same.error());
    FlowMatching out(std::move(trajectories));
    FlowMatchingShape& shape = out.shape_;
    Taking take;
    take(shape.directions, weights.count("directions", 1, 1000));
    take(shape.hidden, weights.count("hidden", 1, 4096));
    take(shape.steps, weights.count("steps", 1, 1000));
    take(shape.noise, weights.number("noise"));
    if (take.problem()) return tl::unexpected(*take.problem());
    const auto size = static_cast<int>(out.trajectories_.size());
    auto process = processOf(weights, out.trajectories_.size());
    if (!process) return tl::unexpected(process.error());
    out.process_ = std::move(*process);
    take(out.directions_, readMatrix(weights, "directions", size, shape.directions));
    take(out.first_, Linear::read(weights, "network.layer0", shape.inputs(), shape.hidden));
    take(out.second_, Linear::read(weights, "network.layer1", shape.hidden, shape.hidden));
    take(out.last_, Linear::read(weights, "network.layer2", shape.hidden, shape.directions));
    if (take.problem()) return tl::unexpected(*take.problem());
    return out;
}

std::vector<double> FlowMatching::middle(const Vec3& target_m) const {
    return process_->predict(asNearAs(*process_, trajectories_.seen(target_m)));
}

VectorXf FlowMatching::predicted(const VectorXf& weights, double time, const VectorXf& seen) const {
    VectorXf input(shape_.inputs());
    input << weights, static_cast<float>(time), seen;
    return last_.forward(rectified(second_.forward(rectified(first_.forward(input)))));
}

std::vector<double> FlowMatching::trajectoryOf(const std::vector<double>& middle,
                                               const VectorXf& weights) const {
    const VectorXf added = directions_ * weights;
    std::vector<double> out = middle;
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] += static_cast<double>(added[static_cast<Eigen::Index>(i)]);
    return out;
}

VectorXf FlowMatching::aimed(VectorXf weights, const std::vector<double>& middle,
                             const Vec3& target_m) const {
    constexpr int most_steps = 4;
    constexpr double near_rad = radiansFromDegrees(0.1);
    constexpr float apart = 0.05F;
    constexpr float farthest = 4.0F;  // in spreads: beyond is no gesture that somebody makes
    using Missed = Eigen::Vector2d;
    const auto missedBy = [&](const VectorXf& at) -> Missed {
        const auto missed = trajectories_.missed_rad(trajectoryOf(middle, at), target_m);
        return {missed[0], missed[1]};
    };
    Missed missed = missedBy(weights);
    for (int step = 0; step < most_steps && missed.norm() > near_rad; ++step) {
        Eigen::Matrix<double, 2, Eigen::Dynamic> slope(2, weights.size());
        for (Eigen::Index i = 0; i < weights.size(); ++i) {
            VectorXf beside = weights;
            beside[i] += apart;
            slope.col(i) = (missedBy(beside) - missed) / static_cast<double>(apart);
        }
        // The least change of weights that have spread 1 each.
        const Eigen::Matrix2d square = slope * slope.transpose() + 1e-9 * Eigen::Matrix2d::Identity();
        const VectorXf change = (-slope.transpose() * square.ldlt().solve(missed)).cast<float>();
        bool nearer = false;
        for (float share = 1.0F; share > 0.05F && !nearer; share *= 0.5F) {
            const VectorXf there = (weights + share * change).cwiseMax(-farthest).cwiseMin(farthest);
            const Missed then = missedBy(there);
            nearer = then.norm() < missed.norm();
            if (!nearer) continue;
            weights = there;
            missed = then;
        }
        if (!nearer) break;
    }
    return weights;
}

std::vector<double> FlowMatching::draw(const Vec3& target_m, Random& random, bool guided) const {
    const std::vector<double> seen = asNearAs(*process_, trajectories_.seen(target_m));
    const VectorXf condition = Eigen::VectorXd::Map(seen.data(), 3).cast<float>();
    const std::vector<double> at = process_->predict(seen);
    VectorXf weights(shape_.directions);
    for (float& weight : weights) weight = static_cast<float>(random.normal(0.0, shape_.noise));
    for (int step = 0; step < shape_.steps; ++step) {
        const double time = static_cast<double>(step) / shape_.steps;
        VectorXf end = predicted(weights, time, condition);
        if (guided && 2 * step >= shape_.steps) end = aimed(std::move(end), at, target_m);
        // The last step goes all the way.
        const auto share = static_cast<float>(1.0 / (shape_.steps - step));
        weights += share * (end - weights);
    }
    return trajectoryOf(at, weights);
}

Result<std::unique_ptr<Generator>> makeFlow(const NetworkWeights& weights, const Skeleton& avatar) {
    const auto eye_limit_rad = weights.number("eye_limit_rad");
    if (!eye_limit_rad) return tl::unexpected(eye_limit_rad.error());
    auto trajectories = GestureTrajectories::of(avatar, *eye_limit_rad);
    if (!trajectories) return tl::unexpected(trajectories.error());
    auto model = FlowMatching::of(weights, std::move(*trajectories));
    if (!model) return tl::unexpected(model.error());
    return std::make_unique<FlowSystem>(std::move(*model));
}

}  // namespace deixis::motion
