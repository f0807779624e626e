#include "learning/amp/settings.hpp"

#include <fmt/format.h>

namespace deixis::learning {

std::map<std::string, motion::NetworkSetting> namedSettings(const AmpSettings& s) {
    const auto number = [](auto value) { return motion::NetworkSetting(static_cast<double>(value)); };
    return {
        {"phase_functioned", number(s.variant.phase_functioned)},
        {"task", std::string(s.task == AmpTask::forearm ? "forearm" : "eye-fingertip")},
        {"style_weight", number(s.style_weight)},
        {"task_weight", number(s.task_weight)},
        {"task_in_hold_only", number(s.task_in_hold_only)},
        {"target_spread_m", number(s.target_spread_m)},
        {"environments", number(s.environments)},
        {"horizon", number(s.horizon)},
        {"discount", number(s.discount)},
        {"trace", number(s.trace)},
        {"clip", number(s.clip)},
        {"epochs", number(s.epochs)},
        {"minibatch", number(s.minibatch)},
        {"actor_rate", number(s.actor_rate)},
        {"critic_rate", number(s.critic_rate)},
        {"first_noise_rad", number(s.first_noise_rad)},
        {"last_noise_rad", number(s.last_noise_rad)},
        {"discriminator_rate", number(s.discriminator_rate)},
        {"discriminator_batch", number(s.discriminator_batch)},
        {"discriminator_updates", number(s.discriminator_updates)},
        {"discriminator_weight", number(s.discriminator_weight)},
        {"gradient_penalty", number(s.gradient_penalty)},
        {"logit_decay", number(s.logit_decay)},
        {"weight_decay", number(s.weight_decay)},
        {"remembered", number(s.remembered)},
        {"remembered_each", number(s.remembered_each)},
        {"demonstration_noise_rad", number(s.demonstration_noise_rad)},
        {"demonstration_repeats", number(s.demonstration_repeats)},
        {"cloning_updates", number(s.cloning_updates)},
        {"frozen_iterations", number(s.frozen_iterations)},
        {"iterations", number(s.iterations)},
        {"validate_every", number(s.validate_every)},
        {"validation_targets", number(s.validation_targets)},
    };
}

}  // namespace deixis::learning
