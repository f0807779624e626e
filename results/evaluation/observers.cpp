#include "observers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::results {

namespace {

constexpr double same_place_m = 0.001;

/// Not where a bone has no length, so that a line has no direction.
bool allKnown(const studies::ArmLines& lines) {
    const auto unit = [](const Ray& line) { return std::abs(glm::length(line.direction) - 1.0) < 1e-6; };
    return unit(lines.eye_line) && unit(lines.arm_line);
}

}  // namespace

Result<void> readGames(Evaluation& evaluation) {
    if (!evaluation.input.study) return {};
    const StudyGames& study = *evaluation.input.study;
    std::vector<ReadTrial> trials;
    int of_other_targets = 0;
    int without_lines = 0;
    for (const MeasuredClip& clip : evaluation.input.clips) {
        bool found = false;
        for (const StudyGames::Game& game : study.games) {
            if (game.target_id != clip.target_id ||
                glm::distance(game.balls.front(), clip.target) > same_place_m)
                continue;
            found = true;
            if (!allKnown(clip.lines)) {
                ++without_lines;
                break;
            }
            for (const StudyGames::Place& place : study.places)
                trials.push_back({clip.system, place.layout, {clip.lines, place.observer_eye}, game.balls});
        }
        of_other_targets += found ? 0 : 1;
    }
    if (trials.empty())
        return fail("--study",
                    fmt::format("no clip was made for a target of the study '{}' in which a game is played",
                                study.name),
                    "Make the clips for the targets that 'deixis targets' prints for this study");
    std::vector<std::string> systems;
    for (const SystemEvaluation& system : evaluation.systems) systems.push_back(system.system);
    evaluation.observers = readByObservers(trials, systems);
    std::vector<std::vector<Vec3>> balls;
    for (const StudyGames::Game& game : study.games) balls.push_back(game.balls);
    evaluation.nearest = nearestCeiling(balls, evaluation.input.training, study.pointer_eye);
    const auto note = [&](int clips, const char* why) {
        if (clips > 0)
            evaluation.remarks.push_back(fmt::format("{} clip{} {}: no observer reads {}.", clips,
                                                     clips == 1 ? "" : "s", why, clips == 1 ? "it" : "them"));
    };
    note(of_other_targets, "were made for targets that the study does not have");
    note(without_lines, "have no line of eye or arm");
    return {};
}

}  // namespace deixis::results
