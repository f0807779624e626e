#include "analysis_tests.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <set>

#include "results/descriptive.hpp"
#include "results/holm.hpp"

namespace deixis::results {

namespace {

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

}  // namespace

std::string levelOfParticipant(const ResponseTable& table, const std::string& participant,
                               const std::string& factor) {
    const auto groups = table.groups.find(participant);
    if (groups == table.groups.end()) return "";
    const auto level = groups->second.find(factor);
    return level == groups->second.end() ? "" : level->second;
}

std::vector<double> allTrials(const Cells& cells, const std::string& condition) {
    std::vector<double> trials;
    if (const auto cell = cells.find(condition); cell != cells.end())
        for (const auto& [participant, scores] : cell->second)
            trials.insert(trials.end(), scores.begin(), scores.end());
    return trials;
}

Rational exactMeanOf(const Scores& scores) {
    Rational sum;
    for (const double score : scores) sum += Rational::fromShortestDecimal(score);
    return sum / Rational(static_cast<std::int64_t>(scores.size()));
}

double meanOf(const std::vector<Rational>& values) {
    return values.empty() ? 0.0 : exactMean(values).toDouble();
}

void testDifferences(Comparison& comparison, const Cells& cells, double level) {
    const auto differences = pairedDifferences(cells, comparison.a, comparison.b);
    comparison.mean_difference = meanOf(differences);
    for (const Rational& difference : differences) comparison.differences.push_back(difference.toDouble());
    comparison.test = signedRankTest(differences, level);
    comparison.normality = shapiroWilk(differences);
}

void adjustFamily(const std::vector<AdjustedTest*>& family, const std::string& name, double alpha) {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> p;
    std::vector<double> pratt;
    std::vector<double> normal;
    int size = 0;
    for (const AdjustedTest* one : family) {
        const bool tested = one->test.n_pairs > 0;
        size += tested ? 1 : 0;
        p.push_back(tested ? one->test.p_two_sided : missing);
        pratt.push_back(tested ? one->test.pratt_p_two_sided : missing);
        normal.push_back(tested ? one->test.normal_p_two_sided : missing);
    }
    const auto adjusted = holm(p);
    const auto adjusted_pratt = holm(pratt);
    const auto adjusted_normal = holm(normal);
    for (std::size_t i = 0; i < family.size(); ++i) {
        AdjustedTest& one = *family[i];
        one.family = name;
        one.family_size = size;
        if (one.test.n_pairs == 0) continue;
        one.p_holm = adjusted[i];
        one.p_holm_pratt = adjusted_pratt[i];
        one.p_holm_normal = adjusted_normal[i];
        one.significant = adjusted[i] <= alpha;
        one.depends_on_zeros = one.significant != (adjusted_pratt[i] <= alpha);
        one.depends_on_approximation = one.significant != (adjusted_normal[i] <= alpha);
        one.out_of_reach = one.test.smallest_p * size > alpha;
    }
}

CellsByMeasure cellsOf(const RowPointers& rows) {
    CellsByMeasure cells;
    for (const ResponseRow* row : rows)
        cells[row->measure][row->system][row->participant].push_back(row->value);
    return cells;
}

std::vector<Comparison> pairTests(const CellsByMeasure& cells, const std::vector<Measure>& measures,
                                  const std::vector<std::string>& systems, double level, double alpha) {
    std::vector<Comparison> out;
    for (const Measure& measure : measures) {
        const auto found = cells.find(measure.name);
        const Cells none;
        const std::size_t family = out.size();
        for (std::size_t i = 0; i < systems.size(); ++i)
            for (std::size_t j = i + 1; j < systems.size(); ++j) {
                Comparison& pair = out.emplace_back();
                pair.measure = measure.name;
                pair.a = systems[i];
                pair.b = systems[j];
                testDifferences(pair, found == cells.end() ? none : found->second, level);
            }
        adjustFrom(out, family, fmt::format("{}: pairs of systems", measure.name), alpha);
    }
    return out;
}

PreferencesByPair preferencesByPair(const RowPointers& rows, const std::vector<std::string>& systems) {
    const auto order = [&](const std::string& system) {
        return static_cast<std::size_t>(std::find(systems.begin(), systems.end(), system) - systems.begin());
    };
    PreferencesByPair pairs;
    for (const ResponseRow* row : rows) {
        if (row->measure != "preference") continue;
        const auto left = order(row->system);
        const auto right = order(row->other_system);
        // Positive: for the one that comes first in the study.
        const double for_first = left < right ? -row->value : row->value;
        pairs[{std::min(left, right), std::max(left, right)}][row->participant].push_back(for_first);
    }
    return pairs;
}

std::vector<PreferenceResult> preferenceTests(const RowPointers& rows,
                                              const std::vector<std::string>& systems, double level,
                                              double alpha) {
    std::vector<PreferenceResult> out;
    for (const auto& [pair, participants] : preferencesByPair(rows, systems)) {
        PreferenceResult& one = out.emplace_back();
        one.a = systems[pair.first];
        one.b = systems[pair.second];
        std::vector<Rational> means;
        for (const auto& [participant, scores] : participants) {
            means.push_back(exactMeanOf(scores));
            for (const double score : scores)
                (score > 0.0 ? one.prefers_a : score < 0.0 ? one.prefers_b : one.ties) += 1;
        }
        one.mean = meanOf(means);
        one.test = signedRankTest(means, level);
        one.normality = shapiroWilk(means);
    }
    adjustFrom(out, 0, "preference: pairs of systems", alpha);
    return out;
}

OmnibusResult omnibusTest(const Cells& cells, const std::string& measure,
                          const std::vector<std::string>& systems) {
    std::set<std::string> participants;
    for (const auto& [system, by_participant] : cells)
        for (const auto& [participant, scores] : by_participant) participants.insert(participant);
    std::vector<std::vector<Rational>> rows;
    for (const std::string& participant : participants) {
        std::vector<Rational> row;
        for (const std::string& system : systems) {
            const auto cell = cells.find(system);
            if (cell == cells.end()) break;
            const auto scores = cell->second.find(participant);
            if (scores == cell->second.end()) break;
            row.push_back(exactMeanOf(scores->second));
        }
        if (row.size() == systems.size()) rows.push_back(std::move(row));
    }
    return {measure, friedmanTest(rows)};
}

}  // namespace deixis::results
