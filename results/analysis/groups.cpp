// Factors between participants, and questionnaires.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"

namespace deixis::results {

namespace {

/// System ("all" among them) -> level -> participants' means.
using GroupMeans = std::map<std::string, std::map<std::string, std::vector<Rational>>>;

GroupMeans groupMeans(const ResponseTable& table, const std::string& measure, const std::string& factor) {
    std::map<std::string, std::map<std::string, Scores>> scores;  // participant, system
    for (const ResponseRow& row : table.rows)
        if (row.measure == measure) scores[row.participant][row.system].push_back(row.value);
    GroupMeans out;
    for (const auto& [participant, systems] : scores) {
        const std::string level = levelOfParticipant(table, participant, factor);
        if (level.empty()) continue;
        std::vector<Rational> means;
        for (const auto& [system, of_system] : systems) {
            means.push_back(exactMeanOf(of_system));
            out[system][level].push_back(means.back());
        }
        out["all"][level].push_back(exactMean(means));
    }
    return out;
}

/// A pair of systems' answers by level, and each participant's net preference.
struct GroupPreferences {
    std::map<std::string, std::vector<Rational>> net;
    std::map<std::string, PreferenceCounts> answers;
};

GroupPreferences groupPreferences(const ResponseTable& table, const std::string& factor,
                                  const std::map<std::string, Scores>& participants) {
    GroupPreferences out;
    for (const auto& [participant, scores] : participants) {
        const std::string level = levelOfParticipant(table, participant, factor);
        if (level.empty()) continue;
        out.net[level].push_back(exactMeanOf(scores));
        PreferenceCounts& counts = out.answers[level];
        for (const double score : scores)
            ++(score > 0.0 ? counts.wins : score < 0.0 ? counts.losses : counts.ties);
    }
    return out;
}

/// In the order in which they first stand; level: of `factor`, or all participants where that is empty.
void addScores(const std::string& factor, const std::string& level, AnalysisResult& result) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Scores> values;
    for (const ScoreRow& row : result.table.scores) {
        if (!factor.empty() && levelOfParticipant(result.table, row.participant, factor) != level) continue;
        auto& of_score = values[{row.stage, row.score}];
        if (of_score.empty()) order.emplace_back(row.stage, row.score);
        of_score.push_back(row.value);
    }
    for (const auto& key : order) {
        const Scores& scores = values[key];
        result.scores.push_back({key.first, key.second, mean(scores), sampleSd(scores),
                                 static_cast<int>(scores.size()), quantile(scores, 0.25),
                                 quantile(scores, 0.5), quantile(scores, 0.75), factor, level});
    }
}

}  // namespace

void compareLevelsOf(GroupTest& out, const Factor& factor, std::size_t a, std::size_t b,
                     std::map<std::string, std::vector<Rational>>& by_level, double level, double bound) {
    out.factor = factor.name;
    out.a = factor.levels[a];
    out.b = factor.levels[b];
    const std::vector<Rational>& of_a = by_level[out.a];
    const std::vector<Rational>& of_b = by_level[out.b];
    out.mean_a = meanOf(of_a);
    out.mean_b = meanOf(of_b);
    out.test = rankSumTest(of_a, of_b, level);
    if (bound <= 0.0 || !out.test.p_two_sided) return;
    const auto shifted = [&](const Rational& by) {
        std::vector<Rational> values;
        for (const Rational& value : of_a) values.push_back(value + by);
        return rankSumTest(values, of_b, 0.0);
    };
    const Rational exactly = Rational::fromShortestDecimal(bound);
    out.equivalence = {bound, std::max(*shifted(exactly).p_greater, *shifted(-exactly).p_less)};
}

void compareGroups(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), table.systems.begin(), table.systems.end());
    for (const Measure& measure : result.measures)
        for (const Factor& factor : table.between) {
            GroupMeans means = groupMeans(table, measure.name, factor.name);
            const std::size_t family = result.between.size();
            for (const std::string& system : systems)
                for (std::size_t i = 0; i < factor.levels.size(); ++i)
                    for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
                        BetweenResult& out = result.between.emplace_back();
                        out.measure = measure.name;
                        out.system = system;
                        compareLevelsOf(out, factor, i, j, means[system], result.level,
                                        measure.equivalence_bound);
                    }
            adjustGroups(result.between, family, fmt::format("{}: {}", measure.name, factor.name),
                         result.alpha);
        }
}

void compareSystemsBetween(const MeansByMeasure& means, AnalysisResult& result) {
    for (const Measure& measure : result.measures) {
        const auto found = means.find(measure.name);
        if (found == means.end()) continue;
        Factor systems{systems_between, result.table.systems};
        std::map<std::string, std::vector<Rational>> by_system;
        for (const auto& [system, participants] : found->second)
            for (const auto& [participant, mean] : participants) by_system[system].push_back(mean);
        const std::size_t family = result.between.size();
        for (const Comparison& pair : result.pairwise) {
            if (pair.measure != measure.name || pair.test.n_pairs > 0) continue;
            if (by_system[pair.a].empty() || by_system[pair.b].empty()) continue;
            BetweenResult& out = result.between.emplace_back();
            out.measure = measure.name;
            out.system = "all";
            const auto place = [&](const std::string& system) {
                return static_cast<std::size_t>(
                    std::find(systems.levels.begin(), systems.levels.end(), system) - systems.levels.begin());
            };
            compareLevelsOf(out, systems, place(pair.a), place(pair.b), by_system, result.level,
                            measure.equivalence_bound);
        }
        adjustGroups(result.between, family,
                     fmt::format("{}: pairs of systems, between participants", measure.name), result.alpha);
    }
}

void comparePreferencesOfGroups(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    RowPointers rows;
    for (const ResponseRow& row : table.rows) rows.push_back(&row);
    const PreferencesByPair pairs = preferencesByPair(rows, table.systems);
    for (const Factor& factor : table.between) {
        const std::size_t family = result.preferences_between.size();
        for (const auto& [pair, participants] : pairs) {
            GroupPreferences groups = groupPreferences(table, factor.name, participants);
            for (std::size_t i = 0; i < factor.levels.size(); ++i)
                for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
                    PreferenceBetweenResult& out = result.preferences_between.emplace_back();
                    out.system = table.systems[pair.first];
                    out.other_system = table.systems[pair.second];
                    compareLevelsOf(out, factor, i, j, groups.net, result.level);
                    out.answers_a = groups.answers[out.a];
                    out.answers_b = groups.answers[out.b];
                }
        }
        adjustGroups(result.preferences_between, family, fmt::format("preference: {}", factor.name),
                     result.alpha);
    }
}

void summariseScores(AnalysisResult& result) {
    addScores("", "", result);
    for (const Factor& factor : result.table.between)
        for (const std::string& level : factor.levels) addScores(factor.name, level, result);
}

}  // namespace deixis::results
