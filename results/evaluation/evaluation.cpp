#include "results/evaluation/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "comparisons.hpp"
#include "observers.hpp"
#include "results/page/figure.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

std::vector<double> coordinates(const Vec3& point) {
    return {point.x, point.y, point.z};
}

Points coordinatesOf(const std::vector<Vec3>& points) {
    Points out;
    out.reserve(points.size());
    for (const Vec3& point : points) out.push_back(coordinates(point));
    return out;
}

using Place = std::tuple<double, double, double>;
Place place(const Vec3& target) {
    return {target.x, target.y, target.z};
}

HandProfile profileOf(const std::vector<const MeasuredClip*>& clips, motion::Side hand) {
    HandProfile profile;
    std::map<int, std::pair<std::vector<double>, std::vector<double>>> by_step;
    for (const MeasuredClip* clip : clips) {
        if (clip->hand != hand) continue;
        ++profile.clips;
        for (std::size_t i = 0; i < clip->profile.reward.size(); ++i) {
            auto& [rewards, speeds] = by_step[clip->profile.first_step + static_cast<int>(i)];
            rewards.push_back(clip->profile.reward[i]);
            speeds.push_back(clip->profile.speed_m_s[i]);
        }
    }
    for (const auto& [step, values] : by_step) {
        const auto& [rewards, speeds] = values;
        if (2 * static_cast<int>(rewards.size()) < profile.clips) continue;
        profile.points.push_back({step * profile_step_s, static_cast<int>(rewards.size()), mean(rewards),
                                  sampleSd(rewards), mean(speeds), sampleSd(speeds)});
    }
    return profile;
}

Result<GaussianDensity> densityOf(const EvaluationInput& input) {
    auto density =
        std::holds_alternative<BandwidthRule>(input.bandwidth)
            ? GaussianDensity::fit(coordinatesOf(input.training), std::get<BandwidthRule>(input.bandwidth))
            : GaussianDensity::fit(coordinatesOf(input.training),
                                   std::get<std::vector<double>>(input.bandwidth));
    if (density) return density;
    Error error = density.error();
    error.where = input.training_source;
    return tl::unexpected(std::move(error));
}

std::size_t nearestTraining(const std::vector<Vec3>& training, const Vec3& target) {
    const auto nearest = std::min_element(
        training.begin(), training.end(),
        [&](const Vec3& a, const Vec3& b) { return glm::length(a - target) < glm::length(b - target); });
    return static_cast<std::size_t>(nearest - training.begin());
}

/// Fills `clusters`, and the clusters of the points.
Result<void> findClusters(Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    const Points training = coordinatesOf(input.training);
    evaluation.mean_shift_estimated = !input.mean_shift_bandwidth;
    evaluation.mean_shift_bandwidth = input.mean_shift_bandwidth.value_or(estimateBandwidth(training));
    const auto found = meanShift(training, evaluation.mean_shift_bandwidth);
    if (!found)
        return fail(input.training_source,
                    "no bandwidth for MeanShift can be estimated: neighbouring targets coincide",
                    "Give --meanshift-bandwidth");
    for (const auto& centre : found->centres)
        evaluation.clusters.push_back({Vec3(centre[0], centre[1], centre[2]), 0, 0});
    for (const int label : found->labels)
        ++evaluation.clusters[static_cast<std::size_t>(label)].training_targets;
    for (TestPoint& point : evaluation.points) {
        point.cluster = found->labels[nearestTraining(input.training, point.target)];
        ++evaluation.clusters[static_cast<std::size_t>(point.cluster)].test_points;
    }
    return {};
}

/// To nine significant digits, so that what is equal on paper is tied: targets that mirror each other have
/// the same density but for the last bits, and their clips the same accuracy.
std::vector<double> tied(std::vector<double> values) {
    for (double& value : values) value = rounded(value, 9);
    return values;
}

void addClip(SystemEvaluation& system, const MeasuredClip& clip, double density) {
    system.clips.push_back(&clip);
    system.left_hand += clip.hand == motion::Side::left;
    system.phases_found += !clip.phases_given;
    system.placed += clip.placed;
    system.away += clip.away;
    if (!clip.accuracy) {
        ++system.missing;
        return;
    }
    system.rewards.push_back(clip.accuracy->reward);
    system.errors_deg.push_back(degreesFromRadians(clip.accuracy->error_rad));
    system.densities.push_back(density);
}

/// Mean accuracy of a system in each cluster; `points` by place.
void meansByCluster(SystemEvaluation& system, const std::map<Place, TestPoint*>& points,
                    std::size_t clusters) {
    std::vector<std::vector<double>> rewards(clusters);
    for (const MeasuredClip* clip : system.clips)
        if (clip->accuracy)
            rewards[static_cast<std::size_t>(points.at(place(clip->target))->cluster)].push_back(
                clip->accuracy->reward);
    for (const auto& values : rewards)
        system.cluster_means.push_back(values.empty() ? std::optional<double>() : mean(values));
}

