#include "results/answers/observers.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

studies::ObserverModel observerNamed(const char* name) {
    studies::ObserverModel model;
    model.reading = *studies::readingFromName(name);
    return model;
}

studies::SeenArm asReadBy(std::size_t observer, studies::SeenArm arm) {
    arm.lines.line = observer == 1 ? arm.lines.arm_line : arm.lines.eye_line;
    return arm;
}

/// Of balls that are missed equally little each is taken as often.
double shareWithoutError(const studies::ObserverModel& model, const studies::SeenArm& arm,
                         const std::vector<Vec3>& balls) {
    studies::ObserverModel exact = model;
    exact.noise_rad = 0.0;
    if (model.reading.twoCue()) return studies::ballChance(exact, arm, balls, 0);
    const std::vector<double> missed = studies::misses(exact, arm, balls);
    const double min = *std::min_element(missed.begin(), missed.end());
    if (missed.front() > min) return 0.0;
    return 1.0 / static_cast<double>(std::count(missed.begin(), missed.end(), min));
}

struct ObserverSums {
    double trials = 0.0;
    std::array<double, observer_names.size()> accuracy{}, without_error{};
};

}  // namespace

std::vector<ObserverReading> readByObservers(const std::vector<ReadTrial>& trials,
                                             const std::vector<std::string>& systems) {
    std::array<studies::ObserverModel, observer_names.size()> models{};
    std::transform(observer_names.begin(), observer_names.end(), models.begin(), observerNamed);
    std::vector<std::string> layouts;
    for (const ReadTrial& trial : trials)
        if (std::find(layouts.begin(), layouts.end(), trial.layout) == layouts.end())
            layouts.push_back(trial.layout);
    std::vector<std::string> rows = layouts;
    if (rows.size() != 1) rows.insert(rows.begin(), "all");
    std::vector<std::vector<ObserverSums>> sums(systems.size(), std::vector<ObserverSums>(rows.size()));
    for (const ReadTrial& trial : trials) {
        const auto system = std::find(systems.begin(), systems.end(), trial.system);
        if (system == systems.end()) continue;
        ObserverSums here;
        here.trials = trial.answers;
        for (std::size_t i = 0; i < models.size(); ++i) {
            const studies::SeenArm arm = asReadBy(i, trial.arm);
            here.accuracy[i] = studies::choiceChance(models[i], arm, trial.balls, 0);
            here.without_error[i] = shareWithoutError(models[i], arm, trial.balls);
        }
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows[row] != trial.layout && (row > 0 || layouts.size() == 1)) continue;
            ObserverSums& sum = sums[static_cast<std::size_t>(system - systems.begin())][row];
            sum.trials += here.trials;
            for (std::size_t i = 0; i < models.size(); ++i) {
                sum.accuracy[i] += here.trials * here.accuracy[i];
                sum.without_error[i] += here.trials * here.without_error[i];
            }
        }
    }
    std::vector<ObserverReading> out;
    for (std::size_t s = 0; s < systems.size(); ++s)
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const ObserverSums& sum = sums[s][row];
            if (sum.trials <= 0.0) continue;
            ObserverReading& one = out.emplace_back();
            one.system = systems[s];
            one.layout = rows[row];
            one.trials = sum.trials;
            for (std::size_t i = 0; i < models.size(); ++i) {
                one.accuracy[i] = sum.accuracy[i] / sum.trials;
                one.without_error[i] = sum.without_error[i] / sum.trials;
            }
        }
    return out;
}

std::vector<DriftResult> countDrift(const std::vector<ObservedChoice>& choices,
                                    const std::vector<std::string>& systems) {
    struct Line {
        const char* name;
        Ray studies::ArmLines::*of;
    };
    constexpr std::array<Line, 2> lines{
        {{"arm-finger", &studies::ArmLines::arm_line}, {"eye-fingertip", &studies::ArmLines::eye_line}}};
    std::vector<DriftResult> out;
    for (const std::string& system : systems)
        for (const Line& line : lines) {
            DriftResult counts;
            counts.system = system;
            counts.line = line.name;
            for (const ObservedChoice& choice : choices) {
                if (choice.seen.system != system) continue;
                const auto chosen = static_cast<std::size_t>(choice.chosen);
                const std::size_t first = motion::chosenBall(choice.first.*line.of, choice.seen.balls)->ball;
                const std::size_t last = motion::chosenBall(choice.last.*line.of, choice.seen.balls)->ball;
                ++counts.choices;
                counts.of_first += first == chosen ? 1 : 0;
                counts.of_last += last == chosen ? 1 : 0;
                if (first == last) continue;
                ++counts.moved;
                counts.moved_first += first == chosen ? 1 : 0;
                counts.moved_last += last == chosen ? 1 : 0;
            }
            if (counts.choices > 0) out.push_back(std::move(counts));
        }
    return out;
}

std::array<ObserverRanking, observer_names.size()> observerRankings(
    const std::vector<ObserverReading>& readings) {
    std::vector<const ObserverReading*> first;  // of each system: over all layouts
    for (const ObserverReading& one : readings)
        if (first.empty() || first.back()->system != one.system) first.push_back(&one);
    constexpr double alike = 0.01;
    std::array<ObserverRanking, observer_names.size()> out{};
    for (std::size_t i = 0; i < observer_names.size(); ++i) {
        std::vector<const ObserverReading*> left = first;
        while (!left.empty()) {
            const auto best = std::max_element(left.begin(), left.end(), [i](const auto* a, const auto* b) {
                return a->accuracy[i] < b->accuracy[i];
            });
            const double min = (*best)->accuracy[i] - alike;
            std::vector<std::string>& group = out[i].emplace_back();
            std::erase_if(left, [&](const auto* one) {
                if (one->accuracy[i] < min) return false;
                group.push_back(one->system);
                return true;
            });
        }
    }
    return out;
}

NearestCeiling nearestCeiling(const std::vector<std::vector<Vec3>>& balls, const std::vector<Vec3>& training,
                              const Vec3& pointer_eye) {
    NearestCeiling out;
    std::vector<double> distances;
    int right = 0;
    for (const std::vector<Vec3>& shown : balls) {
        const Vec3& target = shown.front();
        const Vec3& nearest =
            *std::min_element(training.begin(), training.end(), [&target](const Vec3& a, const Vec3& b) {
                return glm::distance(a, target) < glm::distance(b, target);
            });
        distances.push_back(glm::distance(nearest, target));
        const Ray line{pointer_eye, glm::normalize(nearest - pointer_eye)};
        right += motion::chosenBall(line, shown)->ball == 0 ? 1 : 0;
    }
    out.targets = static_cast<int>(balls.size());
    out.median_distance_m = quantile(distances, 0.5);
    out.share_right = static_cast<double>(right) / static_cast<double>(balls.size());
    return out;
}

}  // namespace deixis::results
