#include "studies/simulation/observer_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "profile_likelihood.hpp"
#include "simulated_observer.hpp"

namespace deixis::studies {

namespace {

/// How probable a choice is at each noise, without lapses: what all fits look up.
struct ChoiceTable {
    std::array<double, noises> chosen{};
    double by_chance = 0.5;

    [[nodiscard]] double at(double place) const {
        const auto below = std::min(static_cast<std::size_t>(place), noises - 2);
        const double t = place - static_cast<double>(below);
        const double p1 = chosen[below], p2 = chosen[below + 1];
        const double p0 = below > 0 ? chosen[below - 1] : p1;
        const double p3 = below + 2 < noises ? chosen[below + 2] : p2;
        // Catmull-Rom: smooth, so that what is searched has no corners.
        const double p =
            p1 +
            0.5 * t * (p2 - p0 + t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 + t * (3.0 * (p1 - p2) + p3 - p0)));
        return std::clamp(p, 0.0, 1.0);
    }
};

std::vector<ChoiceTable> tablesOf(std::span<const SeenChoice> choices, ObserverModel model) {
    std::vector<ChoiceTable> out;
    out.reserve(choices.size());
    for (const SeenChoice& choice : choices) {
        ChoiceTable& table = out.emplace_back();
        table.by_chance = 1.0 / static_cast<double>(choice.balls.size());
        for (std::size_t i = 0; i < noises; ++i) {
            model.noise_rad = radiansFromDegrees(noiseAt(static_cast<double>(i)));
            table.chosen[i] = ballChance(model, choice.arm, choice.balls, choice.chosen);
        }
    }
    return out;
}

double logLikelihoodAt(const std::vector<ChoiceTable>& tables, double place, double lapse) {
    double sum = 0.0;
    for (const ChoiceTable& table : tables)
        sum += logOf((1.0 - lapse) * table.at(place) + lapse * table.by_chance);
    return sum;
}

/// The best lapse rate at a noise: the log-likelihood is concave in it, so its slope has one zero at most.
Peak bestLapse(const std::vector<ChoiceTable>& tables, double place) {
    std::vector<double> probabilities;
    probabilities.reserve(tables.size());
    for (const ChoiceTable& table : tables) probabilities.push_back(table.at(place));
    const auto slope = [&](double lapse) {
        double sum = 0.0;
        for (std::size_t i = 0; i < tables.size(); ++i) {
            const double p = (1.0 - lapse) * probabilities[i] + lapse * tables[i].by_chance;
            sum += (tables[i].by_chance - probabilities[i]) / std::max(p, 1e-300);
        }
        return sum;
    };
    const double lapse = slope(0.0) <= 0.0   ? 0.0
                         : slope(1.0) >= 0.0 ? 1.0
                                             : rootBetween(0.0, 1.0, 1e-13, slope);
    return {lapse, logLikelihoodAt(tables, place, lapse)};
}

Peak bestNoise(const std::vector<ChoiceTable>& tables, double lapse) {
    return highest(0.0, last_place, static_cast<int>(noises),
                   [&](double place) { return logLikelihoodAt(tables, place, lapse); });
}

}  // namespace

std::optional<SeenChoice> seenChoice(const RecordedTrial& recorded, const ClipSource& clips,
                                     const motion::Skeleton& avatar, const motion::LocalPose& idle_pose,
                                     const Reading& reading, double elevation_bias_deg,
                                     double frame_rate_hz) {
    if (recorded.chosenPlace() < 0 || recorded.trial.ball_order.size() < 2 || recorded.plays.empty())
        return std::nullopt;
    constexpr double before_s = 0.2;  // of standing still, so that the raise is seen to begin
    const TrialReplay replay(recorded, clips, avatar, idle_pose);
    const RecordedPlay& last = recorded.plays.back();
    const double end_s = last.end_s.value_or(recorded.answered_s);
    GestureObserver observer(avatar, reading);
    const double step_s = 1.0 / frame_rate_hz;
    for (double time_s = last.onset_s - before_s; time_s <= end_s; time_s += step_s)
        observer.see(replay.at(time_s).avatar_joints, time_s);
    const SeenGesture gesture = observer.gesture();
    SeenChoice out;
    out.arm.lines = raised(gesture.lines, radiansFromDegrees(elevation_bias_deg));
    // Not equal to 1 where it is no number, either.
    for (const Ray& line : {gesture.lines.line, gesture.lines.arm_line, gesture.lines.eye_line})
        if (!(std::abs(glm::length(line.direction) - 1.0) < 1e-6)) return std::nullopt;
    out.arm.observer_eye = replay.head(gesture.hold_middle_s).value_or(recorded.stage_from_head).position;
    for (int place = 0; place < static_cast<int>(recorded.trial.ball_order.size()); ++place)
        out.balls.push_back(recorded.trial.ball(place));
    out.chosen = static_cast<std::size_t>(recorded.chosenPlace());
    return out;
}

