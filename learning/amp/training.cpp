#include "learning/amp/training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "hindsight_targets.hpp"
#include "learning/networks/optimising.hpp"
#include "motion/skeleton/gesture_phases.hpp"
#include "physics/figure/figure.hpp"
#include "policy_training.hpp"
#include "task_reward.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::Demonstration;
using motion::NetworkWeights;

physics::AmpModel modelOf(const std::vector<Demonstration>& demonstrations, const AmpTraining& training,
                          const motion::PoseFeatures& features, const physics::BaseMotion& base) {
    physics::AmpModel out{.system = training.system,
                          .stance = training.settings.stance,
                          .with_phase = training.settings.variant.policy_phase,
                          .clusters = training.clusters.count,
                          .hidden = training.settings.hidden,
                          .base = base.coefficients(),
                          .features = features.names()};
    for (std::size_t i = 0; i < demonstrations.size(); ++i) {
        const Demonstration& one = demonstrations[i];
        const motion::Clip& clip = one.gesture.clip;
        out.targets.push_back({one.target, one.gesture.hand,
                               motion::durationsOf(one.gesture, clip.frameCount(), clip.frame_time_s),
                               training.clusters.training[i]});
    }
    return out;
}

/// The arrays of a policy under another number.
void appendAs(int number, const std::vector<motion::NamedArray>& policy,
              std::vector<motion::NamedArray>& out) {
    for (motion::NamedArray array : policy) {
        array.name = fmt::format("policy{}{}", number, array.name.substr(array.name.find('.')));
        out.push_back(std::move(array));
    }
}

class Training {
  public:
    Training(const AmpCommon& common, const Provenance& provenance, fs::path file,
             const TrainingReport& report)
        : common_(common), provenance_(provenance), file_(std::move(file)), report_(report) {
        for (int cluster = 0; cluster < common.training.clusters.count; ++cluster)
            if (common.training.only_cluster.value_or(cluster) == cluster)
                policies_.emplace_back(common, cluster);
    }

    Result<TrainingOutcome> run() {
        // Together they could be long in coming, so each learns the demonstrations before one tries anything.
        if (const auto begun = forEach([this](PolicyTraining& one) { return begin(one); }); !begun)
            return tl::unexpected(begun.error());
        if (const auto written = write(); !written) return tl::unexpected(written.error());
        if (!stopped_)
            if (const auto trained = forEach([this](PolicyTraining& one) { return train(one); }); !trained)
                return tl::unexpected(trained.error());
        if (!stopped_ && common_.ranks.rank() == 0) {
            std::error_code ignored;
            fs::remove_all(common_.folder, ignored);
        }
        return outcome();
    }

  private:
    /// In several threads; the first problem.
    Result<void> forEach(const std::function<Result<void>(PolicyTraining&)>& work) {
        std::atomic<std::size_t> next = 0;
        std::mutex mutex;
        Result<void> problem;
        const auto some = [&] {
            for (std::size_t at = next++; at < policies_.size(); at = next++) {
                auto done = work(policies_[at]);
                const std::lock_guard lock(mutex);
                if (done || !problem) continue;
                problem = std::move(done);
                next = policies_.size();
            }
        };
        // Ranks make their calls in the same order.
        const int threads = common_.ranks.count() > 1 ? 1 : common_.training.threads;
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(some);
        some();
        others.clear();
        return problem;
    }

    /// The same in every rank, since what stops is agreed upon.
    bool tell(const PolicyTraining& policy, TrainingProgress& progress) {
        const std::lock_guard lock(mutex_);
        if (policies_.size() > 1)
            progress.part =
                fmt::format("cluster {} of {}", policy.cluster(), common_.training.clusters.count);
        progress.updates = common_.training.settings.iterations;
        reported_[policy.cluster()] = progress.update;
        int sum = 0;
        for (const auto& [cluster, iterations] : reported_) sum += iterations;
        progress.done = static_cast<double>(sum) /
                        (static_cast<double>(policies_.size()) * common_.training.settings.iterations);
        if (!report_(progress)) stopped_ = true;
        return !stopped_;
    }

    void keep(const PolicyTraining& policy) {
        const std::lock_guard lock(mutex_);
        kept_[policy.cluster()] = policy.best();
        iterations_[policy.cluster()] = policy.iterations();
    }

    Result<void> begin(PolicyTraining& policy) {
        if (const auto begun = policy.begin(); !begun) return begun;
        keep(policy);
        TrainingProgress progress{.update = policy.iterations()};
        progress.best = policy.iterations() == 0;
        if (progress.best) progress.validation = policy.best().measures;
        (void)tell(policy, progress);
        return {};
    }

