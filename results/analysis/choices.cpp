// What was chosen in the game, and where.
#include <glm/geometric.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "results/analysis/analysis_steps.hpp"

namespace deixis::results {

namespace {

/// Which of the balls are the distractors, the nearest to the target first.
std::vector<std::size_t> byNearness(const ChoiceRow& choice, std::size_t target) {
    std::vector<std::size_t> places(choice.balls.size());
    std::iota(places.begin(), places.end(), 0U);
    std::erase(places, target);
    const auto distance = [&](std::size_t place) {
        return glm::distance(choice.balls[place], choice.balls[target]);
    };
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    return places;
}

/// Positive: left of the target for who looks at it from the head's place, along the floor; y is up and x
/// points to the left of who looks along z.
double leftOfTarget(const ChoiceRow& choice, const Vec3& ball, const Vec3& target) {
    const double to_target_x = target.x - choice.head_x_m;
    const double to_target_z = target.z - choice.head_z_m;
    const double to_ball_x = ball.x - choice.head_x_m;
    const double to_ball_z = ball.z - choice.head_z_m;
    return to_ball_x * to_target_z - to_ball_z * to_target_x;
}

/// Of one system, by role.
using RoleCounts = std::map<std::string, std::pair<int, int>>;  // chosen, shown

void countRoles(const ChoiceRow& choice, RoleCounts& counts) {
    const auto target = static_cast<std::size_t>(choice.target_place);
    const auto chosen = static_cast<std::size_t>(choice.chosen_place);
    const auto count = [&](const std::string& role, std::size_t place) {
        auto& [times_chosen, shown] = counts[role];
        times_chosen += place == chosen ? 1 : 0;
        ++shown;
    };
    count("target", target);
    const auto distractors = byNearness(choice, target);
    for (std::size_t i = 0; i < distractors.size(); ++i) {
        const std::size_t place = distractors[i];
        count(fmt::format("nearest {}", i + 1), place);
        const double left = leftOfTarget(choice, choice.balls[place], choice.balls[target]);
        if (left != 0.0) count(left > 0.0 ? "left" : "right", place);
    }
}

void countConfusion(AnalysisResult& result) {
    std::map<std::string, RoleCounts> by_system;
    std::size_t max_balls = 0;
    for (const ChoiceRow& choice : result.table.choices) {
        countRoles(choice, by_system[choice.system]);
        max_balls = std::max(max_balls, choice.balls.size());
    }
    std::vector<std::string> roles{"target"};
    for (std::size_t i = 1; i < max_balls; ++i) roles.push_back(fmt::format("nearest {}", i));
    roles.insert(roles.end(), {"left", "right"});
    for (const std::string& system : result.table.systems)
        for (const std::string& role : roles)
            if (const auto found = by_system[system].find(role); found != by_system[system].end())
                result.confusion.push_back({system, role, found->second.first, found->second.second});
}

void mapTargets(AnalysisResult& result) {
    using Place = std::pair<std::string, std::array<double, 3>>;         // target and position
    std::map<std::string, std::map<Place, std::pair<int, int>>> counts;  // correct choices, all
    for (const ChoiceRow& choice : result.table.choices) {
        const Vec3& at = choice.balls[static_cast<std::size_t>(choice.target_place)];
        for (const std::string& system : {std::string("all"), choice.system}) {
            auto& [right, all] = counts[system][{choice.target_id, {at.x, at.y, at.z}}];
            right += choice.chosen_place == choice.target_place ? 1 : 0;
            ++all;
        }
    }
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    for (const std::string& system : systems)
        for (const auto& [place, count] : counts[system]) {
            const auto& [x, y, z] = place.second;
            result.target_space.push_back({system, place.first, Vec3{x, y, z}, count.second,
                                           static_cast<double>(count.first) / count.second});
        }
}

}  // namespace

void describeChoices(AnalysisResult& result) {
    std::vector<ReadTrial> trials;
    for (const ObservedChoice& choice : result.table.watched) trials.push_back(choice.seen);
    const auto& layouts = result.table.layouts;
    std::stable_sort(trials.begin(), trials.end(), [&layouts](const ReadTrial& a, const ReadTrial& b) {
        return std::find(layouts.begin(), layouts.end(), a.layout) <
               std::find(layouts.begin(), layouts.end(), b.layout);
    });
    result.observers = readByObservers(trials, result.table.systems);
    result.drift = countDrift(result.table.watched, result.table.systems);
    if (result.table.choices.empty()) return;
    countConfusion(result);
    mapTargets(result);
}

}  // namespace deixis::results
