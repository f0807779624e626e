#include "results/analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "results/descriptive.hpp"
#include "results/holm.hpp"

namespace deixis::results {

namespace {

/// The scores of one participant under one condition.
using Scores = std::vector<double>;

/// Condition -> participant -> scores. std::map keeps the participants in order.
using Cells = std::map<std::string, std::map<std::string, Scores>>;

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

Summary summarise(const Cells& cells, const std::string& system) {
    const auto means = participantMeans(cells, system);
    const auto trials = allTrials(cells, system);
    return {mean(means), sampleSd(means), sampleSd(trials), static_cast<int>(trials.size()), means};
}

/// Scores as the decimals they were given as: means that are equal on paper are equal.
Rational exactMeanOf(const Scores& scores) {
    Rational sum;
    for (const double score : scores) sum += Rational::fromShortestDecimal(score);
    return sum / Rational(static_cast<std::int64_t>(scores.size()));
}

double meanOf(const std::vector<Rational>& values) {
    return values.empty() ? 0.0 : exactMean(values).toDouble();
}

/// Participants' means under `a` minus those under `b`, for the participants who have both.
std::vector<Rational> pairedDifferences(const Cells& cells, const std::string& a, const std::string& b) {
    std::vector<Rational> differences;
    const auto cell_a = cells.find(a);
    const auto cell_b = cells.find(b);
    if (cell_a == cells.end() || cell_b == cells.end()) return differences;
    for (const auto& [participant, scores] : cell_a->second)
        if (const auto other = cell_b->second.find(participant); other != cell_b->second.end())
            differences.push_back(exactMeanOf(scores) - exactMeanOf(other->second));
    return differences;
}

void test(Comparison& comparison, const Cells& cells) {
    const auto differences = pairedDifferences(cells, comparison.a, comparison.b);
    comparison.mean_difference = meanOf(differences);
    comparison.test = signedRankTest(differences);
}

/// Holm over a family of tests, and what is significant after it.
template <typename Iterator>
void adjust(Iterator first, Iterator last, double alpha) {
    std::vector<double> p;
    for (auto it = first; it != last; ++it) p.push_back(it->test.p_two_sided);
    const auto adjusted = holm(p);
    for (auto it = first; it != last; ++it) {
        it->p_holm = adjusted[static_cast<std::size_t>(it - first)];
        it->significant = it->p_holm <= alpha;
    }
}

/// All pairs of systems in one measure: one family.
void comparePairs(const Cells& cells, const std::string& measure, AnalysisResult& result) {
    const auto& systems = result.table.systems;
    const auto family = static_cast<std::ptrdiff_t>(result.pairwise.size());
    for (std::size_t i = 0; i < systems.size(); ++i) {
        for (std::size_t j = i + 1; j < systems.size(); ++j) {
            Comparison pair;
            pair.measure = measure;
            pair.a = systems[i];
            pair.b = systems[j];
            test(pair, cells);
            result.pairwise.push_back(pair);
        }
    }
    adjust(result.pairwise.begin() + family, result.pairwise.end(), result.table.alpha);
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
    const auto family = static_cast<std::ptrdiff_t>(result.level_tests.size());
    for (const auto& system : result.table.systems)
        for (std::size_t i = 0; i < levels.size(); ++i)
            for (std::size_t j = i + 1; j < levels.size(); ++j) {
                Comparison pair{measure.name, factor, system, levels[i], levels[j], 0.0, {}, 1.0, false};
                test(pair, cells.by_system[system]);
                result.level_tests.push_back(pair);
            }
    adjust(result.level_tests.begin() + family, result.level_tests.end(), result.table.alpha);
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
        out.test = signedRankTest(means);
    }
    adjust(result.preferences.begin(), result.preferences.end(), result.table.alpha);
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

/// A participant who lacks answers under one of two conditions is missing from their comparison.
void remarkLeftOut(const std::vector<Comparison>& comparisons, const std::string& measure,
                   const std::string& factor, AnalysisResult& result) {
    int fewest = result.participants;
    int most = 0;
    for (const auto& comparison : comparisons) {
        if (comparison.measure != measure || comparison.factor != factor) continue;
        fewest = std::min(fewest, comparison.test.n_pairs);
        most = std::max(most, comparison.test.n_pairs);
    }
    if (fewest == result.participants || most == 0) return;
    result.remarks.push_back(fmt::format(
        "Tests of {}: participants without answers under one of the two conditions are left out; {} of {} "
        "participants enter.",
        factor.empty() ? measure : factor,
        fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most),
        result.participants));
}

/// The signed-rank test of n pairs cannot give a p below 2^(1-n).
void remarkPower(AnalysisResult& result) {
    if (result.measures.empty()) return;
    const std::string& measure = result.measures.front().name;
    const auto pairs = std::count_if(result.pairwise.begin(), result.pairwise.end(),
                                     [&](const Comparison& c) { return c.measure == measure; });
    const double smallest = std::exp2(1 - result.participants);
    if (pairs == 0 || smallest * static_cast<double>(pairs) <= result.table.alpha) return;
    result.remarks.push_back(fmt::format(
        "With {} participant{} no difference between systems can be significant at {} after Holm's "
        "correction: "
        "the smallest p that the test can give is {:.2g}, to be multiplied by {}.",
        result.participants, result.participants == 1 ? "" : "s", result.table.alpha, smallest, pairs));
}

void remarkAnswers(const ResponseTable& table, AnalysisResult& result) {
    std::map<std::string, int> answered;
    int interrupted = 0;
    int synthetic = 0;
    for (const auto& row : table.rows) {
        ++answered[row.measure];
        interrupted += row.pauses > 0 ? 1 : 0;
        synthetic += row.synthetic ? 1 : 0;
    }
    auto& remarks = result.remarks;
    const int all = static_cast<int>(table.rows.size());
    std::string missing;
    for (const Measure& measure : table.measures) {
        if (answered[measure.name] == 0)
            remarks.push_back(fmt::format("There are no answers on {}: it is not reported.", measure.name));
        if (answered[measure.name] != measure.planned)
            missing += fmt::format("{}{} of {} planned on {}", missing.empty() ? "" : ", ",
                                   answered[measure.name], measure.planned, measure.name);
    }
    if (synthetic > 0 && synthetic < all)
        remarks.push_back(
            fmt::format("{} of {} answers come from simulated participants, the others from people: "
                        "analyse them apart.",
                        synthetic, all));
    if (!missing.empty())
        remarks.push_back(fmt::format("The data are incomplete: {} are answered.", missing));
    if (result.participants != table.planned_participants)
        remarks.push_back(fmt::format("{} of {} participants with a plan have answered.", result.participants,
                                      table.planned_participants));
    if (interrupted > 0)
        remarks.push_back(fmt::format(
            "{} answers were given to trials that had been interrupted and shown again from the start.",
            interrupted));
    if (table.withdrawn > 0)
        remarks.push_back(fmt::format("{} {} withdrew; nothing of theirs is kept.", table.withdrawn,
                                      table.withdrawn == 1 ? "participant" : "participants"));
    for (const std::string& factor : table.between)
        remarks.push_back(fmt::format(
            "Participants differ in {}, which is not compared here: all are taken together.", factor));
}

}  // namespace