void addRemarks(Evaluation& evaluation) {
    auto& remarks = evaluation.remarks;
    const auto clips = [](int n) { return fmt::format("{} clip{}", n, n == 1 ? "" : "s"); };
    if (const int n = evaluation.input.without_target; n > 0)
        remarks.push_back(fmt::format("{} of the manifests point{} at nothing (no target) and {} left out.",
                                      clips(n), n == 1 ? "s" : "", n == 1 ? "is" : "are"));
    for (const SystemEvaluation& system : evaluation.systems) {
        if (system.missing > 0)
            remarks.push_back(
                fmt::format("{}: {} of {} ha{} no accuracy: no gesture was found, or the hand moves at {:g} "
                            "m/s or faster in every frame of the window.",
                            system.system, clips(system.missing), system.clips.size(),
                            system.missing == 1 ? "s" : "ve", evaluation.input.rule.slower_than_m_s));
        if (system.phases_found > 0)
            remarks.push_back(
                fmt::format("{}: the manifest gives no phases for {}; hand and time of pointing were "
                            "detected from the movement.",
                            system.system, clips(system.phases_found)));
        if (system.placed > 0)
            remarks.push_back(
                fmt::format("{}: {} {} placed at the origin, facing ahead, by the first frame, since the "
                            "target is given relative to the figure.",
                            system.system, clips(system.placed), system.placed == 1 ? "was" : "were"));
        if (system.away > 0)
            remarks.push_back(
                fmt::format("{}: {} begin{} half a metre or more from the origin, or {} away from it; the "
                            "targets are assumed to be given in the clips' coordinates.",
                            system.system, clips(system.away), system.away == 1 ? "s" : "",
                            system.away == 1 ? "faces" : "face"));
    }
    std::set<std::set<Place>> sets;
    for (const SystemEvaluation& system : evaluation.systems) {
        std::set<Place> places;
        for (const MeasuredClip* clip : system.clips) places.insert(place(clip->target));
        sets.insert(std::move(places));
    }
    if (sets.size() > 1)
        remarks.emplace_back(
            "The systems' clips were not made for the same targets: their accuracies are for different "
            "places.");
}

}  // namespace

Result<Evaluation> evaluate(EvaluationInput given) {
    if (given.clips.empty())
        return fail("", "there is no clip with a target to evaluate",
                    "Accuracy needs the columns target_x, target_y and target_z of the manifest");
    Evaluation evaluation;
    evaluation.input = std::move(given);
    const EvaluationInput& input = evaluation.input;
    const auto density = densityOf(input);
    if (!density) return tl::unexpected(density.error());
    evaluation.bandwidths = density->bandwidths();
    evaluation.bandwidth_rule = std::holds_alternative<BandwidthRule>(input.bandwidth)
                                    ? std::string(bandwidthRuleName(std::get<BandwidthRule>(input.bandwidth)))
                                    : "given";

    std::set<Place> seen;
    for (const MeasuredClip& clip : input.clips)
        if (seen.insert(place(clip.target)).second)
            evaluation.points.push_back(
                {clip.target_id, clip.target, (*density)(coordinates(clip.target)), 0});
    if (auto clustered = findClusters(evaluation); !clustered) return tl::unexpected(clustered.error());
    std::map<Place, TestPoint*> points;
    for (TestPoint& point : evaluation.points) points[place(point.target)] = &point;

    std::map<std::string, std::size_t> indices;
    for (const MeasuredClip& clip : input.clips) {
        const auto [at, fresh] = indices.emplace(clip.system, evaluation.systems.size());
        if (fresh) {
            SystemEvaluation system;
            system.system = clip.system;
            system.synthetic = input.synthetic_systems.contains(clip.system);
            evaluation.systems.push_back(std::move(system));
        }
        addClip(evaluation.systems[at->second], clip, points.at(place(clip.target))->density);
    }
    for (SystemEvaluation& system : evaluation.systems) {
        system.correlation = spearman(tied(system.rewards), tied(system.densities));
        system.left = profileOf(system.clips, motion::Side::left);
        system.right = profileOf(system.clips, motion::Side::right);
        meansByCluster(system, points, evaluation.clusters.size());
    }
    evaluation.comparisons = compareSystems(evaluation.systems);
    addRemarks(evaluation);
    if (auto read = readGames(evaluation); !read) return tl::unexpected(read.error());
    return evaluation;
}

}  // namespace deixis::results
