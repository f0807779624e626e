// Training of the systems of adversarial motion priors (Peng, Ma, Abbeel, Levine & Kanazawa 2021) as Deichler
// et al. (2023), section 2.2, change them for pointing.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/networks/weights_file.hpp"
#include "physics/figure/figure.hpp"

namespace deixis::learning {

/// Which of the paper's changes are made. Its three systems: no run time (neither), base (phase alone),
/// pfnn (both).
struct AmpVariant {
    /// The policy knows the running time (section 2.2.1). One that does not cannot know when to begin or to
    /// go back: it learns the raise and the hold alone from the demonstrations before it tries anything out,
    /// and which is best is said without regard to the rest at the end.
    bool policy_phase = true;
    /// The discriminator is a phase-functioned network (section 2.2.2): four sets of weights, mixed by the
    /// cubic of Catmull & Rom about the phase, closed to a circle (Holden, Komura & Saito 2017, Eq. 7).
    bool phase_functioned = true;
};

/// What is rewarded as the task, beside the style (Eq. 1).
enum class AmpTask : unsigned char {
    forearm,        ///< Eq. 2: the forearm's line
    eye_fingertip,  ///< the same of the line from the eyes through the index fingertip
    /// How surely an observer picks the target among balls, who reads both lines (section 4 proposes one).
    observer
};
[[nodiscard]] std::string_view taskName(AmpTask task);  ///< "forearm", "eye-fingertip", "observer"
[[nodiscard]] Result<AmpTask> taskFromName(std::string_view name);

/// Sizes and rates that are not the paper's, which does not state them, were found by trial.
struct AmpSettings {
    AmpVariant variant{};
    AmpTask task = AmpTask::forearm;
    physics::Stance stance = physics::Stance::pinned;
    std::vector<int> hidden{256, 128};  ///< units of each network
    double style_weight = 0.5;          ///< Eq. 1
    double task_weight = 0.5;
    /// Share of the task's reward that counts once the demonstration's hold is over. The paper's is 1, for
    /// which some policies keep pointing.
    double task_after_hold = 0.0;
    double target_spread_m = 0.1;  ///< a target is drawn within this of the demonstration's, on each axis
    /// Whether a demonstration counts as one for what the line of its task points at in the middle of its
    /// hold, and not for its own target (hindsight: Andrychowicz et al. 2017). People point by eye and
    /// fingertip, and so their forearms elsewhere. No matter for an observer.
    bool hindsight_targets = true;

    int environments = 256;
    int horizon = 32;  ///< controls an iteration of each
    double discount = 0.97;
    double trace = 0.95;  ///< lambda of the advantages
    double clip = 0.2;
    int epochs = 4;
    int minibatch = 2048;
    double actor_rate = 5e-5;  ///< at the begin
    double last_actor_rate = 1e-5;
    double critic_rate = 1e-3;
    /// The policy is the actor's weights, averaged over about so many iterations (exponentially: Polyak &
    /// Juditsky 1992), since a single iteration's points beside its targets, each time elsewhere. 1: the
    /// last.
    int averaged_iterations = 50;
    double first_noise_rad = 0.04;  ///< SD of what is tried out, at the begin and
    double last_noise_rad = 0.04;   ///< at the end; linear between, as the actor's rate

    double discriminator_rate = 2e-4;
    int discriminator_batch = 512;  ///< of the agent's and as many of the demonstrations' transitions
    int discriminator_updates = 8;  ///< an iteration
    double discriminator_weight = 5.0;
    double gradient_penalty = 1.0;
    double logit_decay = 0.05;
    double weight_decay = 1e-4;
    int remembered = 50'000;                ///< the agent's transitions, at the most
    int remembered_each = 1000;             ///< of them new each iteration
    double demonstration_noise_rad = 0.04;  ///< SD of noise on the actuators' targets of demonstrations
    int demonstration_repeats = 4;          ///< times that each is followed, with other noise

    // Not of the paper, and off ("AMP+", docs/learning.md):
    /// Of the square of the slope of an action's log-probability over what the policy sees, standardised
    /// (Chen, He, Wang, Liao, Ze, Li, Sastry, Wu, Sreenath, Gupta & Peng 2025).
    double lipschitz_penalty = 0.0;
    double power_penalty = 0.0;    ///< taken off the reward for each watt of the actuators, without its sign
    int discriminator_window = 2;  ///< consecutive states that the discriminator sees; the paper's are two
    /// Style and task have a critic each, and their advantages are brought to the same spread before they are
    /// weighted: so one is heard beside the other however little it varies.
    bool separate_critics = false;

    int cloning_updates = 6000;  ///< in which the actor learns the demonstrations' own targets
    int frozen_iterations = 60;  ///< in which critic and discriminator learn alone
    int iterations = 900;
    /// Every so many iterations the policy is tried out, and all but the networks begins anew: the bodies,
    /// the random numbers and the remembered transitions. So a training goes on from there as if it had not
    /// stopped.
    int validate_every = 50;
    int validation_targets = 48;  ///< drawn for each cluster, beside those of held-out demonstrations
    std::uint64_t seed = 1;
};

/// Of a variant. A policy that does not know the time cannot know when the hold is over: the task counts in
/// every frame, as in the paper.
[[nodiscard]] AmpSettings ampSettings(const AmpVariant& variant);

/// All of them by name, for a file's header.
[[nodiscard]] std::map<std::string, motion::NetworkSetting> namedSettings(const AmpSettings& settings);

/// Sets one of them that is a number, by its name, to what was written; true and false are 1 and 0. Error: no
/// such name, or no such value.
[[nodiscard]] Result<void> changeSetting(AmpSettings& settings, std::string_view name,
                                         std::string_view value);

}  // namespace deixis::learning
