#include "comparisons.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"

namespace deixis::results {

ByTarget byTarget(const SystemEvaluation& system) {
    ByTarget out;
    for (const MeasuredClip* clip : system.clips) {
        if (!clip->accuracy) continue;
        AtTarget& at = out[{clip->target.x, clip->target.y, clip->target.z}];
        at.accuracy.push_back(clip->accuracy->reward);
        at.error_deg.push_back(degreesFromRadians(clip->accuracy->error_rad));
    }
    return out;
}

namespace {

SystemComparison compared(const ByTarget& a, const ByTarget& b) {
    constexpr std::int64_t parts = 1'000'000'000;
    std::vector<double> differences;
    std::vector<double> differences_deg;
    std::vector<Rational> rounded;
    for (const auto& [place, at] : a) {
        const auto other = b.find(place);
        if (other == b.end()) continue;
        differences.push_back(mean(at.accuracy) - mean(other->second.accuracy));
        differences_deg.push_back(mean(at.error_deg) - mean(other->second.error_deg));
        rounded.emplace_back(std::llround(differences.back() * parts), parts);
    }
    SystemComparison out;
    out.mean_difference = mean(differences);
    out.sd = sampleSd(differences);
    out.mean_difference_deg = mean(differences_deg);
    out.test = signedRankTest(rounded);
    out.differences = std::move(differences);
    return out;
}

}  // namespace

std::vector<SystemComparison> compareSystems(const std::vector<SystemEvaluation>& systems) {
    std::vector<ByTarget> targets;
    targets.reserve(systems.size());
    for (const SystemEvaluation& system : systems) targets.push_back(byTarget(system));
    std::vector<SystemComparison> out;
    std::vector<double> p;
    for (std::size_t a = 0; a < systems.size(); ++a)
        for (std::size_t b = a + 1; b < systems.size(); ++b) {
            SystemComparison& pair = out.emplace_back(compared(targets[a], targets[b]));
            pair.a = a;
            pair.b = b;
            p.push_back(pair.test.n_pairs > 0 ? pair.test.p_two_sided
                                              : std::numeric_limits<double>::quiet_NaN());
        }
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i].test.n_pairs > 0) out[i].p_holm = adjusted[i];
    return out;
}

}  // namespace deixis::results
