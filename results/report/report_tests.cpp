#include "report_tests.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "report_details.hpp"
#include "report_interactions.hpp"
#include "report_ratings.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

std::string verdict(const AdjustedTest& tested) {
    if (tested.test.n_pairs == 0) return "<td class=\"text not\">no participant has both</td>";
    const std::string mark = tested.depends_on_zeros ? " &#8224;" : tested.out_of_reach ? " &#8225;" : "";
    if (!tested.significant) return fmt::format("<td class=\"text not\">not significant{}</td>", mark);
    return fmt::format("<td class=\"text sig\">{} higher{}</td>",
                       tested.test.w_plus > tested.test.w_minus ? "A" : "B", mark);
}

/// The test, and who is higher.
std::string effectCells(const AdjustedTest& tested, const Measure& measure) {
    return fmt::format("{}<td>{}</td>{}", signedRankCells(tested, scoreTextOf(measure)), pText(tested.p_holm),
                       verdict(tested));
}
std::string effectColumns() {
    return std::string(signed_rank_columns) + "<th class=\"text\">Result</th>";
}

constexpr const char* rank_columns =
    "<th>zeros</th><th>+</th><th>&#8722;</th><th>ties</th><th>W+</th><th>W&#8722;</th><th>z</th>"
    "<th>p (Pratt)</th><th>p (Pratt, Holm)</th><th>Shapiro&#8211;Wilk p</th><th class=\"text\">Method</th>";

std::string rankCells(const AdjustedTest& tested) {
    const SignedRankTest& test = tested.test;
    return fmt::format(
        "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td class=\"text\">{}</td>",
        test.n_zero, test.n_positive, test.n_negative, test.ties, test.w_plus, test.w_minus,
        test.z ? signedText(fmt::format("{:.2f}", *test.z)) : std::string(dash),
        test.n_pairs > 0 ? pText(test.pratt_p_two_sided) : std::string(dash), pText(tested.p_holm_pratt),
        pText(tested.normality.p), test.method);
}

/// The ranks behind the table called `name`, folded away. `first_cells`: what names each row.
template <typename Tests>
std::string rankDetails(TableUnit unit, const Tests& tests, const std::string& name,
                        const std::string& first_columns, const std::vector<std::string>& first_cells) {
    std::string out = fmt::format(
        "<details><summary>Ranks, zeros and normality</summary>{}<table "
        "class=\"dense\"><caption><span>{}</span></caption><thead><tr>{}{}</tr></thead><tbody>",
        openScroll(name + ": ranks, zeros and normality"), unitText(unit), first_columns, rank_columns);
    for (std::size_t i = 0; i < tests.size(); ++i)
        out += fmt::format("<tr>{}{}</tr>", first_cells[i], rankCells(*tests[i]));
    return out + close_table + "</details>";
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
    std::string out = fmt::format("<p class=\"small\">Holm's family: {}, &#945;&#160;=&#160;{}.",
                                  counted(tests.front()->family_size, "test", "tests"), result.alpha);
    if (highest > 0.0)
        out += fmt::format(
            " Shift: Hodges&#8211;Lehmann, with the interval of the shifts that the test does not reject, at "
            "{}&#160;% "
            "(asked for: {:g}&#160;%, before Holm's correction; a round bracket: without that end); "
            "r: rank-biserial.",
            highest - lowest < 5e-4 ? fmt::format("{:.1f}", 100.0 * highest)
                                    : fmt::format("{:.1f} to {:.1f}", 100.0 * lowest, 100.0 * highest),
            100.0 * result.level);
    if (any(&AdjustedTest::depends_on_zeros))
        out += " &#8224; The decision would be another with Pratt's treatment of zeros.";
    if (any(&AdjustedTest::out_of_reach))
        out +=
            " &#8225; The smallest p that so few differences other than zero can give, times the number of "
            "tests, exceeds &#945;: significant only where other pairs have a smaller p.";
    return out + "</p>";
}

/// Empty where no participant has answers to compare.
std::string testTable(const std::vector<Comparison>& comparisons, const Measure& measure,
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
    const std::string first = fmt::format("{}<th class=\"text\">A</th><th class=\"text\">B</th>",
                                          factor.empty() ? "" : "<th>System</th>");
    std::vector<std::string> names;
    std::string out = openTable(
        units::means,
        fmt::format("{}{} n counts participants.", caption,
                    measure.kind == MeasureKind::accuracy ? " (A &#8722; B in percentage points)." : "."),
        first + "<th>Mean A &#8722; B</th>" + effectColumns(), numbering, TableWidth::dense);
    for (const Comparison* one : rows) {
        names.push_back(fmt::format(
            "{}<td class=\"text\">{}</td><td class=\"text\">{}</td>",
            factor.empty() ? "" : fmt::format("<th scope=\"row\">{}</th>", escapeHtml(one->system)),
            escapeHtml(one->a), escapeHtml(one->b)));
        out += fmt::format("<tr>{}<td>{}</td>{}</tr>", names.back(),
                           one->test.n_pairs > 0 ? scoreText(measure, one->mean_difference) : dash,
                           effectCells(*one, measure));
    }
    return out + close_table + tableFoot(rows, result) +
           rankDetails(units::means, rows, numbering.name(), first, names);
}

