#include "analysis_tables_ratings.hpp"

#include <utility>

#include "analysis_table_parts.hpp"

namespace deixis::results {

namespace {

using enum ColumnType;

/// As the tests' columns, with Z in print, and without the interval, which is not computed.
std::vector<PlainColumn> withZ(std::vector<PlainColumn> columns) {
    for (PlainColumn& column : columns) {
        if (column.name == "z") {
            column.print = Print::plain;
            column.heading = "$Z$";
        }
        if (column.name == "hodges_lehmann_lower") column.print = Print::no;
    }
    return columns;
}

std::vector<PlainColumn> pairColumns() {
    return {{"a", text, Print::plain},
            {"b", text, Print::plain},
            {"median_a", number, Print::plain, "median A"},
            {"median_b", number, Print::plain, "median B"}};
}

std::vector<PlainColumn> trialColumns() {
    return withMore<PlainColumn>({{"measure", text, Print::heading}, {"system", text, Print::plain}},
                                 pairColumns());
}

}  // namespace

PlainTable ratingPairsTable(const AnalysisResult& result) {
    PlainTable out{
        "pairwise_ratings", units::ratings,
        "Pairs of systems by single ratings (pseudo-replicated: p is too small): signed-rank tests",
        withMore(withMore(withMore<PlainColumn>({{"measure", text, Print::heading}}, pairColumns()),
                          {{"participants", whole}, {"n_missing", whole}, {"mean_difference", number}}),
                 withZ(testColumns()))};
    for (const RatingComparison& one : result.rating_pairs)
        out.rows.push_back(
            withMore<PlainCell>({one.measure, one.a, one.b, plainCell(one.median_a), plainCell(one.median_b),
                                 wholeCell(one.participants), wholeCell(one.n_missing),
                                 knownCell(one.test.n_pairs > 0, one.mean_difference)},
                                testCells(one)));
    return out;
}

PlainTable authorTrialsTable(const AnalysisResult& result) {
    PlainTable out{"author_trials", units::ratings,
                   "Ratings by the author's trial in which the clips were made (pseudo-replicated: p is too "
                   "small): rank-sum tests",
                   withMore(trialColumns(), withZ(groupColumns()))};
    for (const AuthorTrialResult& one : result.author_trials)
        out.rows.push_back(withMore<PlainCell>(
            {one.measure, one.system, one.a, one.b, PlainCell(one.median_a), PlainCell(one.median_b)},
            groupCells(one)));
    return out;
}

PlainTable authorTrialsPairedTable(const AnalysisResult& result) {
    PlainTable out{"author_trials_by_participants", units::means,
                   "Participants' mean ratings by the author's trial in which the clips were made: "
                   "signed-rank tests",
                   withMore(withMore(trialColumns(), {{"mean_difference", number}}), testColumns())};
    for (const MedianComparison& one : result.author_trials_paired)
        out.rows.push_back(withMore<PlainCell>(
            {one.measure, one.system, one.a, one.b, plainCell(one.median_a), plainCell(one.median_b),
             knownCell(one.test.n_pairs > 0, one.mean_difference)},
            testCells(one)));
    return out;
}

std::vector<PlainTable> ratingTables(const AnalysisResult& result) {
    return {ratingPairsTable(result), authorTrialsTable(result), authorTrialsPairedTable(result)};
}

}  // namespace deixis::results
