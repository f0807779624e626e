#include "results/analysis/analysis.hpp"

#include <cmath>
#include <future>
#include <map>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include <algorithm>

#include "remarks.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/analysis/tests.hpp"
#include "results/answers/stations.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

std::vector<double> participantMeans(const Cells& cells, const std::string& condition) {
    std::vector<double> means;
    if (const auto cell = cells.find(condition); cell != cells.end())
        for (const auto& [participant, scores] : cell->second) means.push_back(mean(scores));
    return means;
}

/// From the smallest to the largest of n values covers the middle of what they were drawn from in 1 - 2^(1-n)
/// of all samples; a bootstrap interval lies within.
bool fallsShort(std::size_t n, double level) {
    return 1.0 - std::ldexp(1.0, 1 - static_cast<int>(n)) < level;
}

}  // namespace

Summary summarise(const Cells& cells, const std::string& system) {
    const auto means = participantMeans(cells, system);
    const auto trials = allTrials(cells, system);
    return {
        mean(means), quantile(means, 0.5), sampleSd(means), sampleSd(trials), static_cast<int>(trials.size()),
        means};
}

void addIntervals(const std::vector<Summary*>& summaries, const BootstrapOptions& options) {
    std::map<std::size_t, std::vector<Summary*>> by_size;
    for (Summary* one : summaries)
        if (one->by_participant.size() > 1) by_size[one->by_participant.size()].push_back(one);
    for (const auto& [size, together] : by_size) {
        std::vector<std::vector<double>> rows(size);
        for (std::size_t i = 0; i < size; ++i)
            for (const Summary* one : together) rows[i].push_back(one->by_participant[i]);
        const auto made = bootstrapMeans(rows, options);
        for (std::size_t c = 0; c < together.size(); ++c) {
            together[c]->interval = made[c].bca ? made[c].bca : made[c].percentile;
            together[c]->interval_falls_short = together[c]->interval && fallsShort(size, options.level);
        }
    }
}

namespace {

std::vector<SystemResult> summariseSystems(const CellsByMeasure& cells, const AnalysisResult& result) {
    std::vector<SystemResult> out;
    const Cells none;
    for (const auto& system : result.table.systems) {
        SystemResult& row = out.emplace_back(SystemResult{system, {}});
        for (const Measure& measure : result.measures) {
            const auto of_measure = cells.find(measure.name);
            row.measures.push_back(summarise(of_measure == cells.end() ? none : of_measure->second, system));
        }
    }
    std::vector<Summary*> summaries;
    for (SystemResult& row : out)
        for (Summary& one : row.measures) summaries.push_back(&one);
    addIntervals(summaries, {result.options.resamples, result.options.seed, result.level});
    return out;
}

/// The tests of the answers in `cells`, which are the table's.
void testAnswers(const RowPointers& rows, const CellsByMeasure& cells, AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const double level = result.level;
    result.omnibus.clear();
    result.levels.clear();
    result.level_tests.clear();
    MeansByMeasure means = exactMeans(cells);
    if (table.systems.size() > 1)
        for (const Measure& measure : result.measures)
            result.omnibus.push_back(omnibusTest(means[measure.name], measure.name, table.systems));
    result.pairwise = pairTests(means, result.measures, table.systems, level, result.alpha);
    compareLevels(result);
    result.preferences = preferenceTests(rows, table.systems, level, result.alpha);
    result.between.clear();
    result.preferences_between.clear();
    compareSystemsBetween(means, result);
    compareGroups(result);
    comparePreferencesOfGroups(result);
}

/// The options' bound, else the study's; 0 without one. A measure on several scales has its scale in its
/// name.
double equivalenceBound(const std::string& measure, const AnalysisResult& result) {
    for (const auto* bounds : {&result.options.equivalence, &result.table.equivalence})
        for (const auto& [name, bound] : *bounds)
            if (measure == name || measure.starts_with(name + " (")) return bound;
    return 0.0;
}

void setUp(AnalysisResult& result) {
    result.alpha = result.options.alpha.value_or(result.table.alpha);
    result.level = result.options.level.value_or(1.0 - result.alpha);
    result.by_ratings = result.options.by_ratings.value_or(result.table.by_ratings);
    result.measures.clear();
    for (const Measure& measure : result.table.measures)
        if (measure.kind != MeasureKind::preference) {
            result.measures.push_back(measure);
            result.measures.back().equivalence_bound = equivalenceBound(measure.name, result);
        }
}

/// People's answers and simulated ones are never one mean: where there are both, people's count.
void takeParticipantsOnly(AnalysisResult& result) {
    ResponseTable& table = result.table;
    const auto synthetic = [](const ResponseRow& row) { return row.synthetic; };
    const auto n = std::count_if(table.rows.begin(), table.rows.end(), synthetic);
    if (n == 0 || n == static_cast<std::ptrdiff_t>(table.rows.size())) return;
    result.table = onlyAt(std::move(table), {});
    result.remarks.push_back(fmt::format(
        "{} answers of simulated participants are left out: they are never averaged with people's.", n));
}

void countParticipants(AnalysisResult& result) {
    std::set<std::string> participants;
    for (const auto& row : result.table.rows) {
        participants.insert(row.participant);
        result.synthetic = result.synthetic || row.synthetic;
    }
    // Who has filled in questionnaires only has taken part, too.
    for (const auto& row : result.table.scores) participants.insert(row.participant);
    for (const auto& station : result.table.stations)
        result.synthetic = result.synthetic || station.synthetic;
    result.participants = static_cast<int>(participants.size());
}

/// Families that other studies, or all of them, have too.
void nameFamilies(AnalysisResult& result, const std::string& where) {
    const auto name = [&](auto& tests) {
        for (auto& test : tests) test.family += ", " + where;
    };
    name(result.pairwise);
    name(result.preferences);
    name(result.rating_pairs);
    name(result.author_trials);
    name(result.author_trials_paired);
    for (BetweenResult& one : result.between)
        if (one.factor == systems_between) one.family += ", " + where;
}

/// The tests of one study's systems, in families of their own.
AnalysisResult analyseStudy(const AnalysisResult& all, const std::string& study) {
    AnalysisResult one;
    one.table = onlyStudy(all.table, study);
    one.options = all.options;
    setUp(one);
    const RowPointers rows = pointersTo(one.table.rows);
    const CellsByMeasure cells = cellsOf(rows);
    testAnswers(rows, cells, one);
    one.systems = summariseSystems(cells, one);
    countParticipants(one);
    compareRatings(one);
    compareAuthorTrials(one);
    nameFamilies(one, "in " + study);
    return one;
}

}  // namespace

