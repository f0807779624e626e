#include "learning/flow/training.hpp"

#include <fmt/format.h>
#include <torch/torch.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "learning/networks/mlp.hpp"
#include "learning/networks/optimising.hpp"
#include "learning/networks/tensors.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::Demonstration;
using motion::GestureTrajectories;
using motion::NamedArray;
using motion::NetworkWeights;
using motion::WeightsPrecision;
using torch::Tensor;

/// What is learned from: demonstrations, what they are regressed on, and what is left over.
struct Trajectories {
    std::vector<GestureTrajectories::Observation> observations;
    motion::Kernel kernel;
    Eigen::MatrixXd directions;  ///< a column each
    Eigen::MatrixXd weights;     ///< of the directions, a row for each demonstration: mean square about 1
};

NamedArray arrayFrom(const std::string& name, const Eigen::MatrixXd& matrix) {
    NamedArray out{
        name, {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())}, {}};
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
        for (Eigen::Index column = 0; column < matrix.cols(); ++column)
            out.values.push_back(static_cast<float>(matrix(row, column)));
    return out;
}

Eigen::MatrixXd matrixOf(const std::vector<std::vector<double>>& rows) {
    Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()),
                        static_cast<Eigen::Index>(rows.front().size()));
    for (Eigen::Index i = 0; i < out.rows(); ++i)
        out.row(i) = Eigen::VectorXd::Map(rows[static_cast<std::size_t>(i)].data(), out.cols());
    return out;
}

Trajectories trajectoriesOf(const GestureTrajectories& of, const std::vector<Demonstration>& demonstrations,
                            int directions) {
    Trajectories out;
    for (const Demonstration& one : demonstrations) out.observations.push_back(of.observe(one));
    const auto process = motion::trajectoryRegression(out.observations);
    out.kernel = process.kernel();
    const Eigen::BDCSVD<Eigen::MatrixXd> parts(process.leftOutErrors(),
                                               Eigen::ComputeThinU | Eigen::ComputeThinV);
    const auto count = std::min<Eigen::Index>(directions, parts.singularValues().size());
    const double root = std::sqrt(static_cast<double>(demonstrations.size()));
    out.directions =
        parts.matrixV().leftCols(count) * (parts.singularValues().head(count) / root).asDiagonal();
    out.weights = parts.matrixU().leftCols(count) * root;
    return out;
}

class FlowTrainer {
  public:
    FlowTrainer(const Trajectories& trajectories, const FlowSettings& settings)
        : settings_(settings),
          random_(settings.seed, "flow training"),
          seen_(rows(trajectories, [&](std::size_t i) { return trajectories.observations[i].seen; })),
          ends_(rows(trajectories, [&](std::size_t i) {
              const Eigen::VectorXd row = trajectories.weights.row(static_cast<Eigen::Index>(i));
              return std::vector<double>(row.begin(), row.end());
          })) {
        seedTorch(settings.seed, "flow networks");
        const auto directions = static_cast<int>(ends_.size(1));
        motion::FlowMatchingShape shape = settings.shape;
        shape.directions = directions;
        network_ = std::make_shared<Mlp>(shape.inputs(), std::vector<int>{shape.hidden, shape.hidden},
                                         directions, 1.0);
        optimiser_ = std::make_unique<torch::optim::Adam>(network_->parameters(),
                                                          torch::optim::AdamOptions(settings.learning_rate));
    }

    /// Its loss.
    double update(int number) {
        const double share = static_cast<double>(number) / settings_.updates;
        const double rate = settings_.learning_rate *
                            (0.01 + 0.99 * 0.5 * (1.0 + std::cos(std::numbers::pi * std::min(1.0, share))));
        setRate(*optimiser_, rate);
        const std::int64_t batch = settings_.batch;
        const Tensor chosen = drawnIndices(random_, ends_.size(0), batch);
        // Variance stays: a kernel estimate of their density (Silverman 1986, section 6.4).
        const Tensor end =
            std::sqrt(1.0 - settings_.smoothing * settings_.smoothing) * ends_.index_select(0, chosen) +
            settings_.smoothing * normals(batch, ends_.size(1));
        const Tensor begin = normals(end.size(0), end.size(1));
        const Tensor seen = seen_.index_select(0, chosen) + settings_.blur * normals(batch, seen_.size(1));
        std::vector<float> times(static_cast<std::size_t>(batch));
        for (float& time : times) time = static_cast<float>(random_.uniform());
        const Tensor time = torch::tensor(times).unsqueeze(1);
        const Tensor now = (1.0 - time) * begin + time * end;
        const Tensor loss = torch::mse_loss(network_->forward(torch::cat({now, time, seen}, 1)), end);
        optimiser_->zero_grad();
        loss.backward();
        optimiser_->step();
        return loss.item<double>();
    }

    [[nodiscard]] bool sound() const { return fitFloat16(network_->parameters()); }
    void append(std::vector<NamedArray>& out) const { network_->append("network", out); }

  private:
    template <typename Row>
    static Tensor rows(const Trajectories& trajectories, const Row& row) {
        std::vector<float> out;
        for (std::size_t i = 0; i < trajectories.observations.size(); ++i)
            for (const double value : row(i)) out.push_back(static_cast<float>(value));
        return torch::tensor(out).reshape({static_cast<std::int64_t>(trajectories.observations.size()), -1});
    }
    Tensor normals(std::int64_t count, std::int64_t columns) {
        std::vector<float> out(static_cast<std::size_t>(count * columns));
        for (float& value : out) value = static_cast<float>(random_.normal());
        return torch::tensor(out).reshape({count, columns});
    }

