// Participants, their sessions, questionnaires and response times.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "results/analysis/analysis_steps.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/rounded_fraction.hpp"

namespace deixis::results {

namespace {

void describeFields(AnalysisResult& result) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> numbers;
    std::map<std::string, std::map<std::string, int>> options;
    for (const FieldRow& row : result.table.fields) {
        if (std::find(order.begin(), order.end(), row.field) == order.end()) order.push_back(row.field);
        if (row.number)
            numbers[row.field].push_back(*row.number);
        else if (!row.option.empty())
            ++options[row.field][row.option];
    }
    for (const std::string& field : order) {
        FieldResult one;
        one.field = field;
        if (std::vector<double>& of = numbers[field]; !of.empty()) {
            std::sort(of.begin(), of.end());
            one.n = static_cast<int>(of.size());
            one.median = quantileOfSorted(of, 0.5);
            one.min = of.front();
            one.max = of.back();
        }
        for (const auto& [option, n] : options[field]) {
            one.options.emplace_back(option, n);
            one.n += n;
        }
        if (one.n > 0) result.fields.push_back(std::move(one));
    }
}

void describeSessions(const std::string& factor, const std::string& level, AnalysisResult& result) {
    std::vector<double> minutes;
    for (const auto& [participant, of] : result.table.session_minutes)
        if (factor.empty() || levelOfParticipant(result.table, participant, factor) == level)
            minutes.push_back(of);
    if (minutes.empty()) return;
    std::sort(minutes.begin(), minutes.end());
    result.session_times.push_back({factor, level, static_cast<int>(minutes.size()),
                                    quantileOfSorted(minutes, 0.5), minutes.front(), minutes.back()});
}

/// Score, participant: value, of one stage.
Cells scoresOf(const ResponseTable& table, const std::string& stage) {
    Cells out;
    for (const ScoreRow& row : table.scores)
        if (row.stage == stage) out[row.score][row.participant] = {row.value};
    return out;
}

void compareRepeated(AnalysisResult& result) {
    for (const auto& stages : result.table.repeated_questionnaires)
        for (std::size_t later = 1; later < stages.size(); ++later) {
            const std::size_t family = result.score_changes.size();
            const Cells before = scoresOf(result.table, stages[later - 1]);
            const Cells after = scoresOf(result.table, stages[later]);
            for (const auto& [score, of_after] : after) {
                const auto of_before = before.find(score);
                if (of_before == before.end()) continue;
                Comparison pair;
                pair.a = stages[later];
                pair.b = stages[later - 1];
                testDifferences(pair, exactMeans(Cells{{pair.a, of_after}, {pair.b, of_before->second}}),
                                result.level);
                if (pair.test.n_pairs == 0) continue;
                ScoreChange& out = result.score_changes.emplace_back();
                static_cast<AdjustedTest&>(out) = pair;
                out.score = score;
                out.a = pair.a;
                out.b = pair.b;
                std::vector<double> a;
                std::vector<double> b;
                for (const auto& [participant, value] : of_after)
                    if (const auto other = of_before->second.find(participant);
                        other != of_before->second.end()) {
                        a.push_back(value.front());
                        b.push_back(other->second.front());
                    }
                out.mean_a = mean(a);
                out.mean_b = mean(b);
            }
            adjustFrom(result.score_changes, family,
                       fmt::format("scores: {} against {}", stages[later], stages[later - 1]), result.alpha);
        }
}

void compareScoresOfGroups(AnalysisResult& result) {
    std::vector<std::string> stages;
    for (const ScoreResult& one : result.scores)
        if (std::find(stages.begin(), stages.end(), one.stage) == stages.end()) stages.push_back(one.stage);
    for (const std::string& stage : stages)
        for (const Factor& factor : result.table.between) {
            const std::size_t family = result.score_groups.size();
            for (const auto& [score, participants] : scoresOf(result.table, stage)) {
                std::map<std::string, std::vector<Rational>> by_level;
                for (const auto& [participant, value] : participants)
                    by_level[levelOfParticipant(result.table, participant, factor.name)].push_back(
                        exactScore(value.front()));
                for (std::size_t i = 0; i < factor.levels.size(); ++i)
                    for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
                        ScoreGroupResult& out = result.score_groups.emplace_back();
                        out.stage = stage;
                        out.score = score;
                        compareLevelsOf(out, factor, i, j, by_level, result.level);
                    }
            }
            adjustGroups(result.score_groups, family, fmt::format("scores of {}: {}", stage, factor.name),
                         result.alpha);
        }
}