void runTests(AnalysisResult& result) {
    setUp(result);
    result.level = 0.0;
    setAside(result);
    const RowPointers rows = pointersTo(result.table.rows);
    testAnswers(rows, cellsOf(rows), result);
}

AnalysisResult analyse(ResponseTable table, const AnalysisOptions& options) {
    AnalysisResult result;
    result.table = std::move(table);
    result.options = options;
    takeParticipantsOnly(result);
    dropEmptyStudies(result.table);
    setUp(result);
    if (!result.table.not_compared.empty()) {
        // These are about all answers.
        result.answers_hash = answersHash(result.table);
        result.quality = dataQuality(result.table);
        setAside(result);
    }
    const bool all = result.table.not_compared.empty();
    const RowPointers rows = pointersTo(result.table.rows);
    const CellsByMeasure cells = cellsOf(rows);
    // What needs no test is worked out beside the tests.
    auto hash =
        std::async(std::launch::async, [&] { return all ? answersHash(result.table) : result.answers_hash; });
    auto systems = std::async(std::launch::async, [&] { return summariseSystems(cells, result); });
    auto quality =
        std::async(std::launch::async, [&] { return all ? dataQuality(result.table) : result.quality; });
    auto descriptions = std::async(std::launch::async, [&] { describeAnswers(result); });
    testAnswers(rows, cells, result);
    countParticipants(result);
    remarkAnswers(result);
    result.systems = systems.get();
    result.answers_hash = hash.get();
    result.quality = quality.get();
    descriptions.get();

    if (!result.preferences.empty())
        result.bradley_terry = bradleyTerry(result.table, {options.resamples, options.seed, result.level});
    describeLevels(result);
    testInteractions(result);
    compareRatings(result);
    compareAuthorTrials(result);
    compareOtherAnswers(result);
    summariseScores(result);
    describeParticipants(result);
    describeChoices(result);
    compareWithObjective(result);
    for (const std::string& study : studiesIn(result.table))
        result.by_study.push_back(analyseStudy(result, study));
    if (!result.by_study.empty()) {
        nameFamilies(result, "all studies pooled");
        orderMedians(result);
    }

    remarkTests(result);
    return result;
}

}  // namespace deixis::results
