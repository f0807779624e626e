#include <fmt/format.h>

#include <map>

#include "learning/amp/training.hpp"
#include "physics/policy/amp_system.hpp"

namespace deixis::learning {

namespace {

using motion::NetworkWeights;

/// What differs between two parts although it must not; empty: nothing.
std::string difference(NetworkWeights a, NetworkWeights b) {
    for (NetworkWeights* one : {&a, &b}) one->settings.erase("only_cluster");
    if (a.training_data_sha256 != b.training_data_sha256) return "demonstrations";
    if (a.seed != b.seed) return "seeds";
    for (const auto& [key, value] : a.settings)
        if (const auto other = b.settings.find(key); other == b.settings.end() || other->second != value)
            return "settings (" + key + ")";
    return a.settings.size() == b.settings.size() ? "" : "settings";
}

bool isPolicy(const motion::NamedArray& array) {
    return array.name.starts_with("policy");
}

}  // namespace

Result<void> joinAmp(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& file) {
    std::map<int, NetworkWeights> by_cluster;
    int count = 1;
    for (const auto& path : parts) {
        auto read = motion::readWeights(path, physics::amp_architecture);
        if (!read) return tl::unexpected(read.error());
        const auto clusters = read->count("clusters", 1, 100'000);
        if (!clusters) return tl::unexpected(clusters.error());
        if (!read->settings.contains("only_cluster"))
            return fail(path.string(), "these weights are whole already, expected those of one cluster");
        const auto cluster = read->count("only_cluster", 0, *clusters - 1);
        if (!cluster) return tl::unexpected(cluster.error());
        count = *clusters;
        if (by_cluster.contains(*cluster))
            return fail(path.string(),
                        fmt::format("cluster {} is also in {}", *cluster, by_cluster[*cluster].file));
        if (!by_cluster.empty())
            if (const auto& first = by_cluster.begin()->second; !difference(first, *read).empty())
                return fail(path.string(), fmt::format("its {} are others than those of {}",
                                                       difference(first, *read), first.file));
        by_cluster.emplace(*cluster, std::move(*read));
    }
    for (int cluster = 0; cluster < count; ++cluster)
        if (!by_cluster.contains(cluster))
            return fail(file.string(), fmt::format("cluster {} of {} is missing", cluster, count));
    NetworkWeights out = by_cluster.at(0);
    out.settings.erase("only_cluster");
    std::erase_if(out.arrays, isPolicy);
    for (auto& [name, value] : out.metrics) value = 0.0;
    for (const auto& [cluster, part] : by_cluster) {
        for (const auto& array : part.arrays)
            if (isPolicy(array)) out.arrays.push_back(array);
        for (auto& [name, value] : out.metrics)
            if (const auto of_part = part.metrics.find(name); of_part != part.metrics.end())
                value += of_part->second / count;
    }
    return motion::writeWeights(file, out, motion::WeightsPrecision::float16);
}

}  // namespace deixis::learning