/// `where`: of several studies, " in STUDY".
std::string preferenceTable(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    if (result.preferences.empty()) return "";
    std::vector<const PreferenceResult*> rows;
    for (const PreferenceResult& pair : result.preferences) rows.push_back(&pair);
    const std::string first = "<th class=\"text\">A</th><th class=\"text\">B</th>";
    std::vector<std::string> names;
    std::string out = openTable(
        units::preferences,
        fmt::format("Preferences{}: answers for A, for neither and for B; mean of the participants' means "
                    "(positive: A). n counts participants.",
                    where),
        first + "<th>for A</th><th>equal</th><th>for B</th><th>Mean</th>" + effectColumns(), numbering,
        TableWidth::dense);
    const Measure scale{"preference", MeasureKind::preference, -2.0, 2.0, 0, 0};
    for (const PreferenceResult* pair : rows) {
        names.push_back(fmt::format("<td class=\"text\">{}</td><td class=\"text\">{}</td>",
                                    escapeHtml(pair->a), escapeHtml(pair->b)));
        out += fmt::format("<tr>{}<td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>", names.back(),
                           pair->prefers_a, pair->ties, pair->prefers_b, scoreText(scale, pair->mean),
                           effectCells(*pair, scale));
    }
    return out + close_table + tableFoot(rows, result) +
           rankDetails(units::preferences, rows, numbering.name(), first, names);
}

std::string omnibusTable(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    if (result.table.systems.size() < 3) return "";  // with two systems the pair says as much
    std::string rows;
    for (const OmnibusResult& one : result.omnibus) {
        const FriedmanTest& test = one.test;
        if (!test.chi2) continue;
        const ImanDavenport& f = test.iman_davenport;
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{:.2f}</td><td>{}</td><td>{}</td><td>{:.3f}</td>"
            "<td>{}</td><td>{}, {}</td><td>{}</td></tr>",
            escapeHtml(capitalised(one.measure)), test.n, *test.chi2, test.df, pText(*test.p),
            *test.kendalls_w, f.f ? fmt::format("{:.2f}", *f.f) : "&#8734;", f.df1, f.df2,
            f.p ? pText(*f.p) : std::string(dash));
    }
    if (rows.empty()) return "";
    return openTable(
               units::means,
               fmt::format("All systems at once{}, by Friedman's test of the participants' means. n counts "
                           "participants with answers under every system.",
                           where),
               "<th>Measure</th><th>n</th><th>&#967;&#178;</th><th>df</th><th>p</th><th>Kendall's W</th>"
               "<th>F (Iman&#8211;Davenport)</th><th>df</th><th>p</th>",
               numbering) +
           rows + close_table;
}

std::string pairTables(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    std::string out;
    if (result.systems.size() > 1)
        for (const Measure& measure : result.measures) {
            out += testTable(result.pairwise, measure, "",
                             escapeHtml(capitalised(measure.name)) + ", all pairs of systems" + where, result,
                             numbering);
            out += ratingPairsHtml(result, measure, where, numbering);
        }
    return out;
}

}  // namespace

std::string studyTestsHtml(const AnalysisResult& study, Numbering& numbering) {
    if (study.participants < 2)
        return fmt::format("<p>In {} one participant answered: there is nothing to test.</p>",
                           escapeHtml(study.table.study_name));
    const std::string where = " in " + escapeHtml(study.table.study_name);
    // One after another: the tables count.
    std::string out = omnibusTable(study, where, numbering);
    out += pairTables(study, where, numbering);
    out += systemsApartHtml(study, where, numbering);
    out += preferenceTable(study, where, numbering);
    return out + authorTrialsHtml(study, where, numbering);
}

std::string testsHtml(const AnalysisResult& result, Numbering& numbering) {
    const std::string where = result.by_study.empty() ? "" : ", all studies pooled";
    std::string out = fmt::format("<h2>Tests{}</h2>", where);
    if (result.participants < 2)
        return out +
               "<p>The tests compare participants' means over participants. With one participant there is "
               "nothing to test yet; the tests appear here from the second participant on.</p>";
    std::string tables = omnibusTable(result, where, numbering);
    tables += pairTables(result, where, numbering);
    for (const Measure& measure : result.measures)
        for (const Factor& factor : withinFactors(result.table))
            tables += testTable(result.level_tests, measure, factor.name,
                                fmt::format("{}, levels of {} within each system (all: over the systems)",
                                            escapeHtml(capitalised(measure.name)), escapeHtml(factor.name)),
                                result, numbering);
    tables += interactionsHtml(result, numbering);
    tables += equivalenceHtml(result, numbering);
    tables += preferenceTable(result, where, numbering);
    tables += authorTrialsHtml(result, where, numbering);
    return tables.empty() ? "" : out + tables;
}

}  // namespace deixis::results
