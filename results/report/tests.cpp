#include "tests.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "computed.hpp"
#include "interactions.hpp"
#include "ratings.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

/// Of a table of signed-rank tests: what stands behind the columns that name its rows.
std::vector<Shown> testColumns(std::vector<Shown> names) {
    names.insert(names.end(), {"n", "hodges_lehmann", "rank_biserial", "p", "p_holm", "verdict"});
    return names;
}

/// The ranks behind the table called `name`, folded away.
std::string rankDetails(const Table& tests, const std::string& name, std::vector<Shown> shown,
                        const TableLook& look) {
    shown.insert(shown.end(), {"n_zero", "n_positive", "n_negative", "ties", "w_plus", "w_minus", "z",
                               "p_pratt", "p_holm_pratt", "shapiro_p", "method"});
    return foldedTable(tests, "Ranks, zeros and normality", name, shown, look);
}

/// What the marks in a table's last column mean, and its family.
template <typename Tests>
std::string tableFoot(const Tests& tests, const AnalysisResult& result) {
    const auto any = [&](auto flag) {
        return std::any_of(tests.begin(), tests.end(), [&](const auto* one) { return one->*flag; });
    };
    double lowest = 1.0;
    double highest = 0.0;
    for (const auto* one : tests)
        if (const auto& level = one->test.hodges_lehmann.level; level) {
            lowest = std::min(lowest, *level);
            highest = std::max(highest, *level);
        }
    std::string out = fmt::format("Holm's family: {}, \u03b1\u00a0=\u00a0{}.",
                                  counted(tests.front()->family_size, "test", "tests"), result.alpha);
    if (highest > 0.0)
        out += fmt::format(
            " Shift: Hodges\u2013Lehmann, with the interval of the shifts that the test does not reject, at "
            "{}\u00a0% (requested: {:g}\u00a0%, before Holm's correction; a round bracket: without that "
            "end); "
            "r: rank-biserial.",
            highest - lowest < 5e-4 ? fmt::format("{:.1f}", 100.0 * highest)
                                    : fmt::format("{:.1f} to {:.1f}", 100.0 * lowest, 100.0 * highest),
            100.0 * result.level);
    if (any(&AdjustedTest::depends_on_zeros))
        out += " \u2020 The decision would differ with Pratt's treatment of zeros.";
    if (any(&AdjustedTest::out_of_reach))
        out +=
            " \u2021 The smallest p possible with so few non-zero differences, times the number of tests, "
            "exceeds \u03b1: significant only if other pairs have a smaller p.";
    return noteHtml(out);
}

/// Empty where no participant has answers to compare.
std::string testTable(const std::vector<Comparison>& comparisons, const Table& all, const Measure& measure,
                      const std::string& factor, const std::string& caption, const AnalysisResult& result,
                      Numbering& numbering) {
    std::vector<const Comparison*> rows;
    bool tested = false;
    for (const Comparison& one : comparisons)
        if (one.measure == measure.name && one.factor == factor) {
            rows.push_back(&one);
            tested = tested || one.test.n_pairs > 0;
        }
    if (!tested) return "";
    const Table table = all.where("measure", measure.name).where("factor", factor);
    std::vector<Shown> names{"a", "b"};
    if (!factor.empty()) names.insert(names.begin(), "system");
    const TableLook look{true, !factor.empty()};
    std::vector<Shown> shown = names;
    shown.emplace_back("mean_difference");
    const std::string out = tableHtml(
        table,
        fmt::format("{}{} n counts participants.", caption,
                    measure.kind == MeasureKind::accuracy ? " (A \u2212 B in percentage points)." : "."),
        testColumns(std::move(shown)), numbering, look);
    return out + tableFoot(rows, result) + rankDetails(table, numbering.name(), names, look);
}

/// `where`: of several studies, " in STUDY".
std::string preferenceTable(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    if (result.preferences.empty()) return "";
    std::vector<const PreferenceResult*> rows;
    for (const PreferenceResult& pair : result.preferences) rows.push_back(&pair);
    const Table table = tables::preferences(result);
    const TableLook look{true, false};
    const std::string out = tableHtml(
        table,
        fmt::format("Preferences{}: answers for A, for neither and for B; mean of the participants' means "
                    "(positive: A). n counts participants.",
                    where),
        testColumns({"a", "b", "prefers_a", "equal", "prefers_b", "mean"}), numbering, look);
    return out + tableFoot(rows, result) + rankDetails(table, numbering.name(), {"a", "b"}, look);
}

std::string omnibusTable(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    Table table = tables::omnibus(result);
    const std::size_t of = table.at("measure"), chi2 = table.at("chi2");
    std::erase_if(table.rows, [&](const auto& row) {
        return row.cells[chi2].empty() || !tellsFriedman(result, row.cells[of].text());
    });
    if (table.rows.empty()) return "";
    return tableHtml(
        table,
        fmt::format("All systems at once{}, by Friedman's test of the participants' means. n counts "
                    "participants with answers under every system.",
                    where),
        {"measure", "n", "chi2", "df", "p", "kendalls_w", "f_or_infinite", "both_df", "p_f"}, numbering);
}

std::string pairTables(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    std::string out;
    if (result.systems.size() > 1)
        for (const Measure& measure : result.measures) {
            out += testTable(result.pairwise, tables::pairwise(result), measure, "",
                             capitalised(measure.name) + ", all pairs of systems" + where, result, numbering);
            out += ratingPairsHtml(result, measure, where, numbering);
        }
    return out;
}

}  // namespace

std::string studyTestsHtml(const AnalysisResult& study, Numbering& numbering) {
    if (study.participants < 2)
        return paragraphHtml(fmt::format("In {} one participant answered: there is nothing to test.",
                                         escapeHtml(study.table.study_name)));
    const std::string where = " in " + study.table.study_name;
    // One after another: the tables count.
    std::string out = omnibusTable(study, where, numbering);
    out += pairTables(study, where, numbering);
    out += systemsApartHtml(study, where, numbering);
    out += preferenceTable(study, where, numbering);
    return out + authorTrialsHtml(study, where, numbering);
}

Section testsSection(const AnalysisResult& result, Numbering& numbering) {
    const std::string where = result.by_study.empty() ? "" : ", all studies pooled";
    const std::string heading = "Tests" + where;
    if (result.participants < 2)
        return {
            heading,
            paragraphHtml("The tests compare participants' means over participants. With one participant "
                          "there is nothing to test yet; the tests appear from the second participant on.")};
    std::string html = omnibusTable(result, where, numbering);
    html += pairTables(result, where, numbering);
    const Table level_tests = tables::levelTests(result);
    for (const Measure& measure : result.measures)
        for (const Factor& factor : withinFactors(result.table))
            html += testTable(result.level_tests, level_tests, measure, factor.name,
                              fmt::format("{}, levels of {} within each system (all: over the systems)",
                                          capitalised(measure.name), factor.name),
                              result, numbering);
    html += interactionsHtml(result, numbering);
    html += equivalenceHtml(result, numbering);
    html += preferenceTable(result, where, numbering);
    html += authorTrialsHtml(result, where, numbering);
    return {heading, html};
}

}  // namespace deixis::results
