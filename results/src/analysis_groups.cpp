// Factors between participants, and questionnaires.
#include <fmt/core.h>

#include <limits>
#include <map>

#include "analysis_details.hpp"
#include "analysis_tests.hpp"
#include "results/descriptive.hpp"
#include "results/holm.hpp"

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
        const auto groups = table.groups.find(participant);
        if (groups == table.groups.end() || !groups->second.contains(factor)) continue;
        const std::string& level = groups->second.at(factor);
        std::vector<Rational> means;
        for (const auto& [system, of_system] : systems) {
            means.push_back(exactMeanOf(of_system));
            out[system][level].push_back(means.back());
        }
        out["all"][level].push_back(exactMean(means));
    }
    return out;
}

void adjustGroups(std::vector<BetweenResult>& tests, std::size_t first, const std::string& name,
                  double alpha) {
    std::vector<double> p;
    int size = 0;
    for (std::size_t i = first; i < tests.size(); ++i) {
        p.push_back(tests[i].test.p_two_sided.value_or(std::numeric_limits<double>::quiet_NaN()));
        size += tests[i].test.p_two_sided ? 1 : 0;
    }
    const auto adjusted = holm(p);
    for (std::size_t i = first; i < tests.size(); ++i) {
        BetweenResult& one = tests[i];
        one.family = name;
        one.family_size = size;
        if (!one.test.p_two_sided) continue;
        one.p_holm = adjusted[i - first];
        one.significant = *one.p_holm <= alpha;
    }
}

/// In the order in which they first stand; level: of `factor`, or all participants where that is empty.
void addScores(const std::string& factor, const std::string& level, AnalysisResult& result) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Scores> values;
    for (const ScoreRow& row : result.table.scores) {
        if (!factor.empty()) {
            const auto groups = result.table.groups.find(row.participant);
            if (groups == result.table.groups.end()) continue;
            const auto of_factor = groups->second.find(factor);
            if (of_factor == groups->second.end() || of_factor->second != level) continue;
        }
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
                        out.factor = factor.name;
                        out.system = system;
                        out.a = factor.levels[i];
                        out.b = factor.levels[j];
                        const auto& a = means[system][out.a];
                        const auto& b = means[system][out.b];
                        out.mean_a = meanOf(a);
                        out.mean_b = meanOf(b);
                        out.test = rankSumTest(a, b, result.options.level);
                    }
            adjustGroups(result.between, family, fmt::format("{}: {}", measure.name, factor.name),
                         result.alpha);
        }
}

void summariseScores(AnalysisResult& result) {
    addScores("", "", result);
    for (const Factor& factor : result.table.between)
        for (const std::string& level : factor.levels) addScores(factor.name, level, result);
}

}  // namespace deixis::results
