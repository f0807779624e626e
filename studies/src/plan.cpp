#include "studies/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/random.hpp"

namespace deixis::studies {

namespace {

template <typename T>
void shuffle(std::vector<T>& items, Random& random) {
    random.shuffle(std::span<T>(items));
}

/// The targets of one participant, by what they serve for.
struct Picks {
    std::vector<TargetItem> rated, rated_practice, played, played_practice;
};

Picks pickTargets(const Study& study, std::vector<TargetItem> targets, Random random) {
    shuffle(targets, random);
    auto next = targets.begin();
    const auto take = [&](int count) {
        const auto begin = next;
        next += count;
        return std::vector<TargetItem>(begin, next);
    };
    Picks picks;
    picks.rated = take(study.rating.items);
    picks.played = take(study.game.items);
    picks.rated_practice = take(study.rating.practice);
    picks.played_practice = take(study.game.practice);
    return picks;
}

/// One layout for each of `count` targets: all layouts equally often, chance giving away the remainder.
std::vector<std::string> shareLayouts(std::vector<std::string> layouts, std::size_t count, Random random) {
    shuffle(layouts, random);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(layouts[i % layouts.size()]);
    shuffle(out, random);
    return out;
}

Trial ratingTrial(const Study& study, const TargetItem& item, const std::string& system) {
    Trial trial;
    trial.stage = StageKind::naturalness;
    trial.system = system;
    trial.target_id = item.id;
    trial.layout = study.rating.layout;
    trial.target = item.target;
    return trial;
}

Trial gameTrial(const TargetItem& item, const std::string& system, const std::string& layout) {
    Trial trial;
    trial.stage = StageKind::game;
    trial.system = system;
    trial.target_id = item.id;
    trial.layout = layout;
    trial.target = item.target;
    trial.distractors = item.distractors;
    trial.ball_order.resize(item.distractors.size() + 1);
    std::iota(trial.ball_order.begin(), trial.ball_order.end(), 0);
    return trial;
}

Result<void> checkInput(const Study& study, const std::vector<TargetItem>& targets,
                        std::string_view participant) {
    if (!validParticipant(participant))
        return fail(
            "participant",
            fmt::format("found \"{}\", expected 1 to 32 letters A-Z a-z, digits, '_' and '-'", participant),
            "Use an id such as P01");
    const int needed = study.rating.items + study.game.items + study.rating.practice + study.game.practice;
    if (static_cast<int>(targets.size()) < needed)
        return fail("targets.count", fmt::format("found {} targets, expected at least {} for the items and "
                                                 "practice trials of both stages",
                                                 targets.size(), needed));
    if (study.systems.empty()) return fail("systems", "found none, expected at least one");
    if (study.game.layouts.empty()) return fail("game.layouts", "found none, expected at least one");
    return {};
}

}  // namespace

std::string_view stageName(StageKind kind) {
    return kind == StageKind::naturalness ? "naturalness" : "game";
}

bool validParticipant(std::string_view participant) {
    constexpr std::size_t longest = 32;
    return !participant.empty() && participant.size() <= longest &&
           std::all_of(participant.begin(), participant.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '_' || c == '-';
           });
}

const Vec3& Trial::ball(int place) const {
    const int which = ball_order.at(static_cast<std::size_t>(place));
    return which == 0 ? target : distractors.at(static_cast<std::size_t>(which - 1));
}

int Trial::targetPlace() const {
    const auto found = std::find(ball_order.begin(), ball_order.end(), 0);
    return found == ball_order.end() ? -1 : static_cast<int>(found - ball_order.begin());
}

Result<StudyPlan> buildPlan(const Study& study, const std::vector<TargetItem>& targets,
                            std::string_view participant) {
    if (const Result<void> checked = checkInput(study, targets, participant); !checked)
        return tl::unexpected(checked.error());

    const std::uint64_t seed = deriveSeed(deriveSeed(study.seed, "plan"), participant);
    const Picks picks = pickTargets(study, targets, Random(seed, "items"));

    std::vector<std::string> practice_systems;
    for (const SystemSource& system : study.systems) practice_systems.push_back(system.name);
    Random practice_random(seed, "practice");
    shuffle(practice_systems, practice_random);
    std::vector<std::string> practice_layouts = study.game.layouts;
    shuffle(practice_layouts, practice_random);
    std::size_t practised = 0;  // goes on over both stages: few practice trials still show many systems
    const auto practiceSystem = [&] { return practice_systems[practised++ % practice_systems.size()]; };

    StudyPlan plan{std::string(participant), study.name, study.hash, study.seed, {}};
    const auto append = [&](std::vector<Trial> trials, bool practice) {
        for (Trial& trial : trials) {
            trial.practice = practice;
            trial.index = static_cast<int>(plan.trials.size());
            plan.trials.push_back(std::move(trial));
        }
    };

    std::vector<Trial> trials;
    for (const TargetItem& item : picks.rated_practice)
        trials.push_back(ratingTrial(study, item, practiceSystem()));
    append(std::move(trials), true);

    trials.clear();
    for (const SystemSource& system : study.systems)
        for (const TargetItem& item : picks.rated) trials.push_back(ratingTrial(study, item, system.name));
    Random rating_order(seed, "naturalness order");
    shuffle(trials, rating_order);
    append(std::move(trials), false);

    trials.clear();
    for (std::size_t i = 0; i < picks.played_practice.size(); ++i)
        trials.push_back(gameTrial(picks.played_practice[i], practiceSystem(),
                                   practice_layouts[i % practice_layouts.size()]));
    append(std::move(trials), true);

    trials.clear();
    const std::vector<std::string> layouts =
        shareLayouts(study.game.layouts, picks.played.size(), Random(seed, "layouts"));
    for (const SystemSource& system : study.systems)
        for (std::size_t i = 0; i < picks.played.size(); ++i)
            trials.push_back(gameTrial(picks.played[i], system.name, layouts[i]));
    Random game_order(seed, "game order");
    shuffle(trials, game_order);
    append(std::move(trials), false);

    Random ball_random(seed, "ball order");
    for (Trial& trial : plan.trials) shuffle(trial.ball_order, ball_random);
    return plan;
}

}  // namespace deixis::studies
