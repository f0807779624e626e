#include "results/analysis/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/files.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::json;

struct Sum {
    double sum = 0.0;
    int n = 0;
    void add(double value) {
        sum += value;
        ++n;
    }
    [[nodiscard]] double mean() const { return sum / n; }
};

SpearmanTest test(const std::vector<std::pair<double, double>>& pairs) {
    std::vector<double> x, y;
    for (const auto& [objective, answered] : pairs) {
        x.push_back(objective);
        y.push_back(answered);
    }
    return spearman(std::span<const double>(x), std::span<const double>(y));
}

}  // namespace

Result<ObjectiveAccuracy> readObjectiveAccuracy(const std::filesystem::path& file) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const Json json = Json::parse(*text, nullptr, false);
    const std::string expected = "Expected the JSON that 'deixis evaluate ... --json FILE' writes";
    if (!json.is_object() || json.value("format", Json()) != "deixis-evaluation")
        return fail(file.string(), "is no objective evaluation", expected);
    ObjectiveAccuracy out{file.string()};
    try {
        for (const Json& system : json.at("systems"))
            if (const Json& mean = system.at("accuracy").at("mean"); !mean.is_null())
                out.systems[system.at("system")] = mean;
        for (const Json& target : json.at("targets")) {
            const std::string id = target.at("target_id");
            const Json& at = target.at("target");
            out.positions_m[id] = {at.at(0), at.at(1), at.at(2)};
            if (!target.contains("accuracy"))
                return fail(file.string(), "was written by an earlier program: it has no accuracy by target",
                            "Evaluate the clips again");
            for (const auto& [system, accuracy] : target["accuracy"].items())
                out.targets[system][id] = accuracy;
        }
    } catch (const Json::exception& problem) {
        return fail(file.string(), fmt::format("is damaged: {}", problem.what()), expected);
    }
    return out;
}

Result<void> checkSameClips(const ObjectiveAccuracy& objective, const ResponseTable& table) {
    if (std::ranges::none_of(table.systems,
                             [&](const std::string& system) { return objective.systems.contains(system); })) {
        std::vector<std::string> evaluated;
        for (const auto& [system, mean] : objective.systems) evaluated.push_back(system);
        return fail(objective.file,
                    fmt::format("has the systems {}; the answers are about {}", fmt::join(evaluated, ", "),
                                fmt::join(table.systems, ", ")),
                    "Evaluate the clips of the study's systems, under the names that they have there");
    }
    const auto check = [&](const std::string& target, const Vec3& position) -> Result<void> {
        const auto found = objective.positions_m.find(target);
        constexpr double same_m = 0.001;
        if (found == objective.positions_m.end() || glm::distance(found->second, position) <= same_m)
            return {};
        return fail(objective.file,
                    fmt::format("has the target {} at ({:.3f}, {:.3f}, {:.3f}), the study at ({:.3f}, "
                                "{:.3f}, {:.3f})",
                                target, found->second.x, found->second.y, found->second.z, position.x,
                                position.y, position.z),
                    "Evaluate clips for the targets that 'deixis targets' prints for this study");
    };
    for (const ChoiceRow& choice : table.choices)
        if (auto same = check(choice.target_id, choice.balls[static_cast<std::size_t>(choice.target_place)]);
            !same)
            return same;
    for (const auto& [target, position] : table.target_positions)
        if (auto same = check(target, position); !same) return same;
    return {};
}

std::vector<ObjectiveCorrelation> correlate(const ObjectiveAccuracy& objective, const ResponseTable& table) {
    std::vector<ObjectiveCorrelation> out;
    for (const Measure& measure : table.measures) {
        if (measure.kind == MeasureKind::preference) continue;
        std::map<std::string, Sum> systems;
        std::map<std::string, std::map<std::string, Sum>> targets;
        for (const ResponseRow& row : table.rows) {
            if (row.measure != measure.name) continue;
            systems[row.system].add(row.value);
            targets[row.system][row.target_id].add(row.value);
        }
        std::vector<std::pair<double, double>> means;
        for (const auto& [system, answers] : systems)
            if (const auto found = objective.systems.find(system); found != objective.systems.end())
                means.emplace_back(found->second, answers.mean());
        out.push_back({measure.name, "systems", "", test(means)});
        for (const std::string& system : table.systems) {
            const auto evaluated = objective.targets.find(system);
            if (evaluated == objective.targets.end()) continue;
            std::vector<std::pair<double, double>> pairs;
            for (const auto& [target, answers] : targets[system])
                if (const auto found = evaluated->second.find(target); found != evaluated->second.end())
                    pairs.emplace_back(found->second, answers.mean());
            out.push_back({measure.name, "targets", system, test(pairs)});
        }
    }
    return out;
}

}  // namespace deixis::results
