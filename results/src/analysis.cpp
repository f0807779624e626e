#include "results/analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis_details.hpp"
#include "analysis_remarks.hpp"
#include "analysis_tests.hpp"
#include "results/descriptive.hpp"

namespace deixis::results {

namespace {

std::vector<double> participantMeans(const Cells& cells, const std::string& condition) {
    std::vector<double> means;
    if (const auto cell = cells.find(condition); cell != cells.end())
        for (const auto& [participant, scores] : cell->second) means.push_back(mean(scores));
    return means;
}

std::vector<double> allTrials(const Cells& cells, const std::string& condition) {
    std::vector<double> trials;
    if (const auto cell = cells.find(condition); cell != cells.end())
        for (const auto& [participant, scores] : cell->second)
            trials.insert(trials.end(), scores.begin(), scores.end());
    return trials;
}

/// Of participants' means, resampling participants.
std::optional<BootstrapInterval> meanInterval(const std::vector<double>& means,
                                              const AnalysisOptions& options) {
    if (means.size() < 2) return std::nullopt;
    std::vector<std::vector<double>> rows;
    rows.reserve(means.size());
    for (const double value : means) rows.push_back({value});
    const auto made = bootstrapMeans(rows, {options.resamples, options.seed, options.level});
    return made.front().bca ? made.front().bca : made.front().percentile;
}

Summary summarise(const Cells& cells, const std::string& system, const AnalysisOptions& options) {
    const auto means = participantMeans(cells, system);
    const auto trials = allTrials(cells, system);
    return {mean(means),
            sampleSd(means),
            sampleSd(trials),
            static_cast<int>(trials.size()),
            means,
            meanInterval(means, options)};
}

/// The tests of a family lie behind one another.
template <typename Test>
void adjust(std::vector<Test>& tests, std::size_t first, const std::string& name, double alpha) {
    std::vector<AdjustedTest*> family;
    for (std::size_t i = first; i < tests.size(); ++i) family.push_back(&tests[i]);
    adjustFamily(family, name, alpha);
}

/// All pairs of systems in one measure: one family.
void comparePairs(const Cells& cells, const std::string& measure, AnalysisResult& result) {
    const auto& systems = result.table.systems;
    if (systems.size() > 1) result.omnibus.push_back(omnibusTest(cells, measure, systems));
    const std::size_t family = result.pairwise.size();
    for (std::size_t i = 0; i < systems.size(); ++i) {
        for (std::size_t j = i + 1; j < systems.size(); ++j) {
            Comparison& pair = result.pairwise.emplace_back();
            pair.measure = measure;
            pair.a = systems[i];
            pair.b = systems[j];
            testDifferences(pair, cells, result.options.level);
        }
    }
    adjust(result.pairwise, family, fmt::format("{}: pairs of systems", measure), result.alpha);
}

/// The rows of one measure by the levels of a factor: of each system, and of all.
struct LevelCells {
    std::map<std::string, Cells> by_system;
    Cells of_all;
};

LevelCells levelCells(const ResponseTable& table, const std::string& measure,
                      const std::string ResponseRow::*level) {
    LevelCells cells;
    for (const auto& row : table.rows) {
        if (row.measure != measure) continue;
        cells.by_system[row.system][row.*level][row.participant].push_back(row.value);
        cells.of_all[row.*level][row.participant].push_back(row.value);
    }
    return cells;
}

/// Means of each level, and tests of all pairs of levels within each system: one family over the systems.
void compareLevels(const Measure& measure, const std::string& factor, const std::vector<std::string>& levels,
                   const std::string ResponseRow::*level, AnalysisResult& result) {
    if (levels.empty()) return;
    LevelCells cells = levelCells(result.table, measure.name, level);
    const auto addLevels = [&](const std::string& system, const Cells& of_system) {
        for (const auto& name : levels) {
            const auto trials = allTrials(of_system, name);
            result.levels.push_back({measure.name, factor, system, name, mean(trials), sampleSd(trials),
                                     static_cast<int>(trials.size())});
        }
    };
    addLevels("all", cells.of_all);
    for (const auto& system : result.table.systems) addLevels(system, cells.by_system[system]);
    const std::size_t family = result.level_tests.size();
    for (const auto& system : result.table.systems)
        for (std::size_t i = 0; i < levels.size(); ++i)
            for (std::size_t j = i + 1; j < levels.size(); ++j) {
                Comparison& pair = result.level_tests.emplace_back();
                pair.measure = measure.name;
                pair.factor = factor;
                pair.system = system;
                pair.a = levels[i];
                pair.b = levels[j];
                testDifferences(pair, cells.by_system[system], result.options.level);
            }
    adjust(result.level_tests, family, fmt::format("{}: {}s within systems", measure.name, factor),
           result.alpha);
}

/// Each pair of systems that stood side by side, whichever stood left.
void comparePreferences(AnalysisResult& result) {
    const auto& systems = result.table.systems;
    const auto order = [&](const std::string& system) {
        return std::find(systems.begin(), systems.end(), system) - systems.begin();
    };
    std::map<std::pair<std::ptrdiff_t, std::ptrdiff_t>, std::map<std::string, Scores>> pairs;
    for (const auto& row : result.table.rows) {
        if (row.measure != "preference") continue;
        const auto left = order(row.system);
        const auto right = order(row.other_system);
        // Positive: for the one that comes first in the study.
        const double for_first = left < right ? -row.value : row.value;
        pairs[{std::min(left, right), std::max(left, right)}][row.participant].push_back(for_first);
    }
    for (const auto& [pair, participants] : pairs) {
        PreferenceResult& out = result.preferences.emplace_back();
        out.a = systems[static_cast<std::size_t>(pair.first)];
        out.b = systems[static_cast<std::size_t>(pair.second)];
        std::vector<Rational> means;
        for (const auto& [participant, scores] : participants) {
            means.push_back(exactMeanOf(scores));
            for (const double score : scores)
                (score > 0.0 ? out.prefers_a : score < 0.0 ? out.prefers_b : out.ties) += 1;
        }
        out.mean = meanOf(means);
        out.test = signedRankTest(means, result.options.level);
        out.normality = shapiroWilk(means);
    }
    adjust(result.preferences, 0, "preference: pairs of systems", result.alpha);
}

void summariseScores(AnalysisResult& result) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Scores> values;
    for (const ScoreRow& row : result.table.scores) {
        auto& of_score = values[{row.stage, row.score}];
        if (of_score.empty()) order.emplace_back(row.stage, row.score);
        of_score.push_back(row.value);
    }
    for (const auto& key : order) {
        const Scores& scores = values[key];
        result.scores.push_back(
            {key.first, key.second, mean(scores), sampleSd(scores), static_cast<int>(scores.size())});
    }
}

/// By measure.
std::map<std::string, Cells> cellsOf(const ResponseTable& table) {
    std::map<std::string, Cells> cells;
    for (const auto& row : table.rows) cells[row.measure][row.system][row.participant].push_back(row.value);
    return cells;
}

}  // namespace

