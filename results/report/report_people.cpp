#include "report_people.hpp"

#include <fmt/core.h>

#include <functional>

#include "results/page/page.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

std::string twoDecimals(double value) {
    return fixedText(value, 2);
}

/// The groups, their numbers and means, and the test.
std::string rankSumCells(const GroupTest& one) {
    return fmt::format(
               "<td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}, {}</td><td>{}</td><td>{}</td>",
               escapeHtml(one.a), escapeHtml(one.b), one.test.n_a, one.test.n_b,
               groupMean(twoDecimals, one.test.n_a, one.mean_a),
               groupMean(twoDecimals, one.test.n_b, one.mean_b)) +
           groupTestCells(one, twoDecimals);
}

std::string groupColumns() {
    return std::string(
               "<th class=\"text\">A</th><th class=\"text\">B</th><th>n</th><th>Mean A</th>"
               "<th>Mean B</th>") +
           group_test_columns;
}

std::string signedRankRest(const AdjustedTest& one) {
    return fmt::format("{}<td class=\"{}\">{}</td>", signedRankCells(one, twoDecimals),
                       one.significant ? "sig" : "not", pText(one.p_holm));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> peopleEntries(const AnalysisResult& result) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const FieldResult& field : result.fields)
        out.emplace_back(escapeHtml(propertyLabel(field.field)), fieldText(field));
    std::string times;
    for (const SessionTimeResult& one : result.session_times)
        times += fmt::format(
            "{}{}median {} ({} to {}) minutes, n = {}", times.empty() ? "" : "; ",
            one.factor.empty() ? std::string()
                               : fmt::format("{} {}: ", escapeHtml(one.factor), escapeHtml(one.level)),
            fixedText(one.median_min, 1), fixedText(one.least_min, 1), fixedText(one.greatest_min, 1), one.n);
    if (!times.empty()) out.emplace_back("Session time", times);
    return out;
}

std::string fieldText(const FieldResult& field) {
    if (field.options.empty())
        return fmt::format("median {:g} ({:g} to {:g}), n = {}", field.median, field.least, field.greatest,
                           field.n);
    std::string out;
    for (const auto& [option, n] : field.options)
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", escapeHtml(spaced(option)), n);
    return out;
}

std::string scoreTestsHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    std::string out;
    if (!result.score_changes.empty()) {
        out += openTable(
            units::scores,
            "Scores asked again: the later (A) less the earlier (B) of the participants who have both, "
            "signed-rank test, Holm's correction over the scores of the two stages. Bold: significant.",
            std::string("<th>Score</th><th class=\"text\">A</th><th class=\"text\">B</th><th>Mean A</th>"
                        "<th>Mean B</th>") +
                signed_rank_columns,
            numbering, TableWidth::dense);
        for (const ScoreChange& one : result.score_changes)
            out += fmt::format(
                "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>"
                "<td>{}</td>{}</tr>",
                escapeHtml(one.score), escapeHtml(one.a), escapeHtml(one.b), twoDecimals(one.mean_a),
                twoDecimals(one.mean_b), signedRankRest(one));
        out += close_table;
    }
    if (!result.score_groups.empty()) {
        out +=
            openTable(units::scores,
                      "Scores by groups of participants: rank-sum tests, Holm's correction over the scores "
                      "of a stage and all pairs of groups of one factor. Bold: significant.",
                      std::string("<th>Stage</th><th class=\"text\">Score</th>") + groupColumns(), numbering,
                      TableWidth::dense);
        for (const ScoreGroupResult& one : result.score_groups)
            out += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td>{}</tr>",
                               escapeHtml(one.stage), escapeHtml(one.score), rankSumCells(one));
        out += close_table;
    }
    return out;
}

std::string timeTestsHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    std::string rows;
    for (const Comparison& one : result.time_tests)
        if (one.test.n_pairs > 0)
            rows += fmt::format(
                "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td>{}</tr>",
                escapeHtml(capitalised(one.measure)), escapeHtml(one.a), escapeHtml(one.b),
                signedRankRest(one));
    std::string out;
    if (!rows.empty())
        out += openTable(units::median_times,
                         "Response times of each pair of systems: participants' median times in seconds, "
                         "signed-rank tests, Holm's correction over the pairs of one measure. Bold: "
                         "significant.",
                         std::string("<th>Measure</th><th class=\"text\">A</th><th class=\"text\">B</th>") +
                             signed_rank_columns,
                         numbering, TableWidth::dense) +
               rows + close_table;
    rows.clear();
    for (const BetweenResult& one : result.time_groups)
        if (one.test.p_two_sided)
            rows += fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>", escapeHtml(capitalised(one.measure)),
                                rankSumCells(one));
    if (!rows.empty())
        out += openTable(units::median_times,
                         "Response times of groups: participants' median times in seconds over all systems, "
                         "rank-sum tests, Holm's correction over the pairs of groups of one factor in one "
                         "measure. Bold: significant.",
                         std::string("<th>Measure</th>") + groupColumns(), numbering, TableWidth::dense) +
               rows + close_table;
    return out;
}

}  // namespace deixis::results
