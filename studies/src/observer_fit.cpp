#include "studies/observer_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "normal_probability.hpp"
#include "simulated_choice.hpp"
#include "simulated_observer.hpp"

namespace deixis::studies {

namespace {

constexpr double least_noise_deg = 0.05;
constexpr double most_noise_deg = 40.0;
constexpr std::size_t noises = 96;  // evenly spaced in their logarithm

double noiseAt(double place) {
    const double share = place / static_cast<double>(noises - 1);
    return least_noise_deg * std::pow(most_noise_deg / least_noise_deg, share);
}

double gridPlace(double noise_deg) {
    const double share = std::log(noise_deg / least_noise_deg) / std::log(most_noise_deg / least_noise_deg);
    return std::clamp(share, 0.0, 1.0) * static_cast<double>(noises - 1);
}

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

std::vector<ChoiceTable> tablesOf(std::span<const SeenChoice> choices) {
    std::vector<ChoiceTable> out;
    out.reserve(choices.size());
    for (const SeenChoice& choice : choices) {
        ChoiceTable& table = out.emplace_back();
        table.by_chance = 1.0 / static_cast<double>(choice.balls.size());
        for (std::size_t i = 0; i < noises; ++i)
            table.chosen[i] =
                ballProbability(choice, choice.chosen, radiansFromDegrees(noiseAt(static_cast<double>(i))));
    }
    return out;
}

double logOf(double probability) {
    return std::log(std::max(probability, 1e-300));
}

double logLikelihoodAt(const std::vector<ChoiceTable>& tables, double place, double lapse) {
    double sum = 0.0;
    for (const ChoiceTable& table : tables)
        sum += logOf((1.0 - lapse) * table.at(place) + lapse * table.by_chance);
    return sum;
}

struct Peak {
    double at = 0.0;
    double value = -std::numeric_limits<double>::infinity();
};

/// The highest of evenly spaced points, then by golden section between its neighbours.
template <typename Function>
Peak highest(double low, double high, int points, Function function) {
    Peak best;
    const double step = (high - low) / (points - 1);
    for (int i = 0; i < points; ++i) {
        const double x = low + step * i;
        if (const double y = function(x); y > best.value) best = {x, y};
    }
    double a = std::max(low, best.at - step);
    double b = std::min(high, best.at + step);
    constexpr double golden = 0.6180339887498949;
    constexpr int rounds = 28;
    for (int i = 0; i < rounds; ++i) {
        const double c = b - golden * (b - a);
        const double d = a + golden * (b - a);
        const double at_c = function(c);
        const double at_d = function(d);
        if (at_c > best.value) best = {c, at_c};
        if (at_d > best.value) best = {d, at_d};
        (at_c >= at_d ? b : a) = at_c >= at_d ? d : c;
    }
    return best;
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
    double low = 0.0;
    double high = 1.0;
    if (slope(low) <= 0.0) {
        high = low;
    } else if (slope(high) >= 0.0) {
        low = high;
    } else {
        constexpr int halvings = 45;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (low + high);
            (slope(middle) > 0.0 ? low : high) = middle;
        }
    }
    const double lapse = 0.5 * (low + high);
    return {lapse, logLikelihoodAt(tables, place, lapse)};
}

constexpr double last_place = static_cast<double>(noises - 1);

Peak bestNoise(const std::vector<ChoiceTable>& tables, double lapse) {
    return highest(0.0, last_place, static_cast<int>(noises),
                   [&](double place) { return logLikelihoodAt(tables, place, lapse); });
}

/// Where a profile falls to `wanted` between its peak and `end`; none where it does not.
template <typename Profile>
std::optional<double> crossing(double peak, double end, double wanted, Profile profile) {
    if (profile(end) > wanted) return std::nullopt;
    double above = peak;
    double below = end;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (above + below);
        (profile(middle) > wanted ? above : below) = middle;
    }
    return 0.5 * (above + below);
}

/// Half the quantile of chi-squared with one degree of freedom: how far a profile falls within its interval.
double allowedFall(double level) {
    double low = 0.0;
    double high = 10.0;
    constexpr int halvings = 80;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (2.0 * normalBelow(middle) - 1.0 < level ? low : high) = middle;
    }
    return 0.5 * low * low;
}

}  // namespace

std::optional<SeenChoice> seenChoice(const RecordedTrial& recorded, const ClipSource& clips,
                                     const motion::Skeleton& avatar, const motion::LocalPose& idle_pose,
                                     motion::PointingRay kind, double frame_rate_hz) {
    if (recorded.chosen_place < 0 || recorded.trial.ball_order.size() < 2 || recorded.plays.empty())
        return std::nullopt;
    constexpr double before_s = 0.2;  // of standing still, so that the raise is seen to begin
    const TrialReplay replay(recorded, clips, avatar, idle_pose);
    const RecordedPlay& last = recorded.plays.back();
    const double end_s = last.end_s.value_or(recorded.answered_s);
    GestureObserver observer(avatar, kind);
    const double step_s = 1.0 / frame_rate_hz;
    for (double time_s = last.onset_s - before_s; time_s <= end_s; time_s += step_s)
        observer.see(replay.at(time_s).avatar_joints, time_s);
    SeenChoice out;
    out.ray = observer.gesture().ray;
    if (!(std::abs(glm::length(out.ray.direction) - 1.0) < 1e-6)) return std::nullopt;
    for (int place = 0; place < static_cast<int>(recorded.trial.ball_order.size()); ++place)
        out.balls.push_back(recorded.trial.ball(place));
    out.chosen = static_cast<std::size_t>(recorded.chosen_place);
    return out;
}

