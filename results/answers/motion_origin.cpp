#include "results/answers/motion_origin.hpp"

#include <algorithm>

namespace deixis::results {

namespace {

/// Words of a manifest's column `processing` (docs/manifest.md), several of which are joined by ", ".
bool says(const std::string& processing, const std::string& word) {
    return (", " + processing + ", ").find(", " + word + ", ") != std::string::npos;
}

}  // namespace

std::string motionText(const ResponseTable& table, const std::string& system) {
    const bool built_in = std::ranges::find(table.built_in_systems, system) != table.built_in_systems.end();
    if (!table.processing) return built_in ? "synthetic or learned from synthetic" : "";
    const auto told = table.processing->find(system);
    const std::string processing = told == table.processing->end() ? "" : told->second;
    if (says(processing, "learned-from-synthetic")) return "learned from synthetic";
    return built_in || says(processing, "synthetic") ? "synthetic" : "";
}

std::vector<std::pair<std::string, std::string>> syntheticSystems(const ResponseTable& table) {
    std::vector<std::pair<std::string, std::string>> out;
    const auto add = [&](const std::string& system) {
        const auto known = std::ranges::find(out, system, &std::pair<std::string, std::string>::first);
        if (std::string motion = motionText(table, system); known == out.end() && !motion.empty())
            out.emplace_back(system, std::move(motion));
    };
    for (const std::string& system : table.systems)
        if (!table.not_compared.contains(system)) add(system);
    for (const auto& [system, remark] : table.not_compared) add(system);
    return out;
}

}  // namespace deixis::results
