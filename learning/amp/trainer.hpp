// One policy's training: actor and critic by proximal policy optimisation (Schulman et al. 2017), and the
// discriminator that tells how much the body moves as in the demonstrations.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "environments.hpp"
#include "learning/ranks/ranks.hpp"
#include "modules.hpp"

namespace deixis::learning {

/// What an iteration was like; means over its controls.
struct AmpIteration {
    double task_reward = 0.0;
    double style_reward = 0.0;
    double agent_logit = 0.0;  ///< the discriminator's of the agent's transitions
    double demonstration_logit = 0.0;
    double task_missed = 0.0;    ///< share of the task's reward that a policy without an error would have
    double value_error = 0.0;    ///< share of the returns' variance that the critic does not explain
    double policy_change = 0.0;  ///< share of controls whose probability ratio was clipped
    [[nodiscard]] bool finite() const;
};

class AmpTrainer {
  public:
    /// Of `all`, the actor learns by cloning, and what networks see is standardised by them; all else is
    /// learned of `references`, which stay where they are. One after another is made, even in several
    /// threads.
    AmpTrainer(const physics::Body& body, const std::vector<ReferenceMotion>& all,
               const std::vector<ReferenceMotion>& references, const AmpSettings& settings,
               std::uint64_t seed, Ranks& ranks);

    /// The actor learns the demonstrations' own targets. The mean squared error at the end, as a share of
    /// their variance.
    double clone();
    /// All but the networks begins anew, with random numbers of its own: that many iterations are done.
    void restart(int iterations);
    /// One iteration, counted from 1.
    [[nodiscard]] AmpIteration iterate(int number);

    /// The policy's arrays, as Policy::read() reads them.
    void appendPolicy(const std::string& name, std::vector<motion::NamedArray>& out) const;
    /// Whether all of the networks' numbers are finite and a file can hold them.
    [[nodiscard]] bool sound() const;
    /// The networks and their optimisers.
    void save(torch::serialize::OutputArchive& archive) const;
    void load(torch::serialize::InputArchive& archive);

  private:
    /// The controls of an iteration, environment after environment within each time, flattened.
    struct Rollout {
        torch::Tensor seen, after, action, mean;
        torch::Tensor windows;  ///< what the discriminator is shown
        torch::Tensor past;     ///< states, to the present one
        torch::Tensor phase, task, task_at_best, style, power_w;
        torch::Tensor ended, fallen;
        torch::Tensor advantage;
        std::vector<torch::Tensor> returned;  ///< for each critic
    };
    /// with(name, part) for the networks and their optimisers.
    template <typename Do>
    void eachPart(const Do& with) const;
    void setCloned(const physics::Body& body, const std::vector<ReferenceMotion>& all);
    [[nodiscard]] torch::Tensor standardised(const torch::Tensor& seen) const;
    /// The first of some consecutive states, and the changes from one to the next, each in its own scale.
    /// past: N x all but the last, after: N x the last.
    [[nodiscard]] torch::Tensor windows(const torch::Tensor& past, const torch::Tensor& after) const;
    [[nodiscard]] torch::Tensor actionOf(const torch::Tensor& seen);
    [[nodiscard]] torch::Tensor valueOf(Mlp& critic, const torch::Tensor& seen);
    static constexpr double usual_reward = 0.1;  ///< how far a control's is from what is taken off it
    [[nodiscard]] double valueScale() const { return usual_reward / (1.0 - settings_.discount); }
    [[nodiscard]] torch::Tensor permutation(std::int64_t count);
    [[nodiscard]] Rollout rollOut(double noise_rad);
    void setStyle(Rollout& rollout);
    void setAdvantages(Rollout& rollout);
    /// What a control cannot change is not in `reward`; `without` is that, on average. Adds what `critic`
    /// should have said to `rollout`, and returns the advantages.
    [[nodiscard]] torch::Tensor advantageOf(Rollout& rollout, Mlp& critic, const torch::Tensor& reward,
                                            double without);
    void update(torch::optim::Adam& optimiser, const std::vector<torch::Tensor>& parameters,
                const torch::Tensor& loss);
    /// Brings the policy this share nearer to the actor.
    void average(double share);
    void learnPolicy(const Rollout& rollout, double noise_rad, bool actor_too, AmpIteration& out);
    void learnStyle(const Rollout& rollout, AmpIteration& out);
    void remember(const Rollout& rollout);

    AmpSettings settings_;
    Ranks& ranks_;
    std::uint64_t seed_;
    Environments environments_;
    Random random_;
    std::int64_t state_size_;
    std::int64_t actions_;
    torch::Tensor seen_mean_, seen_sd_, change_sd_, action_mean_, action_sd_;
    torch::Tensor clone_seen_, clone_action_;
    torch::Tensor demonstrated_windows_, demonstrated_phases_;
    torch::Tensor remembered_windows_, remembered_phases_;
    std::int64_t remembered_ = 0;  ///< so many since the last restart
    std::shared_ptr<Mlp> actor_;
    std::vector<std::shared_ptr<Mlp>> critics_;  ///< one, or style's and task's
    std::shared_ptr<Mlp> averaged_;              ///< the actor of the last iterations, the policy
    std::shared_ptr<Discriminator> discriminator_;
    std::unique_ptr<torch::optim::Adam> actor_optimiser_, critic_optimiser_, discriminator_optimiser_;
};

}  // namespace deixis::learning