void runTests(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    result.alpha = result.options.alpha.value_or(table.alpha);
    result.measures.clear();
    result.omnibus.clear();
    result.pairwise.clear();
    result.levels.clear();
    result.level_tests.clear();
    result.preferences.clear();
    for (const Measure& measure : table.measures)
        if (measure.kind != MeasureKind::preference) result.measures.push_back(measure);
    auto cells = cellsOf(table);
    for (const Measure& measure : result.measures) comparePairs(cells[measure.name], measure.name, result);
    for (const Measure& measure : result.measures) {
        if (measure.kind != MeasureKind::accuracy) continue;
        compareLevels(measure, "layout", table.layouts, &ResponseRow::layout, result);
        compareLevels(measure, "distance", table.distances, &ResponseRow::distance, result);
    }
    comparePreferences(result);
}

AnalysisResult analyse(const ResponseTable& table, const AnalysisOptions& options) {
    AnalysisResult result;
    result.table = table;
    result.options = options;
    runTests(result);
    auto cells = cellsOf(table);
    std::set<std::string> participants;
    for (const auto& row : table.rows) {
        participants.insert(row.participant);
        result.synthetic = result.synthetic || row.synthetic;
    }
    // Who has filled in questionnaires only has taken part, too.
    for (const auto& row : table.scores) participants.insert(row.participant);
    for (const auto& station : table.stations) result.synthetic = result.synthetic || station.synthetic;
    result.participants = static_cast<int>(participants.size());
    remarkAnswers(result);

    for (const auto& system : table.systems) {
        SystemResult& row = result.systems.emplace_back();
        row.system = system;
        for (const Measure& measure : result.measures)
            row.measures.push_back(summarise(cells[measure.name], system, options));
    }
    result.bradley_terry = bradleyTerry(table, {options.resamples, options.seed, options.level});
    summariseScores(result);
    describeAnswers(result);

    remarkTests(result);
    return result;
}

}  // namespace deixis::results
