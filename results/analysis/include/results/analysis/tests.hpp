// Participants' means under conditions, and the tests that compare them; private to the analysis.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "results/analysis/analysis.hpp"
#include "results/statistics/holm.hpp"

namespace deixis::results {

/// The scores of one participant under one condition.
using Scores = std::vector<double>;

/// Condition -> participant -> scores. std::map keeps the participants in order.
using Cells = std::map<std::string, std::map<std::string, Scores>>;

/// Condition -> participant -> mean score, exact.
using Means = std::map<std::string, std::map<std::string, Rational>>;

/// By measure; the conditions are systems.
using CellsByMeasure = std::map<std::string, Cells>;
using MeansByMeasure = std::map<std::string, Means>;

using RowPointers = std::vector<const ResponseRow*>;

[[nodiscard]] RowPointers pointersTo(const std::vector<ResponseRow>& rows);

[[nodiscard]] CellsByMeasure cellsOf(const RowPointers& rows);

[[nodiscard]] Means exactMeans(const Cells& cells);
[[nodiscard]] MeansByMeasure exactMeans(const CellsByMeasure& cells);
/// Of a between-participants factor; empty if it is not known.
[[nodiscard]] std::string levelOfParticipant(const ResponseTable& table, const std::string& participant,
                                             const std::string& factor);

/// Every score under a condition.
[[nodiscard]] std::vector<double> allTrials(const Cells& cells, const std::string& condition);

/// Scores as the decimals they were given as: means that are equal on paper are equal.
[[nodiscard]] Rational exactMeanOf(const Scores& scores);

/// 0 of no values.
[[nodiscard]] double meanOf(const std::vector<Rational>& values);

/// Fills in the differences' test, their mean and their normality: participants' means under comparison.a
/// minus those under comparison.b, of the participants who have both.
/// `bound`: of equivalence; 0: none.
void testDifferences(Comparison& comparison, const Means& means, double level, double bound = 0.0);

/// Fills in the means and the test of two levels of a factor, from participants' scores by level.
void compareLevelsOf(GroupTest& out, const Factor& factor, std::size_t a, std::size_t b,
                     std::map<std::string, std::vector<Rational>>& by_level, double level,
                     double bound = 0.0);

/// Fills in p_holm and, of those that have one, the equivalence of a family.
void adjustEquivalence(const std::vector<std::optional<Equivalence>*>& family, double alpha);

/// The tests from `first` on are a family of rank-sum tests.
template <typename Test>
void adjustGroups(std::vector<Test>& tests, std::size_t first, const std::string& name, double alpha) {
    std::vector<double> p;
    std::vector<std::optional<Equivalence>*> equivalence;
    int size = 0;
    for (std::size_t i = first; i < tests.size(); ++i) {
        p.push_back(tests[i].test.p_two_sided.value_or(std::numeric_limits<double>::quiet_NaN()));
        size += tests[i].test.p_two_sided ? 1 : 0;
        equivalence.push_back(&tests[i].equivalence);
    }
    const auto adjusted = holm(p);
    for (std::size_t i = first; i < tests.size(); ++i) {
        GroupTest& one = tests[i];
        one.family = name;
        one.family_size = size;
        if (!one.test.p_two_sided) continue;
        one.p_holm = adjusted[i - first];
        one.significant = *one.p_holm <= alpha;
    }
    adjustEquivalence(equivalence, alpha);
}

/// Calls work(first, last) for all of `count` tests: on several cores where each takes long, which is so
/// where many participants are compared.
template <typename Work>
void forTests(std::size_t count, std::size_t participants, const Work& work) {
    constexpr std::size_t many_participants = 200;
    forRanges(count, participants < many_participants ? std::max<std::size_t>(count, 1) : 1, work);
}

/// How many have a mean under some condition, at least.
[[nodiscard]] std::size_t maxParticipants(const Means& means);

/// Fills in all that depends on the family, which consists of these tests.
void adjustFamily(const std::vector<AdjustedTest*>& family, const std::string& name, double alpha);

/// The tests from `first` on are a family.
template <typename Test>
void adjustFrom(std::vector<Test>& tests, std::size_t first, const std::string& name, double alpha) {
    std::vector<AdjustedTest*> family;
    for (std::size_t i = first; i < tests.size(); ++i) family.push_back(&tests[i]);
    adjustFamily(family, name, alpha);
}

/// All pairs of systems in each measure, a family each.
[[nodiscard]] std::vector<Comparison> pairTests(const MeansByMeasure& means,
                                                const std::vector<Measure>& measures,
                                                const std::vector<std::string>& systems, double level,
                                                double alpha);

/// Participants' answers to the pairs of systems that stood side by side, whichever stood left; positive for
/// the first of the pair. A pair: places in the study's order, the lower one first.
using PreferencesByPair = std::map<std::pair<std::size_t, std::size_t>, std::map<std::string, Scores>>;

[[nodiscard]] PreferencesByPair preferencesByPair(const RowPointers& rows,
                                                  const std::vector<std::string>& systems);

/// All of these pairs: one family.
[[nodiscard]] std::vector<PreferenceResult> preferenceTests(const RowPointers& rows,
                                                            const std::vector<std::string>& systems,
                                                            double level, double alpha);

/// Of the participants who have scores under each of the systems.
[[nodiscard]] OmnibusResult omnibusTest(const Means& means, const std::string& measure,
                                        const std::vector<std::string>& systems);

}  // namespace deixis::results
