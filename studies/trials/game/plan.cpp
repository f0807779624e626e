// What is planned of the game beside what its design says: the balls.
#include <fmt/core.h>

#include <array>
#include <map>
#include <numeric>
#include <span>
#include <string>

#include "plan_balls.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::studies {

namespace {

/// How far the distractors of each game trial look from its target.
void noteAngles(const Study& study, std::vector<Trial>& trials) {
    for (Trial& trial : trials)
        if (!trial.ball_order.empty())
            trial.angles =
                ballAngles(study, *study.findLayout(trial.layout), trial.target, trial.distractors);
}

/// What is seen of the balls of each game trial, past the reference avatar. All systems show an item with the
/// same balls, so that it is worked out once for each.
void noteVisibility(const Study& study, std::vector<Trial>& trials) {
    const std::vector<Viewpoint> from = viewpoints(study);
    std::map<std::array<std::string, 3>, std::vector<SeenBalls>> known;  // the target first
    for (Trial& trial : trials) {
        if (trial.ball_order.empty()) continue;
        const std::array<std::string, 3> key{trial.stimuli.front().item, trial.distance, trial.layout};
        const auto [entry, fresh] = known.try_emplace(key);
        if (fresh) {
            const double radius_m = study.targets.ball_diameter_m / 2;
            std::vector<Sphere> balls{{trial.target, radius_m}};
            for (const Vec3& distractor : trial.distractors) balls.push_back({distractor, radius_m});
            for (const Viewpoint& viewpoint : from)
                if (viewpoint.layout == trial.layout)
                    entry->second.push_back(seenFrom(viewpoint, StandingAvatar::reference(), balls));
        }
        trial.seen = entry->second;
        for (std::size_t i = 0; i < trial.seen.size(); ++i)
            for (std::size_t place = 0; place < trial.ball_order.size(); ++place) {
                const auto ball = static_cast<std::size_t>(trial.ball_order[place]);
                trial.seen[i].at_rest[place] = entry->second[i].at_rest[ball];
                trial.seen[i].pointing[place] = entry->second[i].pointing[ball];
            }
    }
}

std::string positionsJson(const std::vector<Vec3>& positions) {
    std::string out = "[";
    for (const Vec3& p : positions) {
        if (out.size() > 1) out += ",";
        out += fmt::format("[{},{},{}]", p.x, p.y, p.z);
    }
    return out + "]";
}

}  // namespace

void drawBalls(Trial& trial, const Study& study, const TargetItem& item, int band, Random& random) {
    trial.distance = study.distances[band].name;
    trial.distractors = item.distractors[band];
    trial.ball_order.resize(trial.distractors.size() + 1);
    std::iota(trial.ball_order.begin(), trial.ball_order.end(), 0);
    random.shuffle(std::span<int>(trial.ball_order));
}

void noteBalls(const Study& study, std::vector<Trial>& trials) {
    noteVisibility(study, trials);
    noteAngles(study, trials);
}

std::vector<KeptValue> ballValues(const Trial& trial) {
    if (trial.ball_order.empty()) return {};
    std::vector<Vec3> balls;
    for (std::size_t place = 0; place < trial.ball_order.size(); ++place)
        balls.push_back(trial.ball(static_cast<int>(place)));
    return {{"distractors", {}, positionsJson(trial.distractors)},
            {"balls", {}, positionsJson(balls)},
            {"target_place", trial.targetPlace(), {}}};
}

}  // namespace deixis::studies
