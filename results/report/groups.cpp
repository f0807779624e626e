// Groups of participants, and questionnaires.
#include <fmt/core.h>

#include <algorithm>

#include "participants.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

/// A table of group tests behind the columns that name its rows; empty where none of them has a p.
std::string groupTable(const Table& table, const std::string& caption, std::vector<Shown> shown,
                       const AnalysisResult& result, Numbering& numbering) {
    const std::size_t p = table.at("p");
    if (std::all_of(table.rows.begin(), table.rows.end(),
                    [&](const Table::Row& row) { return row.cells[p].empty(); }))
        return "";
    shown.insert(shown.end(), {"hodges_lehmann", "cliffs_delta", "a12", "p", "p_holm"});
    const auto family = *table.rows.back().cells[table.at("family_size")].as<long long>();
    return tableHtml(table,
                     caption +
                         " \u03b4: Cliff's delta; A\u2081\u2082: the probability that A is above B, with "
                         "ties counting half.",
                     shown, numbering, dense_table) +
           noteHtml(fmt::format("Holm's family: {}, \u03b1\u00a0=\u00a0{}; bold: significant. Shift: "
                                "Hodges\u2013Lehmann with the interval of the shifts that the test does not "
                                "reject (requested: {:g}\u00a0%; a round bracket: without that end).",
                                counted(static_cast<int>(family), "test", "tests"), result.alpha,
                                100.0 * result.level));
}

std::string meansOfGroups(const AnalysisResult& result, const Factor& factor, const Measure& measure,
                          Numbering& numbering) {
    Table table = tables::between(result).where("factor", factor.name).where("measure", measure.name);
    for (Table::Row& row : table.rows) row.all = row.cells[table.at("system")].text() == "all";
    return groupTable(
        table,
        fmt::format("{} by {}: participants' means, rank-sum test (exact up to 400 participants). "
                    "\"all\": the mean of a participant's means under each system.",
                    capitalised(measure.name), factor.name),
        {"system", "a", "b", "n_both", "mean_a", "mean_b"}, result, numbering);
}

/// Each system and group one line above the other.
Table twoLines(Table table) {
    const auto join = [&](const char* name, ColumnKind kind, const char* label, const char* first,
                          const char* second, const char* between) {
        const std::size_t a = table.at(first);
        const std::size_t b = table.at(second);
        table.columns.push_back({name, kind, {.label = label}});
        for (Table::Row& row : table.rows) {
            const std::string above = cellText(table.columns[a], row.cells[a], row.percent);
            row.cells.emplace_back(above + "\n" + between +
                                   cellText(table.columns[b], row.cells[b], row.percent));
        }
    };
    join("systems", ColumnKind::text, "Systems", "system", "other_system", "against ");
    join("groups", ColumnKind::text, "Groups", "a", "b", "");
    join("counts", ColumnKind::number, "n", "n_a", "n_b", "");
    join("answers", ColumnKind::number, "Answers", "shares_a", "shares_b", "");
    join("means", ColumnKind::number, "Mean", "mean_a", "mean_b", "");
    return table;
}

std::string preferencesOfGroups(const AnalysisResult& result, const Factor& factor, Numbering& numbering) {
    return groupTable(
        twoLines(tables::preferencesBetween(result).where("factor", factor.name)),
        fmt::format(
            "Preferences by {}; first line: group A, second: B. Answers for the first system / for neither / "
            "for the other; mean of the participants' net preferences (from 2, clearly the first, to "
            "\u22122), and their rank-sum test (exact up to 400 participants).",
            factor.name),
        {"systems", "groups", "counts", "answers", "means"}, result, numbering);
}

}  // namespace

std::string systemsApartHtml(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    const Table all = tables::between(result).where("factor", systems_between);
    std::string out;
    for (const Measure& measure : result.measures)
        out += groupTable(
            all.where("measure", measure.name),
            fmt::format("{}{}: systems that no participant saw both of, as groups of participants: "
                        "rank-sum test of participants' means (exact up to 400 participants).",
                        capitalised(measure.name), where),
            {"a", "b", "n_a", "n_b", "mean_a", "mean_b"}, result, numbering);
    return out;
}

Section betweenSection(const AnalysisResult& result, Numbering& numbering) {
    std::string out =
        systemsApartHtml(result, result.by_study.empty() ? "" : ", all studies pooled", numbering);
    for (const Factor& factor : result.table.between) {
        for (const Measure& measure : result.measures)
            out += meansOfGroups(result, factor, measure, numbering);
        if (!result.preferences_between.empty()) out += preferencesOfGroups(result, factor, numbering);
    }
    return {"Groups of participants", out};
}

Section scoresSection(const AnalysisResult& result, Numbering& numbering) {
    if (result.scores.empty()) return {};
    std::vector<Shown> shown{"stage", "score", "n", "mean", "sd", "q25", "median", "q75"};
    if (!result.table.between.empty()) shown.insert(shown.begin() + 2, "group");
    // One after another: the tables count.
    const std::string out = tableHtml(tables::scores(result), "Scores over participants.", shown, numbering);
    return {"Questionnaires", out + scoreTestsHtml(result, numbering)};
}

std::string pooledHtml(const AnalysisResult& result, Numbering& numbering) {
    Table table = tables::pooledRatings(result);
    std::erase_if(table.rows, [&](const Table::Row& row) {
        return !hasManySteps(measureOf(result, row.cells[table.at("measure")].text()));
    });
    if (table.rows.empty()) return "";
    return tableHtml(table,
                     fmt::format("Single {0}, pseudo-replicated: a participant's {0} are correlated, so this "
                                 "table is for description and supports no test.",
                                 hasRatingsOnly(result) ? "ratings" : "answers"),
                     {"measure", "system", "n", "mean", "sd", "q05", "q25", "median", "q75", "q95"},
                     numbering);
}

}  // namespace deixis::results