    const FlowSettings& settings_;
    Random random_;
    Tensor seen_, ends_;
    std::shared_ptr<Mlp> network_;
    std::unique_ptr<torch::optim::Adam> optimiser_;
};

NetworkWeights weightsOf(const Trajectories& trajectories, const GestureTrajectories& of,
                         const FlowSettings& settings, const FlowTrainer& trainer) {
    NetworkWeights out;
    out.architecture = motion::flow_architecture;
    out.settings = {{"features", of.features().names()},
                    {"eye_limit_rad", settings.eye_limit_rad},
                    {"demonstrations", static_cast<double>(trajectories.observations.size())},
                    {"kernel_length", trajectories.kernel.length},
                    {"kernel_noise", trajectories.kernel.noise},
                    {"directions", static_cast<double>(trajectories.directions.cols())},
                    {"hidden", static_cast<double>(settings.shape.hidden)},
                    {"steps", static_cast<double>(settings.shape.steps)},
                    {"updates", static_cast<double>(settings.updates)},
                    {"batch", static_cast<double>(settings.batch)},
                    {"learning_rate", settings.learning_rate},
                    {"blur", settings.blur},
                    {"smoothing", settings.smoothing}};
    std::vector<std::vector<double>> seen, trajectory;
    for (const auto& one : trajectories.observations) {
        seen.push_back(one.seen);
        trajectory.push_back(one.trajectory);
    }
    out.arrays = {arrayFrom("seen", matrixOf(seen)), arrayFrom("courses", matrixOf(trajectory)),
                  arrayFrom("directions", trajectories.directions)};
    trainer.append(out.arrays);
    return out;
}

/// Begins draws with so much noise that they spread as the demonstrations do; their spread then.
Result<Spread> setNoise(NetworkWeights& weights, const GestureTrajectories& trajectories,
                        const std::vector<Demonstration>& demonstrations, std::uint64_t seed) {
    constexpr int rounds = 2;
    Spread spread;
    double noise = 1.0;
    for (int round = 0; round <= rounds; ++round) {
        weights.settings["noise"] = noise;
        const auto model = motion::FlowMatching::of(weights, trajectories);
        if (!model) return tl::unexpected(model.error());
        spread = flowSpread(*model, demonstrations, seed);
        if (round < rounds) noise = std::clamp(noise * spread.demonstrated_m / spread.drawn_m, 0.25, 4.0);
    }
    return spread;
}

}  // namespace

Result<TrainingOutcome> trainFlow(const DemonstrationSets& data, const FlowSettings& settings,
                                  const Provenance& provenance, const fs::path& file,
                                  const TrainingReport& report) {
    constexpr std::size_t fewest = 8;
    const std::vector<Demonstration>& training = data.training;
    if (training.size() < fewest || data.validation.empty())
        return fail(
            file.string(),
            fmt::format("found {} demonstrations to train on and {} held out, expected at least {} and one",
                        training.size(), data.validation.size(), fewest));
    const motion::Skeleton& avatar = training.front().gesture.clip.skeleton;
    const auto of = GestureTrajectories::of(avatar, settings.eye_limit_rad);
    if (!of) return tl::unexpected(of.error());
    setUpTorch(1);
    const Trajectories trajectories = trajectoriesOf(*of, training, settings.shape.directions);
    FlowTrainer trainer(trajectories, settings);
    TrainingOutcome out;
    double sum = 0.0;
    int summed = 0;
    constexpr int report_every = 500;
    for (int number = 1; number <= settings.updates && !out.stopped; ++number) {
        sum += trainer.update(number);
        ++summed;
        out.updates = number;
        const bool last = number == settings.updates;
        const bool try_out = last || number % settings.validate_every == 0;
        if (!try_out && number % report_every != 0) continue;
        if (!std::isfinite(sum) || !trainer.sound())
            return fail(file.string(), fmt::format("the training has diverged at update {}", number),
                        "A lower learning rate may help");
        TrainingProgress progress{.update = number, .updates = settings.updates};
        progress.done = static_cast<double>(number) / settings.updates;
        progress.numbers = {{"squared error", sum / summed}};
        sum = 0.0;
        summed = 0;
        if (try_out) {
            NetworkWeights weights = weightsOf(trajectories, *of, settings, trainer);
            setProvenance(weights, data, settings.seed, provenance);
            const auto spread = setNoise(weights, *of, training, settings.seed);
            if (!spread) return tl::unexpected(spread.error());
            const auto system = motion::makeFlow(weights, avatar);
            if (!system) return tl::unexpected(system.error());
            const ClipMeasures tried = measureGenerated(**system, data.validation, settings.seed);
            progress.validation = tried;
            progress.best = true;  // the rate falls: the last is the best
            out.best = tried;
            out.best_update = number;
            progress.numbers.emplace_back("spread of demonstrations in cm", 100.0 * spread->demonstrated_m);
            progress.numbers.emplace_back("spread drawn in cm", 100.0 * spread->drawn_m);
            weights.metrics = {{"spread_demonstrated_m", spread->demonstrated_m},
                               {"spread_drawn_m", spread->drawn_m},
                               {"spread_unguided_m", spread->unguided_m},
                               {"updates", double(number)},
                               {"validation_reward", tried.reward},
                               {"validation_at_rest", tried.at_rest},
                               {"validation_jerk_ratio", tried.jerk_ratio},
                               {"validation_arm_error_m", tried.arm_error_m}};
            const auto written = motion::writeWeights(file, weights, WeightsPrecision::float32);
            if (!written) return tl::unexpected(written.error());
        }
        out.stopped = !report(progress) && !last;
    }
    return out;
}

}  // namespace deixis::learning
