#include "results/analysis.hpp"

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
            quantile(means, 0.5),
            sampleSd(means),
            sampleSd(trials),
            static_cast<int>(trials.size()),
            means,
            meanInterval(means, options)};
}

RowPointers pointersTo(const std::vector<ResponseRow>& rows) {
    RowPointers out;
    out.reserve(rows.size());
    for (const ResponseRow& row : rows) out.push_back(&row);
    return out;
}

}  // namespace

void runTests(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const double level = result.options.level;
    result.alpha = result.options.alpha.value_or(table.alpha);
    result.measures.clear();
    result.omnibus.clear();
    result.levels.clear();
    result.level_tests.clear();
    for (const Measure& measure : table.measures)
        if (measure.kind != MeasureKind::preference) result.measures.push_back(measure);
    const RowPointers rows = pointersTo(table.rows);
    CellsByMeasure cells = cellsOf(rows);
    if (table.systems.size() > 1)
        for (const Measure& measure : result.measures)
            result.omnibus.push_back(omnibusTest(cells[measure.name], measure.name, table.systems));
    result.pairwise = pairTests(cells, result.measures, table.systems, level, result.alpha);
    compareLevels(result);
    result.preferences = preferenceTests(rows, table.systems, level, result.alpha);
    result.between.clear();
    result.preferences_between.clear();
    compareGroups(result);
    comparePreferencesOfGroups(result);
}

AnalysisResult analyse(const ResponseTable& table, const AnalysisOptions& options) {
    AnalysisResult result;
    result.table = table;
    result.options = options;
    runTests(result);
    CellsByMeasure cells = cellsOf(pointersTo(table.rows));
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
    compareOtherAnswers(result);
    summariseScores(result);
    describeAnswers(result);
    describeChoices(result);

    remarkTests(result);
    return result;
}

}  // namespace deixis::results
