#include "trainer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "learning/networks/optimising.hpp"
#include "learning/networks/tensors.hpp"
#include "physics/policy/policy.hpp"

namespace deixis::learning {

namespace {

using torch::Tensor;

constexpr double min_sd = 0.05;
constexpr double least_change_sd = 0.003;
constexpr double largest_style = 9.21;  ///< -ln 1e-4
constexpr double max_gradient_norm = 1.0;

Tensor tensorOf(std::vector<float> values, std::int64_t columns) {
    return torch::tensor(values).reshape({-1, columns});
}

/// Of several trainings one at a time, until the lock is gone.
std::unique_lock<std::mutex> seeded(std::uint64_t seed) {
    static std::mutex mutex;
    std::unique_lock lock(mutex);
    seedTorch(seed, "networks");
    return lock;
}

std::unique_ptr<torch::optim::Adam> adam(const std::vector<Tensor>& parameters, double rate, double decay) {
    return std::make_unique<torch::optim::Adam>(parameters,
                                                torch::optim::AdamOptions(rate).weight_decay(decay));
}

/// With mean 0 and standard deviation 1.
Tensor evenly(const Tensor& x) {
    return (x - x.mean()) / x.std().clamp_min(1e-6);
}

}  // namespace

bool AmpIteration::finite() const {
    return std::isfinite(task_reward + style_reward + agent_logit + demonstration_logit + value_error);
}

AmpTrainer::AmpTrainer(const physics::Body& body, const std::vector<ReferenceMotion>& all,
                       const std::vector<ReferenceMotion>& references, const AmpSettings& settings,
                       std::uint64_t seed, Ranks& ranks)
    : settings_(settings),
      ranks_(ranks),
      seed_(seed),
      environments_(body, references, settings_, seed),
      random_(seed, "cloning"),
      state_size_(static_cast<std::int64_t>(environments_.stateSize())),
      actions_(static_cast<std::int64_t>(body.figure().hinges.size())) {
    const auto seen_size = static_cast<std::int64_t>(environments_.seenSize());
    setCloned(body, all);
    const auto before = static_cast<std::int64_t>(settings.discriminator_window - 1);
    std::vector<float> past, after, phases;
    for (const ReferenceMotion& one : references)
        for (const auto& states : one.seen)
            for (std::size_t i = 0; i < one.controls(); ++i) {
                for (auto back = static_cast<std::size_t>(before); back-- > 0;) {
                    const auto& state = states[i - std::min(i, back)];
                    past.insert(past.end(), state.begin(), state.end());
                }
                after.insert(after.end(), states[i + 1].begin(), states[i + 1].end());
                phases.push_back(static_cast<float>(one.phase(i)));
            }
    const Tensor shown_past = tensorOf(std::move(past), before * state_size_);
    const Tensor shown_after = tensorOf(std::move(after), state_size_);
    change_sd_ = (shown_after - shown_past.narrow(1, (before - 1) * state_size_, state_size_))
                     .std(0)
                     .clamp_min(least_change_sd);
    demonstrated_windows_ = windows(shown_past, shown_after);
    demonstrated_phases_ = torch::tensor(phases);
    remembered_windows_ = torch::zeros({settings.remembered, (before + 1) * state_size_});
    remembered_phases_ = torch::zeros({settings.remembered});

    const int inputs = static_cast<int>(seen_size);
    {
        const auto lock = seeded(seed);
        actor_ = std::make_shared<Mlp>(inputs, settings.hidden, static_cast<int>(actions_), 0.1);
        averaged_ = std::make_shared<Mlp>(inputs, settings.hidden, static_cast<int>(actions_), 0.1);
        for (int i = 0; i < (settings.separate_critics ? 2 : 1); ++i)
            critics_.push_back(std::make_shared<Mlp>(inputs, settings.hidden, 1, 0.1));
        discriminator_ = std::make_shared<Discriminator>(static_cast<int>((before + 1) * state_size_),
                                                         settings.hidden, settings.variant.phase_functioned);
    }
    actor_optimiser_ = adam(actor_->parameters(), settings.actor_rate, 0.0);
    std::vector<Tensor> critics;
    for (const auto& critic : critics_)
        for (const Tensor& one : critic->parameters()) critics.push_back(one);
    critic_optimiser_ = adam(critics, settings.critic_rate, 0.0);
    discriminator_optimiser_ =
        adam(discriminator_->parameters(), settings.discriminator_rate, settings.weight_decay);
    ranks.takeFirst(actor_->parameters());
    ranks.takeFirst(critics);
    ranks.takeFirst(discriminator_->parameters());
}

void AmpTrainer::setCloned(const physics::Body& body, const std::vector<ReferenceMotion>& all) {
    const bool phase = settings_.variant.policy_phase;
    const physics::BodyObserver observer(body.figure());
    std::vector<float> seen, action;
    for (const ReferenceMotion& one : all)
        for (const auto& states : one.seen)
            for (std::size_t i = 0; i < one.controls(); ++i) {
                if (!phase && (!one.restIsOver(i) || one.holdIsOver(i))) continue;
                std::vector<float> goal(physics::BodyObserver::goalSize(phase));
                physics::PolicyGoal asked{one.target_m, one.hand, {}};
                if (phase) asked.phase = one.phase(i);
                observer.writeGoal(one.states[i].root, states[i], asked, goal);
                seen.insert(seen.end(), states[i].begin(), states[i].end());
                seen.insert(seen.end(), goal.begin(), goal.end());
                for (const double target : one.targets_rad[i]) action.push_back(static_cast<float>(target));
            }
    clone_seen_ = tensorOf(std::move(seen), static_cast<std::int64_t>(environments_.seenSize()));
    clone_action_ = tensorOf(std::move(action), actions_);
    seen_mean_ = clone_seen_.mean(0);
    seen_sd_ = clone_seen_.std(0).clamp_min(min_sd);
    action_mean_ = clone_action_.mean(0);
    action_sd_ = clone_action_.std(0).clamp_min(min_sd);
}

void AmpTrainer::average(double share) {
    torch::NoGradGuard no_gradient;
    const auto now = actor_->parameters();
    auto averaged = averaged_->parameters();
    for (std::size_t i = 0; i < now.size(); ++i) averaged[i].lerp_(now[i], share);
}

void AmpTrainer::restart(int iterations) {
    // Of its own in each rank.
    const std::uint64_t seed =
        deriveSeed(seed_, fmt::format("from iteration {} rank {}", iterations, ranks_.rank()));
    environments_.restart(seed);
    random_ = Random(seed, "trainer");
    remembered_ = 0;
}

void AmpTrainer::update(torch::optim::Adam& optimiser, const std::vector<Tensor>& parameters,
                        const Tensor& loss) {
    optimiser.zero_grad();
    loss.backward({}, {}, false, parameters);
    ranks_.averageGradients(parameters);
    torch::nn::utils::clip_grad_norm_(parameters, max_gradient_norm);
    optimiser.step();
}

Tensor AmpTrainer::standardised(const Tensor& seen) const {
    return ((seen - seen_mean_) / seen_sd_).clamp(-physics::largest_input, physics::largest_input);
}

Tensor AmpTrainer::windows(const Tensor& past, const Tensor& after) const {
    const Tensor mean = seen_mean_.narrow(0, 0, state_size_), sd = seen_sd_.narrow(0, 0, state_size_);
    const Tensor all = torch::cat({past, after}, 1);
    const std::int64_t changes = all.size(1) - state_size_;
    const Tensor change = (all.narrow(1, state_size_, changes) - all.narrow(1, 0, changes)) /
                          change_sd_.repeat({changes / state_size_});
    return torch::cat({(all.narrow(1, 0, state_size_) - mean) / sd, change}, 1)
        .clamp(-physics::largest_input, physics::largest_input);
}

Tensor AmpTrainer::actionOf(const Tensor& seen) {
    return action_mean_ + action_sd_ * actor_->forward(standardised(seen));
}

Tensor AmpTrainer::valueOf(Mlp& critic, const Tensor& seen) {
    return critic.forward(standardised(seen)).squeeze(1) * valueScale();
}

Tensor AmpTrainer::permutation(std::int64_t count) {
    std::vector<std::int64_t> out(static_cast<std::size_t>(count));
    std::iota(out.begin(), out.end(), 0);
    random_.shuffle(std::span(out));
    return torch::tensor(out);
}

double AmpTrainer::clone() {
    torch::optim::Adam optimiser(actor_->parameters(), torch::optim::AdamOptions(1e-3));
    const Tensor wanted = (clone_action_ - action_mean_) / action_sd_;
    const Tensor seen = standardised(clone_seen_);
    double error = 0.0;
    for (int i = 0; i < settings_.cloning_updates; ++i) {
        setRate(optimiser, 1e-3 * (1.0 - 0.9 * i / settings_.cloning_updates));
        const Tensor batch = drawnIndices(random_, seen.size(0), 256);
        const Tensor loss =
            torch::mse_loss(actor_->forward(seen.index_select(0, batch)), wanted.index_select(0, batch));
        update(optimiser, actor_->parameters(), loss);
        error += 0.01 * (loss.item<double>() - error);
    }
    average(1.0);
    return error;
}

AmpTrainer::Rollout AmpTrainer::rollOut(double noise_rad) {
    torch::NoGradGuard no_gradient;
    const auto n = static_cast<std::int64_t>(environments_.count());
    const std::int64_t size = settings_.horizon * n;
    const auto seen_size = static_cast<std::int64_t>(environments_.seenSize());
    Rollout out;
    out.seen = torch::empty({size, seen_size});
    out.after = torch::empty({size, seen_size});
    out.past = torch::empty({size, (settings_.discriminator_window - 1) * state_size_});
    out.power_w = torch::empty({size});
    out.mean = torch::empty({size, actions_});
    out.action = torch::empty({size, actions_});
    out.phase = torch::empty({size});
    out.task = torch::empty({size});
    out.task_at_best = torch::empty({size});
    out.ended = torch::empty({size});
    out.fallen = torch::empty({size});
    const auto row = [](const Tensor& tensor, std::int64_t at) {
        return std::span(tensor.data_ptr<float>() + at * tensor.size(1),
                         static_cast<std::size_t>(tensor.size(1)));
    };
    std::vector<double> targets(static_cast<std::size_t>(actions_));
    for (std::int64_t t = 0; t < settings_.horizon; ++t) {
        const Tensor seen = out.seen.narrow(0, t * n, n);
        environments_.see({seen.data_ptr<float>(), static_cast<std::size_t>(n * seen_size)});
        out.mean.narrow(0, t * n, n).copy_(actionOf(seen));
        for (std::int64_t i = 0; i < n; ++i) {
            const std::int64_t at = t * n + i;
            const auto mean = row(out.mean, at), action = row(out.action, at);
            for (std::size_t d = 0; d < targets.size(); ++d) {
                targets[d] = static_cast<double>(mean[d]) + random_.normal(0.0, noise_rad);
                action[d] = static_cast<float>(targets[d]);
            }
            std::ranges::copy(environments_.past(static_cast<std::size_t>(i)), row(out.past, at).begin());
            const auto step = environments_.step(static_cast<std::size_t>(i), targets, row(out.after, at));
            out.phase.data_ptr<float>()[at] = static_cast<float>(step.phase);
            out.task.data_ptr<float>()[at] = static_cast<float>(step.task_reward);
            out.task_at_best.data_ptr<float>()[at] = static_cast<float>(step.task_at_best);
            out.power_w.data_ptr<float>()[at] = static_cast<float>(step.power_w);
            out.ended.data_ptr<float>()[at] = step.ended ? 1.0F : 0.0F;
            out.fallen.data_ptr<float>()[at] = step.fallen ? 1.0F : 0.0F;
        }
    }
    return out;
}

void AmpTrainer::setStyle(Rollout& rollout) {
    torch::NoGradGuard no_gradient;
    rollout.windows = windows(rollout.past, rollout.after.narrow(1, 0, state_size_));
    std::vector<Tensor> logits;
    // All at once would not fit into a processor's cache.
    constexpr std::int64_t portion = 512;
    for (std::int64_t begin = 0; begin < rollout.windows.size(0); begin += portion) {
        const std::int64_t count = std::min(portion, rollout.windows.size(0) - begin);
        logits.push_back(discriminator_->forward(rollout.windows.narrow(0, begin, count),
                                                 rollout.phase.narrow(0, begin, count)));
    }
    rollout.style = 2.0 * torch::softplus(torch::cat(logits)).clamp_max(largest_style);  // -2 ln(1 - sigmoid)
}

void AmpTrainer::setAdvantages(Rollout& rollout) {
    torch::NoGradGuard no_gradient;
    // What a control cannot change is taken off: what the task rewards at best, and the style on average. It
    // depends on the time alone, and the critic would have to know it a hundred times better than what
    // a degree is worth.
    const double mean_style = rollout.style.mean().item<double>();
    const double best_task = rollout.task_at_best.mean().item<double>();
    const Tensor style = rollout.style - mean_style - settings_.power_penalty * rollout.power_w;
    const Tensor task = rollout.task - rollout.task_at_best;
    const double w_style = settings_.style_weight, w_task = settings_.task_weight;
    if (settings_.separate_critics)
        rollout.advantage = w_style * evenly(advantageOf(rollout, *critics_[0], style, mean_style)) +
                            w_task * evenly(advantageOf(rollout, *critics_[1], task, best_task));
    else
        rollout.advantage = advantageOf(rollout, *critics_[0], w_style * style + w_task * task,
                                        w_style * mean_style + w_task * best_task);
    rollout.advantage = evenly(rollout.advantage);
}

Tensor AmpTrainer::advantageOf(Rollout& rollout, Mlp& critic, const Tensor& reward, double without) {
    const Tensor value = valueOf(critic, rollout.seen);
    // A body that has fallen gets nothing more, which is as much less; at the end of time nothing is left to
    // gain.
    const Tensor later = valueOf(critic, rollout.after) * (1.0 - rollout.ended) -
                         without / (1.0 - settings_.discount) * rollout.fallen;
    const Tensor delta = reward + settings_.discount * later - value;
    const Tensor goes_on = settings_.discount * settings_.trace * (1.0 - rollout.ended);
    Tensor out = torch::empty_like(delta);
    const auto n = static_cast<std::int64_t>(environments_.count());
    Tensor next = torch::zeros({n});
    for (std::int64_t t = settings_.horizon - 1; t >= 0; --t) {
        next = delta.narrow(0, t * n, n) + goes_on.narrow(0, t * n, n) * next;
        out.narrow(0, t * n, n).copy_(next);
    }
    rollout.returned.push_back(out + value);
    return out;
}

void AmpTrainer::learnPolicy(const Rollout& rollout, double noise_rad, bool actor_too, AmpIteration& out) {
    const std::int64_t size = rollout.seen.size(0);
    const double scale = 1.0 / valueScale();
    const Tensor seen = standardised(rollout.seen);
    double error = 0.0, clipped = 0.0, updates = 0.0;
    for (int epoch = 0; epoch < settings_.epochs; ++epoch) {
        const Tensor order = permutation(size);
        for (std::int64_t begin = 0; begin + settings_.minibatch <= size; begin += settings_.minibatch) {
            const Tensor batch = order.narrow(0, begin, settings_.minibatch);
            const Tensor some = seen.index_select(0, batch);
            Tensor critic_loss = torch::zeros({});
            for (std::size_t k = 0; k < critics_.size(); ++k)
                critic_loss =
                    critic_loss + torch::mse_loss(critics_[k]->forward(some).squeeze(1),
                                                  scale * rollout.returned[k].index_select(0, batch));
            update(*critic_optimiser_, critic_optimiser_->param_groups().front().params(), critic_loss);
            error += critic_loss.item<double>();
            updates += 1.0;
            if (!actor_too) continue;
            const bool smooth = settings_.lipschitz_penalty > 0.0;
            const Tensor sensed = smooth ? some.detach().requires_grad_() : some;
            const Tensor mean = action_mean_ + action_sd_ * actor_->forward(sensed);
            const Tensor action = rollout.action.index_select(0, batch);
            const Tensor old = rollout.mean.index_select(0, batch);
            const Tensor log_ratio =
                ((action - old).square() - (action - mean).square()).sum(1) / (2.0 * noise_rad * noise_rad);
            const Tensor ratio = log_ratio.exp();
            const Tensor advantage = rollout.advantage.index_select(0, batch);
            const Tensor kept = ratio.clamp(1.0 - settings_.clip, 1.0 + settings_.clip);
            Tensor loss = -torch::min(ratio * advantage, kept * advantage).mean();
            if (smooth) {
                const Tensor slope =
                    torch::autograd::grad({-(action - mean).square().sum() / (2.0 * noise_rad * noise_rad)},
                                          {sensed}, {}, true, true)
                        .front();
                loss = loss + settings_.lipschitz_penalty * slope.square().sum(1).mean();
            }
            update(*actor_optimiser_, actor_->parameters(), loss);
            clipped += ((ratio - 1.0).abs() > settings_.clip).to(torch::kFloat32).mean().item<double>();
        }
    }
    double variance = 0.0;
    for (const Tensor& returned : rollout.returned) variance += (scale * returned).var().item<double>();
    out.value_error = error / updates / std::max(variance, 1e-12);
    out.policy_change = clipped / updates;
}

void AmpTrainer::learnStyle(const Rollout& rollout, AmpIteration& out) {
    const std::int64_t size = settings_.discriminator_batch;
    const Tensor& now = rollout.windows;
    const std::int64_t past = std::min<std::int64_t>(remembered_, settings_.remembered);
    const std::int64_t from_past = past > 0 ? size / 2 : 0;
    for (int i = 0; i < settings_.discriminator_updates; ++i) {
        const Tensor fresh = drawnIndices(random_, now.size(0), size - from_past);
        const Tensor shown = drawnIndices(random_, demonstrated_windows_.size(0), size);
        std::vector<Tensor> x{now.index_select(0, fresh)}, phase{rollout.phase.index_select(0, fresh)};
        if (from_past > 0) {
            const Tensor old = drawnIndices(random_, past, from_past);
            x.push_back(remembered_windows_.index_select(0, old));
            phase.push_back(remembered_phases_.index_select(0, old));
        }
        x.push_back(demonstrated_windows_.index_select(0, shown));
        phase.push_back(demonstrated_phases_.index_select(0, shown));
        const Tensor input = torch::cat(x).requires_grad_();
        const Tensor logits = discriminator_->forward(input, torch::cat(phase));
        const Tensor agent = logits.narrow(0, 0, size), demonstrated = logits.narrow(0, size, size);
        // Of the binary cross-entropies of both, the mean.
        const Tensor told_apart =
            0.5 * (torch::softplus(agent).mean() + torch::softplus(-demonstrated).mean());
        const Tensor slope = torch::autograd::grad({logits.sum()}, {input}, {}, true, true).front();
        const Tensor loss = settings_.discriminator_weight *
                            (told_apart + settings_.gradient_penalty * slope.square().sum(1).mean() +
                             settings_.logit_decay * discriminator_->lastWeight().square().sum());
        discriminator_optimiser_->zero_grad();
        loss.backward({}, {}, false, discriminator_->parameters());  // none for the input
        ranks_.averageGradients(discriminator_->parameters());
        discriminator_optimiser_->step();
        out.agent_logit += agent.mean().item<double>() / settings_.discriminator_updates;
        out.demonstration_logit += demonstrated.mean().item<double>() / settings_.discriminator_updates;
    }
}

void AmpTrainer::remember(const Rollout& rollout) {
    const Tensor& now = rollout.windows;
    const Tensor some = drawnIndices(random_, now.size(0), settings_.remembered_each);
    const Tensor places = torch::remainder(
        torch::arange(remembered_, remembered_ + settings_.remembered_each), settings_.remembered);
    remembered_windows_.index_copy_(0, places, now.index_select(0, some));
    remembered_phases_.index_copy_(0, places, rollout.phase.index_select(0, some));
    remembered_ += settings_.remembered_each;
}

AmpIteration AmpTrainer::iterate(int number) {
    AmpIteration out;
    const double share = std::min(1.0, static_cast<double>(number) / settings_.iterations);
    const double noise_rad = std::lerp(settings_.first_noise_rad, settings_.last_noise_rad, share);
    setRate(*actor_optimiser_, std::lerp(settings_.actor_rate, settings_.last_actor_rate, share));
    Rollout rollout = rollOut(noise_rad);
    setStyle(rollout);
    setAdvantages(rollout);
    learnPolicy(rollout, noise_rad, number > settings_.frozen_iterations, out);
    // None of what was before it tried anything out.
    const int tried = std::max(1, number - settings_.frozen_iterations);
    average(1.0 / std::min(settings_.averaged_iterations, tried));
    learnStyle(rollout, out);
    remember(rollout);
    out.task_reward = rollout.task.mean().item<double>();
    out.task_missed = 1.0 - out.task_reward / std::max(1e-9, rollout.task_at_best.mean().item<double>());
    out.style_reward = rollout.style.mean().item<double>();
    return out;
}

void AmpTrainer::appendPolicy(const std::string& name, std::vector<motion::NamedArray>& out) const {
    out.push_back(arrayOf(name + ".input_mean", seen_mean_));
    out.push_back(arrayOf(name + ".input_sd", seen_sd_));
    out.push_back(arrayOf(name + ".output_mean", action_mean_));
    out.push_back(arrayOf(name + ".output_sd", action_sd_));
    averaged_->append(name, out);
}

bool AmpTrainer::sound() const {
    return fitFloat16(actor_->parameters()) && fitFloat16(discriminator_->parameters()) &&
           std::ranges::all_of(critics_, [](const auto& one) { return fitFloat16(one->parameters()); });
}

template <typename Do>
void AmpTrainer::eachPart(const Do& with) const {
    with("actor", *actor_);
    with("averaged", *averaged_);
    for (std::size_t i = 0; i < critics_.size(); ++i) with(fmt::format("critic{}", i), *critics_[i]);
    with("discriminator", *discriminator_);
    with("actor_optimiser", *actor_optimiser_);
    with("critic_optimiser", *critic_optimiser_);
    with("discriminator_optimiser", *discriminator_optimiser_);
}

void AmpTrainer::save(torch::serialize::OutputArchive& archive) const {
    eachPart([&archive](const std::string& name, const auto& part) {
        torch::serialize::OutputArchive one;
        part.save(one);
        archive.write(name, one);
    });
}

void AmpTrainer::load(torch::serialize::InputArchive& archive) {
    eachPart([&archive](const std::string& name, auto& part) {
        torch::serialize::InputArchive one;
        archive.read(name, one);
        part.load(one);
    });
}

}  // namespace deixis::learning