    Result<void> train(PolicyTraining& policy) {
        while (!policy.done() && !stopped_) {
            bool better = false;
            const auto made = policy.continueToTryOut([&](TrainingProgress& progress) {
                better = better || progress.best;
                return tell(policy, progress);
            });
            if (!made) return made;
            keep(policy);
            if (better)
                if (const auto written = write(); !written) return written;
        }
        return {};
    }

    /// All policies as they are best yet.
    Result<void> write() {
        if (common_.ranks.rank() != 0) return {};
        const std::lock_guard lock(mutex_);
        NetworkWeights weights;
        physics::writeModel(common_.model, weights);
        weights.settings.merge(namedSettings(common_.training.settings));
        weights.settings["bandwidth_m"] = common_.training.clusters.bandwidth_m;
        if (common_.training.only_cluster)
            weights.settings["only_cluster"] = static_cast<double>(*common_.training.only_cluster);
        for (const auto& [cluster, best] : kept_) appendAs(cluster, best.policy, weights.arrays);
        const TrainingOutcome now = outcome();
        weights.metrics = {{"iterations", static_cast<double>(common_.training.settings.iterations)},
                           {"best_iteration", static_cast<double>(now.best_update)},
                           {"validation_reward", now.best.reward},
                           {"validation_error_rad", now.best.error_rad},
                           {"validation_at_rest", now.best.at_rest},
                           {"validation_end_height_m", now.best.end_height_m},
                           {"validation_jerk_ratio", now.best.jerk_ratio},
                           {"validation_arm_error_m", now.best.arm_error_m}};
        setProvenance(weights, common_.data, common_.training.settings.seed, provenance_);
        return motion::writeWeights(file_, weights, motion::WeightsPrecision::float16);
    }

    [[nodiscard]] TrainingOutcome outcome() const {
        TrainingOutcome out;
        out.stopped = stopped_;
        out.best.reward_name = rewardName(common_.training.settings.task);
        const double n = static_cast<double>(kept_.size());
        double with_demonstrations = 0.0;
        for (const auto& [cluster, iterations] : iterations_) out.updates += iterations;
        for (const auto& [cluster, best] : kept_) {
            const ClipMeasures& measures = best.measures;
            out.best_update = best.iteration;
            out.best.reward += measures.reward / n;
            out.best.error_rad += measures.error_rad / n;
            out.best.at_rest += measures.at_rest / n;
            out.best.end_height_m += measures.end_height_m / n;
            out.best.jerk_ratio += measures.jerk_ratio / n;
            out.best.arm_error_m += measures.arm_error_m;
            with_demonstrations += measures.arm_error_m > 0.0 ? 1.0 : 0.0;
        }
        out.best.arm_error_m /= std::max(1.0, with_demonstrations);
        return out;
    }

    const AmpCommon& common_;
    const Provenance& provenance_;
    fs::path file_;
    const TrainingReport& report_;
    std::deque<PolicyTraining> policies_;
    std::mutex mutex_;
    // Of each cluster:
    std::map<int, int> reported_{};    ///< iterations
    std::map<int, int> iterations_{};  ///< at the last try-out
    std::map<int, PolicyTraining::Best> kept_{};
    std::atomic<bool> stopped_ = false;
};

}  // namespace

Result<TrainingOutcome> trainAmp(const DemonstrationSets& data, const AmpTraining& training,
                                 const Provenance& provenance, const fs::path& file,
                                 const TrainingReport& report) {
    if (data.training.empty())
        return fail(file.string(), "found no demonstrations to train on, expected at least one");
    const motion::Skeleton& avatar = data.training.front().gesture.clip.skeleton;
    const auto features = motion::PoseFeatures::of(avatar);
    if (!features) return tl::unexpected(features.error());
    const auto figure = physics::makeFigure(avatar, training.settings.stance);
    if (!figure) return tl::unexpected(figure.error());
    const auto body = physics::Body::make(*figure);
    if (!body) return tl::unexpected(body.error());
    const auto ranks = Ranks::join(training.rank);
    if (!ranks) return tl::unexpected(ranks.error());
    setUpTorch(1);
    const auto base = physics::BaseMotion::meanOf(*features, data.training);
    const auto demonstrations = training.settings.hindsight_targets
                                    ? withHindsightTargets(data.training, training.settings.task)
                                    : data.training;
    auto references = makeReferences(*body, base, demonstrations, training.settings);
    if (!references) return tl::unexpected(references.error());
    const AmpCommon common{data,
                           training,
                           *body,
                           base,
                           avatar,
                           modelOf(demonstrations, training, *features, base),
                           std::move(*references),
                           **ranks,
                           fs::path(file.string() + ".training")};
    if (common.ranks.rank() == 0) {
        std::error_code problem;
        fs::create_directories(common.folder, problem);
        if (problem) return fail(common.folder.string(), problem.message());
    }
    return Training(common, provenance, file, report).run();
}

}  // namespace deixis::learning