/// In whole milliseconds, so that equal times are tied.
using Milliseconds = std::vector<std::int64_t>;

Rational medianTime(Milliseconds times) {
    std::sort(times.begin(), times.end());
    const std::size_t n = times.size();
    return Rational(times[(n - 1) / 2] + times[n / 2], 2000);
}

/// One time for each trial: a page on which several systems are rated together has none that is one
/// system's.
struct TimesOfMeasure {
    using ByParticipant = std::unordered_map<std::string, Milliseconds>;
    std::unordered_map<std::string, ByParticipant> by_system{};
    ByParticipant all{};
    // The trial that is read: its rows follow each other.
    std::string participant{}, system{};
    int trial = -1;

    void take(const ResponseRow& row) {
        const auto time = std::llround(1000.0 * row.response_time_s);
        if (row.trial >= 0 && row.trial == trial && row.participant == participant) {
            if (row.system == system || system.empty()) return;
            by_system[system][participant].pop_back();
            system = {};
            return;
        }
        participant = row.participant;
        system = row.system;
        trial = row.trial;
        all[participant].push_back(time);
        by_system[system][participant].push_back(time);
    }
};

std::map<std::string, Rational> mediansOf(const TimesOfMeasure::ByParticipant& times) {
    std::map<std::string, Rational> out;
    for (const auto& [participant, of] : times)
        if (!of.empty()) out.emplace(participant, medianTime(of));
    return out;
}

/// Confidence is asked in the trial of the choice: its times are those of accuracy.
bool hasOwnTimes(const Measure& measure) {
    return measure.name != "confidence" && !measure.name.starts_with("confidence (");
}

void compareTimesOfGroups(const Measure& measure, const std::map<std::string, Rational>& medians,
                          AnalysisResult& result) {
    for (const Factor& factor : result.table.between) {
        const std::size_t groups = result.time_groups.size();
        std::map<std::string, std::vector<Rational>> by_level;
        for (const auto& [participant, median] : medians)
            by_level[levelOfParticipant(result.table, participant, factor.name)].push_back(median);
        for (std::size_t i = 0; i < factor.levels.size(); ++i)
            for (std::size_t j = i + 1; j < factor.levels.size(); ++j) {
                BetweenResult& out = result.time_groups.emplace_back();
                out.measure = measure.name;
                out.system = "all";
                compareLevelsOf(out, factor, i, j, by_level, result.level);
            }
        adjustGroups(result.time_groups, groups,
                     fmt::format("response times, {}: {}", measure.name, factor.name), result.alpha);
    }
}

void compareTimes(AnalysisResult& result) {
    std::unordered_map<std::string, TimesOfMeasure> times;
    for (const ResponseRow& row : result.table.rows)
        if (row.response_time_s > 0.0 && row.response_time_s < 1e9) times[row.measure].take(row);
    std::vector<Measure> measures;
    MeansByMeasure medians;
    for (Measure measure : result.measures) {
        const auto found = times.find(measure.name);
        if (found == times.end() || !hasOwnTimes(measure)) continue;
        measure.equivalence_bound = 0.0;  // declared in its own unit
        measures.push_back(measure);
        for (const auto& [system, participants] : found->second.by_system)
            medians[measure.name][system] = mediansOf(participants);
        compareTimesOfGroups(measure, mediansOf(found->second.all), result);
    }
    result.time_tests = pairTests(medians, measures, result.table.systems, result.level, result.alpha);
    for (Comparison& one : result.time_tests) one.family = "response times, " + one.family;
}

}  // namespace

void describeParticipants(AnalysisResult& result) {
    describeFields(result);
    describeSessions("", "", result);
    for (const Factor& factor : result.table.between)
        for (const std::string& level : factor.levels) describeSessions(factor.name, level, result);
    compareRepeated(result);
    compareScoresOfGroups(result);
    compareTimes(result);
}

}  // namespace deixis::results