double observerLogLikelihood(std::span<const SeenChoice> choices, const ObserverModel& model) {
    double sum = 0.0;
    for (const SeenChoice& seen : choices)
        sum += logOf(choiceChance(model, seen.arm, seen.balls, seen.chosen));
    return sum;
}

ObserverFit fitObserver(std::span<const SeenChoice> choices, const ObserverModel& model, double level) {
    const std::vector<ChoiceTable> tables = tablesOf(choices, model);
    const auto by_noise = [&](double place) { return bestLapse(tables, place).value; };
    const auto by_lapse = [&](double lapse) { return bestNoise(tables, lapse).value; };
    const Peak noise = highest(0.0, last_place, static_cast<int>(noises), by_noise);
    const Peak lapse = bestLapse(tables, noise.at);
    const double wanted = noise.value - allowedFall(level);
    constexpr double tolerance = 1e-9;
    const auto inDegrees = [](std::optional<double> place) {
        return place ? std::optional<double>(noiseAt(*place)) : std::nullopt;
    };
    ObserverFit out;
    out.choices = static_cast<int>(choices.size());
    out.noise_deg = {noiseAt(noise.at), inDegrees(crossing(noise.at, 0.0, wanted, tolerance, by_noise)),
                     inDegrees(crossing(noise.at, last_place, wanted, tolerance, by_noise))};
    out.lapse_rate = {lapse.at, crossing(lapse.at, 0.0, wanted, tolerance, by_lapse),
                      crossing(lapse.at, 1.0, wanted, tolerance, by_lapse)};
    out.log_likelihood = noise.value;
    out.aic = 2.0 * 2.0 - 2.0 * noise.value;
    return out;
}

PopulationFit fitPopulation(std::span<const std::vector<SeenChoice>> by_participant,
                            const ObserverModel& model) {
    std::vector<std::vector<ChoiceTable>> tables;
    for (const auto& choices : by_participant) tables.push_back(tablesOf(choices, model));
    const auto logLikelihood = [&](double noise_deg, double between, double lapse) {
        constexpr double step = 0.5;
        constexpr int steps = 8;
        double sum = 0.0;
        std::array<double, 2 * steps + 1> parts{};
        for (const auto& table : tables) {
            double weights = 0.0;
            for (int i = 0; i <= 2 * steps; ++i) {
                const double z = step * (i - steps);
                const double noise = noise_deg * std::max(0.2, 1.0 + between * z);
                parts[static_cast<std::size_t>(i)] =
                    -0.5 * z * z + logLikelihoodAt(table, gridPlace(noise), lapse);
                weights += std::exp(-0.5 * z * z);
            }
            const double max = *std::max_element(parts.begin(), parts.end());
            double of_participant = 0.0;
            for (const double part : parts) of_participant += std::exp(part - max);
            sum += max + std::log(of_participant / weights);
        }
        return sum;
    };
    // One after the other, from what all have in common, until nothing is gained.
    std::vector<ChoiceTable> pooled;
    for (const auto& table : tables) pooled.insert(pooled.end(), table.begin(), table.end());
    const Peak start = highest(0.0, last_place, static_cast<int>(noises),
                               [&](double place) { return bestLapse(pooled, place).value; });
    PopulationFit out{noiseAt(start.at), 0.25, bestLapse(pooled, start.at).at};
    out.log_likelihood = -std::numeric_limits<double>::infinity();
    constexpr int max_rounds = 30;
    constexpr double enough = 1e-5;
    constexpr int points = 7;
    for (int round = 0; round < max_rounds; ++round) {
        const double before = out.log_likelihood;
        const double narrow = std::pow(0.7, round);
        const double place = gridPlace(out.noise_deg);
        out.noise_deg = noiseAt(
            highest(std::max(0.0, place - 12.0 * narrow), std::min(last_place, place + 12.0 * narrow), points,
                    [&](double at) { return logLikelihood(noiseAt(at), out.noise_between, out.lapse_rate); })
                .at);
        out.noise_between =
            highest(std::max(0.0, out.noise_between - narrow), std::min(2.0, out.noise_between + narrow),
                    points,
                    [&](double between) { return logLikelihood(out.noise_deg, between, out.lapse_rate); })
                .at;
        const Peak lapse = highest(
            std::max(0.0, out.lapse_rate - 0.2 * narrow), std::min(1.0, out.lapse_rate + 0.2 * narrow),
            points, [&](double rate) { return logLikelihood(out.noise_deg, out.noise_between, rate); });
        out.lapse_rate = lapse.at;
        out.log_likelihood = lapse.value;
        if (out.log_likelihood - before < enough) break;
    }
    out.aic = 2.0 * 3.0 - 2.0 * out.log_likelihood;
    return out;
}

}  // namespace deixis::studies
