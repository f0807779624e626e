#include "analysis_tests.hpp"

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
    int size = 0;
    for (const AdjustedTest* one : family) {
        const bool tested = one->test.n_pairs > 0;
        size += tested ? 1 : 0;
        p.push_back(tested ? one->test.p_two_sided : missing);
        pratt.push_back(tested ? one->test.pratt_p_two_sided : missing);
    }
    const auto adjusted = holm(p);
    const auto adjusted_pratt = holm(pratt);
    for (std::size_t i = 0; i < family.size(); ++i) {
        AdjustedTest& one = *family[i];
        one.family = name;
        one.family_size = size;
        if (one.test.n_pairs == 0) continue;
        one.p_holm = adjusted[i];
        one.p_holm_pratt = adjusted_pratt[i];
        one.significant = adjusted[i] <= alpha;
        one.depends_on_zeros = one.significant != (adjusted_pratt[i] <= alpha);
        one.out_of_reach = one.test.smallest_p * size > alpha;
    }
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
