// Factors within participants.
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

/// The rows of one measure by the levels of a factor: of each system, and of all.
struct LevelCells {
    std::map<std::string, Cells> by_system;
    Cells of_all;
    std::vector<std::string> levels;  ///< that have answers, in the factor's order
    bool nested = true;               ///< in the systems: each has one level
};

LevelCells levelCells(const ResponseTable& table, const std::string& measure, const Factor& factor) {
    LevelCells cells;
    for (const auto& row : table.rows) {
        if (row.measure != measure) continue;
        const std::string level = levelOf(table, row, factor.name);
        if (level.empty()) continue;
        cells.by_system[row.system][level][row.participant].push_back(row.value);
        cells.of_all[level][row.participant].push_back(row.value);
    }
    for (const std::string& level : factor.levels)
        if (cells.of_all.contains(level)) cells.levels.push_back(level);
    for (const auto& [system, levels] : cells.by_system) cells.nested = cells.nested && levels.size() == 1;
    return cells;
}

void addLevels(const Measure& measure, const std::string& factor, LevelCells& cells, AnalysisResult& result) {
    const auto add = [&](const std::string& system, const Cells& of_system) {
        for (const auto& level : cells.levels) {
            const auto trials = allTrials(of_system, level);
            result.levels.push_back({measure.name,
                                     factor,
                                     system,
                                     level,
                                     mean(trials),
                                     sampleSd(trials),
                                     static_cast<int>(trials.size()),
                                     {}});
        }
    };
    add("all", cells.of_all);
    for (const auto& system : result.table.systems) add(system, cells.by_system[system]);
}

/// All pairs of levels within each system, or over all systems where each has one level: one family.
void testLevels(const Measure& measure, const std::string& factor, LevelCells& cells,
                AnalysisResult& result) {
    const std::size_t family = result.level_tests.size();
    std::map<std::string, Means> means;  // by system
    const auto add = [&](const std::string& system, const Cells& of_system) {
        means[system] = exactMeans(of_system);
        for (std::size_t i = 0; i < cells.levels.size(); ++i)
            for (std::size_t j = i + 1; j < cells.levels.size(); ++j) {
                Comparison& pair = result.level_tests.emplace_back();
                pair.measure = measure.name;
                pair.factor = factor;
                pair.system = system;
                pair.a = cells.levels[i];
                pair.b = cells.levels[j];
            }
    };
    const bool over_systems = cells.nested && cells.levels.size() > 1;
    if (over_systems)
        add("all", cells.of_all);
    else
        for (const auto& system : result.table.systems) add(system, cells.by_system[system]);
    std::size_t participants = 0;
    for (const auto& [system, of_system] : means)
        participants = std::max(participants, maxParticipants(of_system));
    forTests(result.level_tests.size() - family, participants, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = family + from; i < family + to; ++i) {
            Comparison& pair = result.level_tests[i];
            testDifferences(pair, means.at(pair.system), result.level, measure.equivalence_bound);
        }
    });
    adjustFrom(result.level_tests, family,
               fmt::format("{}: {} {} systems", measure.name, factor, over_systems ? "over" : "within"),
               result.alpha);
}

}  // namespace

void compareLevels(AnalysisResult& result) {
    for (const Factor& factor : withinFactors(result.table))
        for (const Measure& measure : result.measures) {
            LevelCells cells = levelCells(result.table, measure.name, factor);
            // Accuracy by layout is reported for one layout, too (the paper's Table 1).
            const std::size_t needed = measure.kind == MeasureKind::accuracy ? 1 : 2;
            if (cells.levels.size() < needed) continue;
            addLevels(measure, factor.name, cells, result);
            testLevels(measure, factor.name, cells, result);
        }
}

void describeLevels(AnalysisResult& result) {
    if (result.levels.empty()) return;
    std::vector<Summary*> summaries;
    for (const Factor& factor : withinFactors(result.table))
        for (const Measure& measure : result.measures) {
            LevelCells cells = levelCells(result.table, measure.name, factor);
            for (LevelResult& row : result.levels) {
                if (row.factor != factor.name || row.measure != measure.name) continue;
                row.over_participants =
                    summarise(row.system == "all" ? cells.of_all : cells.by_system[row.system], row.level);
                summaries.push_back(&row.over_participants);
            }
        }
    addIntervals(summaries, {result.options.resamples, result.options.seed, result.level});
}

}  // namespace deixis::results
