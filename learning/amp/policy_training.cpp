#include "policy_training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <glm/common.hpp>
#include <sstream>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "learning/networks/tensors.hpp"
#include "task_reward.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using motion::Demonstration;
using motion::NamedArray;
using motion::NetworkWeights;
using motion::WeightsPrecision;

constexpr int report_every = 10;

template <typename One>
std::vector<One> inCluster(const std::vector<One>& all, const std::vector<int>& clusters, int cluster) {
    std::vector<One> out;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (clusters[i] == cluster) out.push_back(all[i]);
    return out;
}

/// Drawn from the box around the demonstrations' targets, where the nearest that the model knows is the
/// cluster's.
std::vector<Vec3> drawnTargets_m(const std::vector<Demonstration>& demonstrations,
                                 const physics::AmpModel& model, int cluster, int count, std::uint64_t seed) {
    Vec3 low = demonstrations.front().target, high = low;
    for (const Demonstration& one : demonstrations) {
        low = glm::min(low, one.target);
        high = glm::max(high, one.target);
    }
    Random random(seed, "validation targets");
    std::vector<Vec3> out;
    // A small cluster's share of the box may be small, too.
    for (int tries = 0; tries < 10'000 && static_cast<int>(out.size()) < count; ++tries) {
        Vec3 target_m;
        for (int axis = 0; axis < 3; ++axis) target_m[axis] = random.uniform(low[axis], high[axis]);
        if (physics::nearestTarget(model.targets, target_m).cluster == cluster) out.push_back(target_m);
    }
    return out;
}

/// The model of the one cluster alone, its policy numbered 0.
NetworkWeights alone(const physics::AmpModel& whole, int cluster, const std::vector<NamedArray>& policy) {
    physics::AmpModel model = whole;
    model.clusters = 1;
    std::erase_if(model.targets, [&](const auto& one) { return one.cluster != cluster; });
    for (auto& one : model.targets) one.cluster = 0;
    NetworkWeights out;
    physics::writeModel(model, out);
    out.arrays.insert(out.arrays.end(), policy.begin(), policy.end());
    return out;
}

}  // namespace

PolicyTraining::PolicyTraining(const AmpCommon& common, int cluster)
    : common_(common),
      cluster_(cluster),
      seed_(deriveSeed(common.training.settings.seed, fmt::format("cluster {}", cluster))),
      state_(common.folder / fmt::format("cluster-{}", cluster)),
      validation_(inCluster(common.data.validation, common.training.clusters.validation, cluster)),
      validation_targets_m_(drawnTargets_m(common.data.training, common.model, cluster,
                                           common.training.settings.validation_targets, seed_)),
      demonstrated_jerk_(
          meanJerk(inCluster(common.data.training, common.training.clusters.training, cluster))),
      references_(inCluster(common.references, common.training.clusters.training, cluster)) {
    for (const Demonstration& one : validation_) validation_targets_m_.push_back(one.target);
}

std::string PolicyTraining::identity() const {
    NetworkWeights all = alone(common_.model, cluster_, {});
    all.settings.merge(namedSettings(common_.training.settings));
    all.settings["cluster"] = static_cast<double>(cluster_);
    all.settings["ranks"] = static_cast<double>(common_.ranks.count());
    all.training_data_sha256 = common_.data.sha256;
    all.seed = common_.training.settings.seed;
    return sha256Hex(motion::encodeWeights(all, WeightsPrecision::float32));
}

Result<void> PolicyTraining::begin() {
    const AmpSettings& settings = common_.training.settings;
    trainer_.emplace(common_.body, common_.references, references_, settings, seed_, common_.ranks);
    const auto resumed = resume();
    if (!resumed) return tl::unexpected(resumed.error());
    if (!*resumed) {
        trainer_->clone();
        if (common_.ranks.rank() == 0) {
            ClipMeasures ignored;
            if (const auto tried = tryOutNow(ignored); !tried) return tl::unexpected(tried.error());
        }
    }
    trainer_->restart(iterations_);
    return {};
}

Result<bool> PolicyTraining::resume() {
    Result<std::string> bytes = std::string();
    if (common_.ranks.rank() == 0 && fs::exists(state_)) {
        bytes = readFile(state_);
        if (!bytes) return tl::unexpected(bytes.error());
    }
    const std::string first = common_.ranks.firstText(*bytes);
    if (first.empty()) return false;
    try {
        torch::serialize::InputArchive archive;
        std::istringstream in(first);
        archive.load_from(in);
        c10::IValue value;
        archive.read("identity", value);
        if (value.toStringRef() != identity())
            return fail(state_.string(), "this is of a training with other settings or demonstrations",
                        "Remove its folder to begin anew, or use the settings it was begun with");
        archive.read("iterations", value);
        iterations_ = static_cast<int>(value.toInt());
        archive.read("best_iteration", value);
        best_.iteration = static_cast<int>(value.toInt());
        archive.read("best_measures", value);
        const auto m = value.toDoubleVector();
        best_.measures = {
            m.at(0), rewardName(common_.training.settings.task), m.at(1), m.at(2), m.at(3), m.at(4), m.at(5)};
        archive.read("best_policy", value);
        const auto policy = motion::decodeWeights(value.toStringRef(), state_.string());
        if (!policy) return tl::unexpected(policy.error());
        best_.policy = policy->arrays;
        trainer_->load(archive);
    } catch (const std::exception&) {
        return fail(state_.string(), "this is no state of a training, or damaged",
                    "Remove its folder to begin anew");
    }
    return true;
}

