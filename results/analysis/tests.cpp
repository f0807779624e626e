#include "results/analysis/tests.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"
#include "results/statistics/rounded_fraction.hpp"

namespace deixis::results {

namespace {

std::vector<Rational> pairedDifferences(const Means& means, const std::string& a, const std::string& b) {
    std::vector<Rational> differences;
    const auto of_a = means.find(a);
    const auto of_b = means.find(b);
    if (of_a == means.end() || of_b == means.end()) return differences;
    for (const auto& [participant, mean] : of_a->second)
        if (const auto other = of_b->second.find(participant); other != of_b->second.end())
            differences.push_back(mean - other->second);
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
    constexpr double small = 2147483648.0;
    Rational sum;
    std::int64_t whole = 0;  // most scores are small whole numbers
    for (const double score : scores)
        if (score == std::floor(score) && std::abs(score) < small)
            whole += static_cast<std::int64_t>(score);
        else
            sum += exactScore(score);
    return (sum + Rational(whole)) / Rational(static_cast<std::int64_t>(scores.size()));
}

Means exactMeans(const Cells& cells) {
    Means means;
    for (const auto& [condition, by_participant] : cells)
        for (const auto& [participant, scores] : by_participant)
            means[condition].emplace_hint(means[condition].end(), participant, exactMeanOf(scores));
    return means;
}

MeansByMeasure exactMeans(const CellsByMeasure& cells) {
    MeansByMeasure means;
    for (const auto& [measure, of_measure] : cells) means[measure] = exactMeans(of_measure);
    return means;
}

std::size_t maxParticipants(const Means& means) {
    std::size_t max = 0;
    for (const auto& [condition, by_participant] : means) max = std::max(max, by_participant.size());
    return max;
}

double meanOf(const std::vector<Rational>& values) {
    return values.empty() ? 0.0 : exactMean(values).toDouble();
}

void testDifferences(Comparison& comparison, const Means& means, double level, double bound) {
    const auto differences = pairedDifferences(means, comparison.a, comparison.b);
    comparison.mean_difference = meanOf(differences);
    for (const Rational& difference : differences) comparison.differences.push_back(difference.toDouble());
    comparison.test = signedRankTest(differences, level);
    comparison.normality = shapiroWilk(differences);
    if (bound <= 0.0 || differences.empty()) return;
    const auto shifted = [&](const Rational& by) {
        std::vector<Rational> values;
        for (const Rational& difference : differences) values.push_back(difference + by);
        return signedRankTest(values, 0.0);
    };
    const Rational exactly = Rational::fromShortestDecimal(bound);
    comparison.equivalence = {bound, std::max(shifted(exactly).p_greater, shifted(-exactly).p_less)};
}

void adjustEquivalence(const std::vector<std::optional<Equivalence>*>& family, double alpha) {
    std::vector<double> p;
    for (const auto* one : family) p.push_back(*one ? (*one)->p : std::numeric_limits<double>::quiet_NaN());
    const auto adjusted = holm(p);
    for (std::size_t i = 0; i < family.size(); ++i)
        if (auto& one = *family[i]; one) {
            one->p_holm = adjusted[i];
            one->equivalent = adjusted[i] <= alpha;
        }
}

void adjustFamily(const std::vector<AdjustedTest*>& family, const std::string& name, double alpha) {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> p;
    std::vector<double> pratt;
    std::vector<double> normal;
    std::vector<std::optional<Equivalence>*> equivalence;
    int size = 0;
    for (AdjustedTest* one : family) {
        equivalence.push_back(&one->equivalence);
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
    adjustEquivalence(equivalence, alpha);
}

RowPointers pointersTo(const std::vector<ResponseRow>& rows) {
    RowPointers out;
    out.reserve(rows.size());
    for (const ResponseRow& row : rows) out.push_back(&row);
    return out;
}

CellsByMeasure cellsOf(const RowPointers& rows) {
    CellsByMeasure cells;
    for (const ResponseRow* row : rows)
        cells[row->measure][row->system][row->participant].push_back(row->value);
    return cells;
}

std::vector<Comparison> pairTests(const MeansByMeasure& means, const std::vector<Measure>& measures,
                                  const std::vector<std::string>& systems, double level, double alpha) {
    std::vector<Comparison> out;
    for (const Measure& measure : measures) {
        const auto found = means.find(measure.name);
        const Means none;
        const Means& of_measure = found == means.end() ? none : found->second;
        const std::size_t family = out.size();
        for (std::size_t i = 0; i < systems.size(); ++i)
            for (std::size_t j = i + 1; j < systems.size(); ++j) {
                Comparison& pair = out.emplace_back();
                pair.measure = measure.name;
                pair.a = systems[i];
                pair.b = systems[j];
            }
        forTests(out.size() - family, maxParticipants(of_measure), [&](std::size_t from, std::size_t to) {
            for (std::size_t i = family + from; i < family + to; ++i)
                testDifferences(out[i], of_measure, level, measure.equivalence_bound);
        });
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
        // A rating may be called preference, too.
        if (row->other_system.empty()) continue;
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

OmnibusResult omnibusTest(const Means& means, const std::string& measure,
                          const std::vector<std::string>& systems) {
    std::set<std::string> participants;
    for (const auto& [system, by_participant] : means)
        for (const auto& [participant, mean] : by_participant) participants.insert(participant);
    std::vector<std::vector<Rational>> rows;
    for (const std::string& participant : participants) {
        std::vector<Rational> row;
        for (const std::string& system : systems) {
            const auto of_system = means.find(system);
            if (of_system == means.end()) break;
            const auto mean = of_system->second.find(participant);
            if (mean == of_system->second.end()) break;
            row.push_back(mean->second);
        }
        if (row.size() == systems.size()) rows.push_back(std::move(row));
    }
    return {measure, friedmanTest(rows)};
}

}  // namespace deixis::results
