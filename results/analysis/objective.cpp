#include "results/analysis/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "results/analysis/analysis_steps.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/tables/written_json.hpp"

namespace deixis::results {

namespace {

using NumberPairs = std::vector<std::pair<double, double>>;  ///< Equation 2 and mean answers

SpearmanTest rankTest(const NumberPairs& pairs) {
    std::vector<double> x, y;
    for (const auto& [objective, answered] : pairs) {
        x.push_back(objective);
        y.push_back(answered);
    }
    return spearman(std::span<const double>(x), std::span<const double>(y));
}

}  // namespace

Result<ObjectiveAccuracy> readObjectiveAccuracy(const std::filesystem::path& file) {
    ObjectiveAccuracy out{file.string()};
    const auto read = readWritten(file, writtenEvaluation(), [&](const Json& json) -> Result<void> {
        for (const Json& system : json.at("systems"))
            if (const Json& mean = system.at("accuracy").at("mean"); !mean.is_null())
                out.systems[system.at("system")] = mean;
        for (const Json& target : json.at("targets")) {
            const std::string id = target.at("target_id");
            const Json& at = target.at("target");
            if (!out.positions_m.emplace(id, Vec3(at.at(0), at.at(1), at.at(2))).second)
                return fail(file.string(), fmt::format("has two targets named {}", id),
                            "Evaluate the clips of one study alone");
            if (!target.contains("accuracy"))
                return fail(file.string(), "was written by an earlier program: it has no accuracy by target",
                            "Evaluate the clips again");
            for (const auto& [system, accuracy] : target["accuracy"].items())
                out.targets[system][id] = accuracy;
        }
        return {};
    });
    if (!read) return tl::unexpected(read.error());
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

void compareWithObjective(AnalysisResult& result) {
    if (!result.options.objective) return;
    const ObjectiveAccuracy& objective = *result.options.objective;
    auto& [all_means, correlations] = result.objective;
    for (std::size_t m = 0; m < result.measures.size(); ++m) {
        const std::string& measure = result.measures[m].name;
        NumberPairs means;
        for (const SystemResult& system : result.systems) {
            const auto found = objective.systems.find(system.system);
            if (found == objective.systems.end() || system.measures[m].n == 0) continue;
            all_means.push_back({measure, system.system, found->second, system.measures[m].mean});
            means.emplace_back(found->second, system.measures[m].mean);
        }
        correlations.push_back({measure, "systems", "", rankTest(means)});
        std::map<std::string, std::map<std::string, std::vector<double>>> answers;  // by system and target
        for (const ResponseRow& row : result.table.rows)
            if (row.measure == measure) answers[row.system][row.target_id].push_back(row.value);
        for (const std::string& system : result.table.systems) {
            const auto evaluated = objective.targets.find(system);
            if (evaluated == objective.targets.end()) continue;
            NumberPairs pairs;
            for (const auto& [target, values] : answers[system])
                if (const auto found = evaluated->second.find(target); found != evaluated->second.end())
                    pairs.emplace_back(found->second, mean(values));
            correlations.push_back({measure, "targets", system, rankTest(pairs)});
        }
    }
}

}  // namespace deixis::results
