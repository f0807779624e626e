#include "learning/amp/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <variant>

#include "core/number.hpp"

namespace deixis::learning {

namespace {

using Member = std::variant<bool AmpSettings::*, int AmpSettings::*, double AmpSettings::*>;

/// A setting that has a name, and what it may be.
struct Named {
    const char* name;
    Member member;
    double low;
    double high;
};

constexpr std::array<std::string_view, 3> task_names{"forearm", "eye-fingertip", "observer"};

constexpr double many = 10'000'000;

constexpr std::array named{
    Named{"style_weight", &AmpSettings::style_weight, 0.0, 100.0},
    Named{"task_weight", &AmpSettings::task_weight, 0.0, 100.0},
    Named{"task_after_hold", &AmpSettings::task_after_hold, 0.0, 1.0},
    Named{"target_spread_m", &AmpSettings::target_spread_m, 0.0, 10.0},
    Named{"hindsight_targets", &AmpSettings::hindsight_targets, 0, 1},
    Named{"environments", &AmpSettings::environments, 1, 65'536},
    Named{"horizon", &AmpSettings::horizon, 2, 1024},
    Named{"discount", &AmpSettings::discount, 0.0, 0.9999},
    Named{"trace", &AmpSettings::trace, 0.0, 1.0},
    Named{"clip", &AmpSettings::clip, 0.001, 1.0},
    Named{"epochs", &AmpSettings::epochs, 1, 100},
    Named{"minibatch", &AmpSettings::minibatch, 1, many},
    Named{"actor_rate", &AmpSettings::actor_rate, 0.0, 1.0},
    Named{"last_actor_rate", &AmpSettings::last_actor_rate, 0.0, 1.0},
    Named{"critic_rate", &AmpSettings::critic_rate, 0.0, 1.0},
    Named{"first_noise_rad", &AmpSettings::first_noise_rad, 0.0001, 1.0},
    Named{"last_noise_rad", &AmpSettings::last_noise_rad, 0.0001, 1.0},
    Named{"discriminator_rate", &AmpSettings::discriminator_rate, 0.0, 1.0},
    Named{"discriminator_batch", &AmpSettings::discriminator_batch, 2, many},
    Named{"discriminator_updates", &AmpSettings::discriminator_updates, 0, 10'000},
    Named{"discriminator_weight", &AmpSettings::discriminator_weight, 0.0, 1000.0},
    Named{"gradient_penalty", &AmpSettings::gradient_penalty, 0.0, 1000.0},
    Named{"logit_decay", &AmpSettings::logit_decay, 0.0, 1000.0},
    Named{"weight_decay", &AmpSettings::weight_decay, 0.0, 1.0},
    Named{"remembered", &AmpSettings::remembered, 1, many},
    Named{"remembered_each", &AmpSettings::remembered_each, 1, many},
    Named{"demonstration_noise_rad", &AmpSettings::demonstration_noise_rad, 0.0, 1.0},
    Named{"demonstration_repeats", &AmpSettings::demonstration_repeats, 1, 100},
    Named{"lipschitz_penalty", &AmpSettings::lipschitz_penalty, 0.0, 100.0},
    Named{"power_penalty", &AmpSettings::power_penalty, 0.0, 1.0},
    Named{"discriminator_window", &AmpSettings::discriminator_window, 2, 30},
    Named{"separate_critics", &AmpSettings::separate_critics, 0, 1},
    Named{"cloning_updates", &AmpSettings::cloning_updates, 0, many},
    Named{"averaged_iterations", &AmpSettings::averaged_iterations, 1, many},
    Named{"frozen_iterations", &AmpSettings::frozen_iterations, 0, many},
    Named{"iterations", &AmpSettings::iterations, 1, many},
    Named{"validate_every", &AmpSettings::validate_every, 1, many},
    Named{"validation_targets", &AmpSettings::validation_targets, 1, 10'000},
};

double valueOf(const AmpSettings& settings, const Member& member) {
    return std::visit([&](auto one) { return static_cast<double>(settings.*one); }, member);
}

}  // namespace

std::string_view taskName(AmpTask task) {
    return task_names[static_cast<std::size_t>(task)];
}

Result<AmpTask> taskFromName(std::string_view name) {
    const auto* const found = std::ranges::find(task_names, name);
    if (found == task_names.end())
        return fail("reward",
                    fmt::format("found '{}', expected one of {}", name, fmt::join(task_names, ", ")));
    return static_cast<AmpTask>(found - task_names.begin());
}

AmpSettings ampSettings(const AmpVariant& variant) {
    AmpSettings out{.variant = variant};
    if (!variant.policy_phase) out.task_after_hold = 1.0;
    return out;
}

std::map<std::string, motion::NetworkSetting> namedSettings(const AmpSettings& settings) {
    std::map<std::string, motion::NetworkSetting> out{
        {"phase_functioned", static_cast<double>(settings.variant.phase_functioned)},
        {"task", std::string(taskName(settings.task))}};
    for (const Named& one : named) out.emplace(one.name, valueOf(settings, one.member));
    return out;
}

Result<void> changeSetting(AmpSettings& settings, std::string_view name, std::string_view value) {
    for (const Named& one : named) {
        if (one.name != name) continue;
        const auto number = finiteNumber(value);
        const bool whole = !std::holds_alternative<double AmpSettings::*>(one.member);
        if (!number || *number < one.low || *number > one.high || (whole && !wholeNumber(value)))
            return fail(std::string(name),
                        fmt::format("found '{}', expected {} from {} to {}", value,
                                    whole ? "a whole number" : "a number", one.low, one.high));
        std::visit(
            [&](auto member) {
                using Value = std::remove_reference_t<decltype(settings.*member)>;
                settings.*member = static_cast<Value>(*number);
            },
            one.member);
        return {};
    }
    std::vector<std::string> names;
    for (const Named& one : named) names.emplace_back(one.name);
    return fail(std::string(name), fmt::format("is no setting; they are {}", fmt::join(names, ", ")));
}

}  // namespace deixis::learning
