#include "learning/amp/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "results/statistics/density.hpp"
#include "results/statistics/mean_shift.hpp"

namespace deixis::learning {

namespace {

std::vector<std::vector<double>> rowsOf(const std::vector<Vec3>& points) {
    std::vector<std::vector<double>> out;
    for (const Vec3& one : points) out.push_back({one.x, one.y, one.z});
    return out;
}

/// The cluster of each target.
std::vector<int> shifted(const std::vector<Vec3>& targets_m, double bandwidth_m) {
    const auto clusters = results::meanShift(rowsOf(targets_m), bandwidth_m);
    return clusters ? clusters->labels : std::vector<int>();
}

int countOf(const std::vector<int>& clusters) {
    return clusters.empty() ? 0 : std::ranges::max(clusters) + 1;
}

std::vector<int> joined(const std::vector<motion::Demonstration>& demonstrations,
                        const std::vector<Vec3>& targets_m, const std::vector<int>& clusters) {
    std::vector<int> out;
    for (const motion::Demonstration& one : demonstrations) {
        const auto nearest = std::ranges::min_element(
            targets_m, {}, [&](const Vec3& target_m) { return glm::distance(target_m, one.target); });
        out.push_back(clusters[static_cast<std::size_t>(nearest - targets_m.begin())]);
    }
    return out;
}

/// The paper's, else the widest that gives so many clusters.
Result<double> bandwidthFor(const std::vector<Vec3>& targets_m, int count) {
    if (countOf(shifted(targets_m, paper_bandwidth_m)) == count) return paper_bandwidth_m;
    for (int cm = 300; cm > 0; --cm)
        if (countOf(shifted(targets_m, cm / 100.0)) == count) return cm / 100.0;
    return fail("clusters",
                fmt::format("no bandwidth makes {} clusters of {} targets", count, targets_m.size()),
                "Another number of clusters may exist");
}

}  // namespace

Result<double> scottBandwidth_m(const std::vector<Vec3>& points) {
    const auto density = results::GaussianDensity::fit(rowsOf(points), results::BandwidthRule::scott);
    if (!density) return tl::unexpected(density.error());
    const auto& axes = density->bandwidths();
    return (axes[0] + axes[1] + axes[2]) / 3.0;
}

Result<AmpClusters> clustersOf(const DemonstrationSets& data, std::optional<int> count,
                               std::optional<double> bandwidth_m) {
    AmpClusters out;
    if (!bandwidth_m && count.value_or(1) == 1) {
        out.training.assign(data.training.size(), 0);
        out.validation.assign(data.validation.size(), 0);
        return out;
    }
    const auto bandwidth = bandwidth_m ? Result<double>(*bandwidth_m) : bandwidthFor(data.targets_m, *count);
    if (!bandwidth) return tl::unexpected(bandwidth.error());
    out.bandwidth_m = *bandwidth;
    const std::vector<int> clusters = shifted(data.targets_m, *bandwidth);
    out.count = countOf(clusters);
    if (out.count != count.value_or(out.count))
        return fail("clusters",
                    fmt::format("a bandwidth of {:.3g} m makes {} clusters of {} targets, expected {}",
                                *bandwidth, out.count, data.targets_m.size(), *count));
    out.training = joined(data.training, data.targets_m, clusters);
    out.validation = joined(data.validation, data.targets_m, clusters);
    for (int cluster = 0; cluster < out.count; ++cluster)
        if (std::ranges::find(out.training, cluster) == out.training.end())
            return fail("clusters",
                        fmt::format("with a bandwidth of {} m, all demonstrations of cluster {} are held out",
                                    *bandwidth, cluster),
                        "Fewer clusters, or more demonstrations, leave some to train on");
    return out;
}

}  // namespace deixis::learning
