#include "results/analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace deixis::results {

namespace {

/// The scores of one participant under one condition.
using Scores = std::vector<double>;

/// Condition -> participant -> scores. std::map keeps the participants in order.
using Cells = std::map<std::string, std::map<std::string, Scores>>;

bool isGame(const ResponseRow& row) {
    return row.stage == "game";
}

double score(const ResponseRow& row) {
    return isGame(row) ? (row.correct ? 1.0 : 0.0) : row.rating;
}

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
    return {mean(means), sampleSd(means), sampleSd(trials), static_cast<int>(trials.size())};
}

/// Participants' means under `a` minus those under `b`, for the participants who have both.
std::vector<double> pairedDifferences(const Cells& cells, const std::string& a, const std::string& b) {
    std::vector<double> differences;
    const auto cell_a = cells.find(a);
    const auto cell_b = cells.find(b);
    if (cell_a == cells.end() || cell_b == cells.end()) return differences;
    for (const auto& [participant, scores] : cell_a->second)
        if (const auto other = cell_b->second.find(participant); other != cell_b->second.end())
            differences.push_back(mean(scores) - mean(other->second));
    return differences;
}

void test(Comparison& comparison, const Cells& cells) {
    const auto differences = pairedDifferences(cells, comparison.a, comparison.b);
    comparison.mean_difference = mean(differences);
    comparison.test = signedRankTest(differences);
}

/// Holm over a family of comparisons, and what is significant after it.
void adjust(std::vector<Comparison>::iterator first, std::vector<Comparison>::iterator last, double alpha) {
    std::vector<double> p;
    for (auto it = first; it != last; ++it) p.push_back(it->test.p);
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

/// A participant who lacks answers under one of two conditions is missing from their comparison.
void remarkLeftOut(const std::vector<Comparison>& comparisons, const std::string& measure,
                   AnalysisResult& result) {
    int fewest = result.participants;
    int most = 0;
    for (const auto& comparison : comparisons) {
        if (comparison.measure != measure) continue;
        fewest = std::min(fewest, comparison.test.n);
        most = std::max(most, comparison.test.n);
    }
    if (fewest == result.participants || most == 0) return;
    result.remarks.push_back(fmt::format(
        "Tests of {}: participants without answers under one of the two conditions are left out; {} of {} "
        "participants enter.",
        measure, fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most),
        result.participants));
}

/// The signed-rank test of n pairs cannot give a p below 2^(1-n).
void remarkPower(AnalysisResult& result) {
    const auto pairs = std::count_if(result.pairwise.begin(), result.pairwise.end(),
                                     [](const Comparison& c) { return c.measure == "accuracy"; });
    const double smallest = std::exp2(1 - result.participants);
    if (pairs == 0 || smallest * static_cast<double>(pairs) <= result.table.alpha) return;
    result.remarks.push_back(fmt::format(
        "With {} participant{} no difference between systems can be significant at {} after Holm's "
        "correction: "
        "the smallest p that the test can give is {:.2g}, to be multiplied by {}.",
        result.participants, result.participants == 1 ? "" : "s", result.table.alpha, smallest, pairs));
}

void remarkAnswers(const ResponseTable& table, AnalysisResult& result) {
    int ratings = 0;
    int choices = 0;
    int interrupted = 0;
    int synthetic = 0;
    for (const auto& row : table.rows) {
        (isGame(row) ? choices : ratings) += 1;
        interrupted += row.pauses > 0 ? 1 : 0;
        synthetic += row.synthetic ? 1 : 0;
    }
    auto& remarks = result.remarks;
    if (ratings == 0) remarks.push_back("There are no ratings: naturalness is not reported.");
    if (choices == 0) remarks.push_back("There are no choices: accuracy is not reported.");
    if (synthetic > 0 && synthetic < ratings + choices)
        remarks.push_back(
            fmt::format("{} of {} answers come from simulated participants, the others from people: "
                        "analyse them apart.",
                        synthetic, ratings + choices));
    if (ratings != table.planned_ratings || choices != table.planned_choices)
        remarks.push_back(fmt::format(
            "The data are incomplete: {} of {} planned ratings and {} of {} planned choices are answered.",
            ratings, table.planned_ratings, choices, table.planned_choices));
    if (result.participants != table.planned_participants)
        remarks.push_back(fmt::format("{} of {} participants with a plan have answered.", result.participants,
                                      table.planned_participants));
    if (interrupted > 0)
        remarks.push_back(fmt::format(
            "{} answers were given to trials that had been interrupted and shown again from the start.",
            interrupted));
}

}  // namespace

AnalysisResult analyse(const ResponseTable& table) {
    AnalysisResult result;
    result.table = table;
    Cells accuracy;
    Cells naturalness;
    std::map<std::string, Cells> accuracy_by_layout;  // of each system
    Cells accuracy_of_all;                            // by layout
    std::set<std::string> participants;
    for (const auto& row : table.rows) {
        participants.insert(row.participant);
        result.synthetic = result.synthetic || row.synthetic;
        (isGame(row) ? accuracy : naturalness)[row.system][row.participant].push_back(score(row));
        if (isGame(row)) {
            accuracy_by_layout[row.system][row.layout][row.participant].push_back(score(row));
            accuracy_of_all[row.layout][row.participant].push_back(score(row));
        }
    }
    result.participants = static_cast<int>(participants.size());
    remarkAnswers(table, result);

    const auto addLayouts = [&](const std::string& system, const Cells& cells) {
        for (const auto& layout : table.layouts) {
            const auto trials = allTrials(cells, layout);
            result.layouts.push_back(
                {system, layout, mean(trials), sampleSd(trials), static_cast<int>(trials.size())});
        }
    };
    addLayouts("all", accuracy_of_all);
    for (const auto& system : table.systems) {
        result.systems.push_back({system, summarise(accuracy, system), summarise(naturalness, system),
                                  participantMeans(accuracy, system), participantMeans(naturalness, system)});
        addLayouts(system, accuracy_by_layout[system]);
    }

    comparePairs(accuracy, "accuracy", result);
    comparePairs(naturalness, "naturalness", result);
    // Two layouts make one test a system; more make all pairs, still one family over the systems.
    for (const auto& system : table.systems)
        for (std::size_t i = 0; i < table.layouts.size(); ++i)
            for (std::size_t j = i + 1; j < table.layouts.size(); ++j) {
                Comparison pair;
                pair.measure = "layout";
                pair.system = system;
                pair.a = table.layouts[i];
                pair.b = table.layouts[j];
                test(pair, accuracy_by_layout[system]);
                result.layout_tests.push_back(pair);
            }
    adjust(result.layout_tests.begin(), result.layout_tests.end(), table.alpha);

    remarkLeftOut(result.pairwise, "accuracy", result);
    remarkLeftOut(result.pairwise, "naturalness", result);
    remarkLeftOut(result.layout_tests, "layout", result);
    remarkPower(result);
    return result;
}

}  // namespace deixis::results