double ballProbability(const SeenChoice& seen, std::size_t ball, double noise_rad) {
    // The disturbed ray is direction + x right + y above with x and y the tangents of two normal angles. The
    // ball nearest in angle has the largest cosine with it: against each other ball a half-plane in x and y.
    const AcrossRay across = acrossRay(seen.ray.direction);
    const Vec3 to_ball = glm::normalize(seen.balls[ball] - seen.ray.origin);
    struct HalfPlane {
        double constant, x, y;  // constant + x tan(a) + y tan(b) >= 0
    };
    std::vector<HalfPlane> nearer;
    for (std::size_t i = 0; i < seen.balls.size(); ++i) {
        if (i == ball) continue;
        const Vec3 than = to_ball - glm::normalize(seen.balls[i] - seen.ray.origin);
        nearer.push_back(
            {glm::dot(than, seen.ray.direction), glm::dot(than, across.right), glm::dot(than, across.above)});
    }
    constexpr double step = 0.1;
    constexpr int steps = 50;
    double sum = 0.0;
    double weights = 0.0;
    for (int k = -steps; k <= steps; ++k) {
        const double z = step * k;
        const double a_rad = noise_rad * z;
        if (std::abs(a_rad) >= 0.5 * pi) continue;
        const double weight = std::exp(-0.5 * z * z);
        weights += weight;
        double low_rad = -0.5 * pi;
        double high_rad = 0.5 * pi;
        for (const HalfPlane& plane : nearer) {
            const double rest = plane.constant + plane.x * std::tan(a_rad);
            if (plane.y > 0.0)
                low_rad = std::max(low_rad, std::atan(-rest / plane.y));
            else if (plane.y < 0.0)
                high_rad = std::min(high_rad, std::atan(-rest / plane.y));
            else if (rest < 0.0)
                high_rad = low_rad;
        }
        if (high_rad > low_rad)
            sum += weight * (normalBelow(high_rad / noise_rad) - normalBelow(low_rad / noise_rad));
    }
    return sum / weights;
}

double observerLogLikelihood(std::span<const SeenChoice> choices, double noise_deg, double lapse_rate) {
    double sum = 0.0;
    for (const SeenChoice& choice : choices)
        sum +=
            logOf((1.0 - lapse_rate) * ballProbability(choice, choice.chosen, radiansFromDegrees(noise_deg)) +
                  lapse_rate / static_cast<double>(choice.balls.size()));
    return sum;
}

ObserverFit fitObserver(std::span<const SeenChoice> choices, double level) {
    const std::vector<ChoiceTable> tables = tablesOf(choices);
    const auto by_noise = [&](double place) { return bestLapse(tables, place).value; };
    const auto by_lapse = [&](double lapse) { return bestNoise(tables, lapse).value; };
    const Peak noise = highest(0.0, last_place, static_cast<int>(noises), by_noise);
    const Peak lapse = bestLapse(tables, noise.at);
    const double wanted = noise.value - allowedFall(level);
    const auto inDegrees = [](std::optional<double> place) {
        return place ? std::optional<double>(noiseAt(*place)) : std::nullopt;
    };
    ObserverFit out;
    out.choices = static_cast<int>(choices.size());
    out.noise_deg = {noiseAt(noise.at), inDegrees(crossing(noise.at, 0.0, wanted, by_noise)),
                     inDegrees(crossing(noise.at, last_place, wanted, by_noise))};
    out.lapse_rate = {lapse.at, crossing(lapse.at, 0.0, wanted, by_lapse),
                      crossing(lapse.at, 1.0, wanted, by_lapse)};
    out.log_likelihood = noise.value;
    out.aic = 2.0 * 2.0 - 2.0 * noise.value;
    return out;
}

PopulationFit fitPopulation(std::span<const std::vector<SeenChoice>> by_participant) {
    std::vector<std::vector<ChoiceTable>> tables;
    std::vector<SeenChoice> all;
    for (const auto& choices : by_participant) {
        tables.push_back(tablesOf(choices));
        all.insert(all.end(), choices.begin(), choices.end());
    }
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
            const double most = *std::max_element(parts.begin(), parts.end());
            double of_participant = 0.0;
            for (const double part : parts) of_participant += std::exp(part - most);
            sum += most + std::log(of_participant / weights);
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
    constexpr int most_rounds = 30;
    constexpr double enough = 1e-5;
    constexpr int points = 7;
    for (int round = 0; round < most_rounds; ++round) {
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