AnalysisResult analyse(const ResponseTable& table) {
    AnalysisResult result;
    result.table = table;
    std::map<std::string, Cells> cells;  // by measure
    std::set<std::string> participants;
    for (const auto& row : table.rows) {
        participants.insert(row.participant);
        result.synthetic = result.synthetic || row.synthetic;
        cells[row.measure][row.system][row.participant].push_back(row.value);
    }
    // Who has filled in questionnaires only has taken part, too.
    for (const auto& row : table.scores) participants.insert(row.participant);
    for (const auto& station : table.stations) result.synthetic = result.synthetic || station.synthetic;
    result.participants = static_cast<int>(participants.size());
    remarkAnswers(table, result);
    for (const Measure& measure : table.measures)
        if (measure.kind != MeasureKind::preference) result.measures.push_back(measure);

    for (const auto& system : table.systems) {
        SystemResult& row = result.systems.emplace_back();
        row.system = system;
        for (const Measure& measure : result.measures)
            row.measures.push_back(summarise(cells[measure.name], system));
    }
    for (const Measure& measure : result.measures) comparePairs(cells[measure.name], measure.name, result);
    for (const Measure& measure : result.measures) {
        if (measure.kind != MeasureKind::accuracy) continue;
        compareLevels(measure, "layout", table.layouts, &ResponseRow::layout, result);
        compareLevels(measure, "distance", table.distances, &ResponseRow::distance, result);
    }
    comparePreferences(result);
    summariseScores(result);

    for (const Measure& measure : result.measures) remarkLeftOut(result.pairwise, measure.name, "", result);
    for (const char* factor : {"layout", "distance"})
        remarkLeftOut(result.level_tests, "accuracy", factor, result);
    remarkPower(result);
    return result;
}

}  // namespace deixis::results
