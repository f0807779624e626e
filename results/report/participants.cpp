#include "participants.hpp"

#include <fmt/core.h>

#include <functional>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

namespace {

const std::vector<Shown> group_columns{
    "a", "b", "n_both", "mean_a", "mean_b", "hodges_lehmann", "cliffs_delta", "a12", "p", "p_holm"};

std::vector<Shown> withGroups(std::vector<Shown> shown) {
    shown.insert(shown.end(), group_columns.begin(), group_columns.end());
    return shown;
}

/// Those that compare somebody.
Table tested(Table table) {
    const std::size_t p = table.at("p");
    std::erase_if(table.rows, [&](const Table::Row& row) { return row.cells[p].empty(); });
    table.column("p_holm").marked = true;
    return table;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> participantEntries(const AnalysisResult& result) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const FieldResult& field : result.fields)
        out.emplace_back(escapeHtml(propertyLabel(field.field)), fieldText(field));
    std::string times;
    for (const SessionTimeResult& one : result.session_times)
        times += fmt::format(
            "{}{}median {} ({} to {}) minutes, n = {}", times.empty() ? "" : "; ",
            one.factor.empty() ? std::string()
                               : fmt::format("{} {}: ", escapeHtml(one.factor), escapeHtml(one.level)),
            fixedText(one.median_min, 1), fixedText(one.min_min, 1), fixedText(one.max_min, 1), one.n);
    if (!times.empty()) out.emplace_back("Session time", times);
    return out;
}

std::string fieldText(const FieldResult& field) {
    if (field.options.empty())
        return fmt::format("median {:g} ({:g} to {:g}), n = {}", field.median, field.min, field.max, field.n);
    std::string out;
    for (const auto& [option, n] : field.options)
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", escapeHtml(inWords(option)), n);
    return out;
}

std::string scoreTestsHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    std::string out;
    if (!result.score_changes.empty())
        out += tableHtml(
            tables::scoreChanges(result),
            "Repeated scores: the later (A) minus the earlier (B) for participants who have both, "
            "signed-rank "
            "test, Holm's correction over the scores of the two stages. Bold: significant.",
            {"score", "a", "b", "mean_a", "mean_b", "n", "hodges_lehmann", "rank_biserial", "p", "p_holm"},
            numbering, dense_table);
    if (!result.score_groups.empty())
        out += tableHtml(
            tables::scoreGroups(result),
            "Scores by groups of participants: rank-sum tests, Holm's correction over the scores of a "
            "stage and all pairs of groups of one factor. Bold: significant.",
            withGroups({"stage", "score"}), numbering, dense_table);
    return out;
}

std::string timeTestsHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    std::string out;
    if (const Table tests = tested(tables::timeTests(result)); !tests.rows.empty())
        out += tableHtml(
            tests,
            "Response times of each pair of systems: participants' median times in seconds, signed-rank "
            "tests, Holm's correction over the pairs of one measure. Bold: significant.",
            {"measure", "a", "b", "n", "hodges_lehmann", "rank_biserial", "p", "p_holm"}, numbering,
            dense_table);
    if (const Table groups = tested(tables::timeGroups(result)); !groups.rows.empty())
        out += tableHtml(
            groups,
            "Response times of groups: participants' median times in seconds over all systems, rank-sum "
            "tests, Holm's correction over the pairs of groups of one factor in one measure. Bold: "
            "significant.",
            withGroups({"measure"}), numbering, dense_table);
    return out;
}

}  // namespace deixis::results
