// The weights of two cues with noise and lapses, fitted together.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "profile_likelihood.hpp"
#include "studies/observers/observer_cues.hpp"
#include "studies/simulation/observer_fit.hpp"

namespace deixis::studies {

namespace {

/// Noise as a share of what is tried, lapse rate, eye_line_share, visual_weight; each in [0, 1].
using Point = std::array<double, 4>;
constexpr std::size_t dimensions = std::tuple_size_v<Point>;

ObserverModel modelAt(const Point& point) {
    ObserverModel model;
    model.noise_rad = radiansFromDegrees(noiseAt(point[0] * last_place));
    model.lapse_rate = point[1];
    model.eye_line_share = point[2];
    model.visual_weight = point[3];
    return model;
}

struct Corner {
    Point at{};
    double value = 0.0;
};

/// Nelder and Mead's simplex, uphill from a point, within [0, 1]; `fixed` (none: dimensions) keeps its value.
template <typename Function>
Corner climbed(const Point& from, std::size_t fixed, double size, Function function) {
    const auto within = [](Point point) {
        for (double& one : point) one = std::clamp(one, 0.0, 1.0);
        return Corner{point, 0.0};
    };
    const auto valued = [&](const Point& point) {
        Corner corner = within(point);
        corner.value = function(corner.at);
        return corner;
    };
    std::vector<Corner> corners{valued(from)};
    for (std::size_t i = 0; i < dimensions; ++i) {
        if (i == fixed) continue;
        Point moved = from;
        moved[i] += moved[i] < 0.5 ? size : -size;
        corners.push_back(valued(moved));
    }
    const auto better = [](const Corner& a, const Corner& b) { return a.value > b.value; };
    constexpr int max_steps = 400;
    constexpr double enough = 1e-5;
    for (int step = 0; step < max_steps; ++step) {
        std::stable_sort(corners.begin(), corners.end(), better);
        Corner& worst = corners.back();
        double widest = 0.0;
        for (std::size_t i = 0; i < dimensions; ++i)
            widest = std::max(widest, std::abs(worst.at[i] - corners.front().at[i]));
        if (corners.front().value - worst.value < enough && widest < 2e-3) break;
        Point centre{};
        for (std::size_t c = 0; c + 1 < corners.size(); ++c)
            for (std::size_t i = 0; i < dimensions; ++i)
                centre[i] += corners[c].at[i] / static_cast<double>(corners.size() - 1);
        const auto along = [&](double share) {
            Point point{};
            for (std::size_t i = 0; i < dimensions; ++i)
                point[i] = centre[i] + share * (worst.at[i] - centre[i]);
            return valued(point);
        };
        const Corner reflected = along(-1.0);
        if (better(reflected, corners.front())) {
            const Corner expanded = along(-2.0);
            worst = better(expanded, reflected) ? expanded : reflected;
        } else if (better(reflected, corners[corners.size() - 2])) {
            worst = reflected;
        } else {
            const Corner contracted = along(better(reflected, worst) ? -0.5 : 0.5);
            if (better(contracted, worst)) {
                worst = contracted;
            } else {
                for (std::size_t c = 1; c < corners.size(); ++c) {
                    Point point = corners[c].at;
                    for (std::size_t i = 0; i < dimensions; ++i)
                        point[i] = 0.5 * (point[i] + corners.front().at[i]);
                    corners[c] = valued(point);
                }
            }
        }
    }
    return *std::max_element(corners.begin(), corners.end(),
                             [&](const Corner& a, const Corner& b) { return better(b, a); });
}

}  // namespace

ObserverFit fitWeights(std::span<const SeenChoice> choices, const ObserverModel& model, double level) {
    std::vector<Cues> cues;
    cues.reserve(choices.size());
    for (const SeenChoice& seen : choices) cues.push_back(cuesOf(seen.arm, seen.balls));
    // observerLogLikelihood(), with the lines' angles available.
    const auto logLikelihood = [&](const Point& point) {
        const ObserverModel at = modelAt(point);
        double sum = 0.0;
        for (std::size_t i = 0; i < choices.size(); ++i)
            sum += logOf((1.0 - at.lapse_rate) * cueChance(at, cues[i], choices[i].chosen) +
                         at.lapse_rate / static_cast<double>(choices[i].balls.size()));
        return sum;
    };
    const double start_noise = gridPlace(degreesFromRadians(model.noise_rad)) / last_place;
    Corner best{{start_noise, 0.05, 0.5, 0.5}, -std::numeric_limits<double>::infinity()};
    // From several places, so that a ridge on the way does not decide.
    for (const double eye_line : {0.15, 0.5, 0.85})
        for (const double noise : {start_noise, std::min(1.0, start_noise + 0.15)}) {
            const Corner found = climbed({noise, 0.05, eye_line, 0.5}, dimensions, 0.15, logLikelihood);
            if (found.value > best.value) best = found;
        }
    best = climbed(best.at, dimensions, 0.05, logLikelihood);

    const double wanted = best.value - allowedFall(level);
    constexpr double tolerance = 1e-4;
    const auto fitted = [&](std::size_t which) {
        // Each step continues from the best of the one before.
        const auto end = [&](double last) {
            Point from = best.at;
            return crossing(best.at[which], last, wanted, tolerance, [&](double value) {
                Point at = from;
                at[which] = value;
                const Corner profile = climbed(at, which, 0.05, logLikelihood);
                if (profile.value > wanted) from = profile.at;
                return profile.value;
            });
        };
        return FittedParameter{best.at[which], end(0.0), end(1.0)};
    };
    const auto inDegrees = [](std::optional<double> share) {
        return share ? std::optional<double>(noiseAt(*share * last_place)) : std::nullopt;
    };
    ObserverFit out;
    out.choices = static_cast<int>(choices.size());
    const FittedParameter noise = fitted(0);
    out.noise_deg = {noiseAt(noise.value * last_place), inDegrees(noise.lower), inDegrees(noise.upper)};
    out.lapse_rate = fitted(1);
    out.eye_line_share = fitted(2);
    out.visual_weight = fitted(3);
    out.log_likelihood = best.value;
    out.aic = 2.0 * static_cast<double>(dimensions) - 2.0 * best.value;
    return out;
}

}  // namespace deixis::studies
