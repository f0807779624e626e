// The comparisons of systems with answers that the headline leaves out, and without some that it takes.
#include <unordered_set>
#include <utility>

#include "analysis_details.hpp"
#include "analysis_tests.hpp"

namespace deixis::results {

namespace {

/// The pairs of systems of one choice of answers.
struct PairsOfChoice {
    std::vector<Comparison> pairwise;
    std::vector<PreferenceResult> preferences;
    AnswerCounts counts;
};

AnswerCounts countsOf(const RowPointers& rows) {
    std::unordered_set<Name> participants;
    Name last;
    for (const ResponseRow* row : rows)
        if (std::exchange(last, row->participant) != row->participant) participants.insert(row->participant);
    return {static_cast<int>(participants.size()), static_cast<int>(rows.size())};
}

PairsOfChoice testChoice(const RowPointers& rows, const AnalysisResult& result) {
    // Mostly nobody is left out and nothing is in doubt: the answers are those of the headline.
    if (rows.size() == result.table.rows.size())
        return {result.pairwise, result.preferences, result.headline_answers};
    const auto& systems = result.table.systems;
    const double level = result.options.level;
    return {pairTests(exactMeans(cellsOf(rows)), result.measures, systems, level, result.alpha),
            preferenceTests(rows, systems, level, result.alpha), countsOf(rows)};
}

/// Without answers it is a test without pairs.
AdjustedTest preferenceIn(const PairsOfChoice& choice, const PreferenceResult& pair) {
    for (const PreferenceResult& one : choice.preferences)
        if (one.a == pair.a && one.b == pair.b) return one;
    return {};
}

}  // namespace

void compareOtherAnswers(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const std::unordered_set<Name> failed(table.failed_checks.begin(), table.failed_checks.end());
    RowPointers headline;
    RowPointers without;
    for (const ResponseRow& row : table.rows) {
        headline.push_back(&row);
        if (row.marked.empty() && !failed.contains(row.participant)) without.push_back(&row);
    }
    RowPointers with = headline;
    for (const ResponseRow& row : table.left_out_rows) with.push_back(&row);
    result.headline_answers = countsOf(headline);
    const PairsOfChoice with_left_out = testChoice(with, result);
    const PairsOfChoice without_doubtful = testChoice(without, result);
    result.answers_with_left_out = with_left_out.counts;
    result.answers_without_doubtful = without_doubtful.counts;

    const auto add = [&](const std::string& measure, const std::string& a, const std::string& b,
                         const AdjustedTest& as_in_headline, const AdjustedTest& more,
                         const AdjustedTest& fewer) {
        result.sensitivity.push_back({measure, a, b, as_in_headline, more, fewer,
                                      as_in_headline.significant != more.significant,
                                      as_in_headline.significant != fewer.significant});
    };
    for (std::size_t i = 0; i < result.pairwise.size(); ++i) {
        const Comparison& pair = result.pairwise[i];
        add(pair.measure, pair.a, pair.b, pair, with_left_out.pairwise[i], without_doubtful.pairwise[i]);
    }
    for (const PreferenceResult& pair : result.preferences)
        add("preference", pair.a, pair.b, pair, preferenceIn(with_left_out, pair),
            preferenceIn(without_doubtful, pair));
}

}  // namespace deixis::results