Result<void> PolicyTraining::save() const {
    torch::serialize::OutputArchive archive;
    archive.write("identity", c10::IValue(identity()));
    archive.write("iterations", c10::IValue(iterations_));
    archive.write("best_iteration", c10::IValue(best_.iteration));
    const ClipMeasures& m = best_.measures;
    archive.write("best_measures",
                  c10::IValue(std::vector<double>{m.reward, m.error_rad, m.at_rest, m.end_height_m,
                                                  m.jerk_ratio, m.arm_error_m}));
    NetworkWeights policy;
    policy.architecture = "policy";
    policy.arrays = best_.policy;
    archive.write("best_policy", c10::IValue(motion::encodeWeights(policy, WeightsPrecision::float32)));
    trainer_->save(archive);
    return writeFile(state_, bytesOf(archive));
}

Result<ClipMeasures> PolicyTraining::tryOut(const std::vector<NamedArray>& policy) const {
    // With the numbers as a file holds them.
    const auto held = motion::decodeWeights(
        motion::encodeWeights(alone(common_.model, cluster_, policy), WeightsPrecision::float16),
        state_.string());
    if (!held) return tl::unexpected(held.error());
    const auto system = physics::makeAmp(*held, common_.avatar);
    if (!system) return tl::unexpected(system.error());
    const AmpTask task = common_.training.settings.task;
    PoseReward reward;
    if (task != AmpTask::forearm)
        reward = [task, balls = Random(seed_, "validation balls")](
                     const motion::Skeleton& skeleton, const motion::HumanoidMap& map,
                     const std::vector<Pose>& world, motion::Side hand, const Vec3& target_m) mutable {
            return taskReward(task, skeleton, map, world, hand, ballsAround(task, target_m, balls));
        };
    ClipMeasures out = measureAtTargets(**system, validation_targets_m_, demonstrated_jerk_, seed_, reward);
    out.reward_name = rewardName(task);
    if (!validation_.empty()) out.arm_error_m = measureGenerated(**system, validation_, seed_).arm_error_m;
    return out;
}

Result<bool> PolicyTraining::tryOutNow(ClipMeasures& measures) {
    std::vector<NamedArray> policy;
    trainer_->appendPolicy("policy0", policy);
    const auto tried = tryOut(policy);
    if (!tried) return tl::unexpected(tried.error());
    measures = *tried;
    // What only learned what the demonstrations do is no policy of this training, however well it points.
    const int frozen = common_.training.settings.frozen_iterations;
    const bool first = best_.policy.empty() || (best_.iteration <= frozen && iterations_ > frozen);
    const bool phase = common_.training.settings.variant.policy_phase;
    const bool best = first || tried->score(phase) > best_.measures.score(phase);
    if (best) best_ = {std::move(policy), *tried, iterations_};
    if (const auto saved = save(); !saved) return tl::unexpected(saved.error());
    return best;
}

Result<void> PolicyTraining::continueToTryOut(const std::function<bool(TrainingProgress&)>& report) {
    using Clock = std::chrono::steady_clock;
    const AmpSettings& settings = common_.training.settings;
    auto since = Clock::now();
    int reported = iterations_;
    for (int number = iterations_ + 1; number <= settings.iterations; ++number) {
        const AmpIteration made = trainer_->iterate(number);
        if (common_.ranks.any(!made.finite() || !trainer_->sound()))
            return fail(
                common_.folder.stem().string(),
                fmt::format("the training of cluster {} has diverged at iteration {}", cluster_, number),
                fmt::format("The policy of iteration {} is kept; a lower learning rate may help",
                            best_.iteration));
        const bool try_out = number % settings.validate_every == 0 || number == settings.iterations;
        if (!try_out && number % report_every != 0) continue;
        const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
        TrainingProgress progress{.update = number, .updates = settings.iterations};
        progress.numbers = {{"task reward", made.task_reward},
                            {"task reward missed", made.task_missed},
                            {"value error", made.value_error},
                            {"style reward", made.style_reward},
                            {"logit of agent", made.agent_logit},
                            {"logit of demonstrations", made.demonstration_logit},
                            {"samples a second", static_cast<double>(number - reported) *
                                                     settings.environments * settings.horizon / seconds}};
        if (try_out) {
            iterations_ = number;
            if (common_.ranks.rank() == 0) {
                const auto best = tryOutNow(progress.validation.emplace());
                if (!best) return tl::unexpected(best.error());
                progress.best = *best;
            }
            trainer_->restart(iterations_);
        }
        reported = number;
        since = Clock::now();
        if (common_.ranks.any(!report(progress)) || try_out) return {};
    }
    return {};
}

}  // namespace deixis::learning
