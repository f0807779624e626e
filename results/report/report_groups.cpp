// Groups of participants, and questionnaires.
#include <fmt/core.h>

#include "report_details.hpp"
#include "report_people.hpp"
#include "results/analysis/analysis_details.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

/// A table of the tests that `takes` accepts; empty where none of them has a p. `first_cells`: what
/// stands before a row's test.
template <typename Test, typename Takes, typename FirstCells>
std::string groupTable(TableUnit unit, const std::vector<Test>& tests, const Takes& takes,
                       const std::string& caption, const std::string& first_columns,
                       const FirstCells& first_cells, const Measure& measure, const AnalysisResult& result,
                       Numbering& numbering) {
    std::string rows;
    bool tested = false;
    int family = 0;
    for (const Test& one : tests) {
        if (!takes(one)) continue;
        rows += first_cells(one) + groupTestCells(one, scoreTextOf(measure)) + "</tr>";
        tested = tested || one.test.p_two_sided;
        family = one.family_size;
    }
    if (!tested) return "";
    return openTable(
               unit,
               fmt::format("{} &#948;: Cliff's delta; A<sub>12</sub>: the probability that A is above B, "
                           "ties counting half.",
                           caption),
               first_columns + group_test_columns, numbering, TableWidth::dense) +
           rows + close_table +
           fmt::format(
               "<p class=\"small\">Holm's family: {}, &#945;&#160;=&#160;{}; bold: "
               "significant. Shift: "
               "Hodges&#8211;Lehmann with the interval of the shifts that the test does not reject (asked "
               "for: "
               "{:g}&#160;%; a round bracket: without that end).</p>",
               counted(family, "test", "tests"), result.alpha, 100.0 * result.level);
}

std::string meansOfGroups(const AnalysisResult& result, const Factor& factor, const Measure& measure,
                          Numbering& numbering) {
    return groupTable(
        units::means, result.between,
        [&](const BetweenResult& one) { return one.factor == factor.name && one.measure == measure.name; },
        fmt::format(
            "{} by {}: participants' means, rank-sum test (exact up to 400 participants). \"all\": the "
            "mean of a participant's means under each system.",
            escapeHtml(capitalised(measure.name)), escapeHtml(factor.name)),
        "<th>System</th><th class=\"text\">A</th><th class=\"text\">B</th><th>n</th><th>Mean A</th><th>Mean "
        "B</th>",
        [&](const BetweenResult& one) {
            return fmt::format(
                "<tr{}><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}, "
                "{}</td><td>{}</td><td>{}</td>",
                one.system == "all" ? " class=\"all\"" : "", escapeHtml(one.system), escapeHtml(one.a),
                escapeHtml(one.b), one.test.n_a, one.test.n_b,
                groupMean(scoreTextOf(measure), one.test.n_a, one.mean_a),
                groupMean(scoreTextOf(measure), one.test.n_b, one.mean_b));
        },
        measure, result, numbering);
}

/// "62 / 10 / 28 %"
std::string sharesText(const PreferenceCounts& counts) {
    if (counts.answers() == 0) return dash;
    const auto percent = [&](int of) { return 100.0 * *counts.share(of); };
    return fmt::format("{:.0f} / {:.0f} / {:.0f}&#160;%", percent(counts.wins), percent(counts.ties),
                       percent(counts.losses));
}

std::string preferencesOfGroups(const AnalysisResult& result, const Factor& factor, Numbering& numbering) {
    const Measure preference = measureOf(result, "preference");
    return groupTable(
        units::preferences, result.preferences_between,
        [&](const PreferenceBetweenResult& one) { return one.factor == factor.name; },
        fmt::format("Preferences by {}; first line: group A, second: B. Answers for the first system / for "
                    "neither / for the other; mean of the participants' net preferences (from 2, clearly the "
                    "first, to &#8722;2), and their rank-sum test (exact up to 400 participants).",
                    escapeHtml(factor.name)),
        "<th>Systems</th><th class=\"text\">Groups</th><th>n</th><th>Answers</th><th>Mean</th>",
        [&](const PreferenceBetweenResult& one) {
            return fmt::format(
                "<tr><th scope=\"row\">{}<br/>against {}</th><td "
                "class=\"text\">{}<br/>{}</td><td>{}<br/>{}</td>"
                "<td>{}<br/>{}</td><td>{}<br/>{}</td>",
                escapeHtml(one.system), escapeHtml(one.other_system), escapeHtml(one.a), escapeHtml(one.b),
                one.test.n_a, one.test.n_b, sharesText(one.answers_a), sharesText(one.answers_b),
                groupMean(scoreTextOf(preference), one.test.n_a, one.mean_a),
                groupMean(scoreTextOf(preference), one.test.n_b, one.mean_b));
        },
        preference, result, numbering);
}

}  // namespace

std::string systemsApartHtml(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    std::string out;
    for (const Measure& measure : result.measures)
        out += groupTable(
            units::means, result.between,
            [&](const BetweenResult& one) {
                return one.factor == systems_between && one.measure == measure.name;
            },
            fmt::format(
                "{}{}: systems that no participant met both of, as groups of participants: rank-sum test "
                "of participants' means (exact up to 400 participants).",
                escapeHtml(capitalised(measure.name)), where),
            "<th class=\"text\">A</th><th class=\"text\">B</th><th>n A</th><th>n B</th><th>Mean A</th>"
            "<th>Mean B</th>",
            [&](const BetweenResult& one) {
                return fmt::format(
                    "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td>"
                    "<td>{}</td>",
                    escapeHtml(one.a), escapeHtml(one.b), one.test.n_a, one.test.n_b,
                    groupMean(scoreTextOf(measure), one.test.n_a, one.mean_a),
                    groupMean(scoreTextOf(measure), one.test.n_b, one.mean_b));
            },
            measure, result, numbering);
    return out;
}

std::string betweenHtml(const AnalysisResult& result, Numbering& numbering) {
    std::string out =
        systemsApartHtml(result, result.by_study.empty() ? "" : ", all studies pooled", numbering);
    for (const Factor& factor : result.table.between) {
        for (const Measure& measure : result.measures)
            out += meansOfGroups(result, factor, measure, numbering);
        if (!result.preferences_between.empty()) out += preferencesOfGroups(result, factor, numbering);
    }
    return out.empty() ? "" : "<h2>Groups of participants</h2>" + out;
}

std::string scoresHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.scores.empty()) return "";
    const bool grouped = !result.table.between.empty();
    std::string out =
        "<h2>Questionnaires</h2>" +
        openTable(units::scores, "Scores over participants.",
                  fmt::format("<th>Stage</th><th class=\"text\">Score</th>{}<th>n</th><th>Mean</th>"
                              "<th>SD</th><th>25&#160;%</th><th>Median</th><th>75&#160;%</th>",
                              grouped ? "<th class=\"text\">Group</th>" : ""),
                  numbering);
    for (const ScoreResult& score : result.scores) {
        const std::string group =
            score.factor.empty() ? "all" : escapeHtml(score.factor) + ": " + escapeHtml(score.level);
        out += fmt::format(
            "<tr{}><th scope=\"row\">{}</th><td class=\"text\">{}</td>{}<td>{}</td><td>{:.2f}</td><td>{}</td>"
            "<td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td></tr>",
            grouped && score.factor.empty() ? " class=\"all\"" : "", escapeHtml(score.stage),
            escapeHtml(score.score), grouped ? "<td class=\"text\">" + group + "</td>" : "", score.n,
            score.mean, score.n > 1 ? fmt::format("{:.2f}", score.sd) : std::string(dash), score.q25,
            score.median, score.q75);
    }
    out += close_table;
    return out + scoreTestsHtml(result, numbering);
}

std::string pooledHtml(const AnalysisResult& result, Numbering& numbering) {
    std::string rows;
    for (const PooledResult& one : result.pooled) {
        const Measure measure = measureOf(result, one.measure);
        if (!hasManySteps(measure)) continue;
        const auto number = [&](double value) { return scoreText(measure, value); };
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escapeHtml(capitalised(one.measure)), escapeHtml(one.system), one.n, number(one.mean),
            one.n > 1 ? number(one.sd) : dash, number(one.q05), number(one.q25), number(one.median),
            number(one.q75), number(one.q95));
    }
    if (rows.empty()) return "";
    return openTable(
               units::ratings,
               "Ratings taken one by one, <b>pseudo-replicated</b>: a participant's ratings hang together, "
               "so "
               "this describes and supports no test.",
               "<th>Measure</th><th class=\"text\">System</th><th>n</th><th>Mean</th><th>SD</th>"
               "<th>5&#160;%</th><th>25&#160;%</th><th>Median</th><th>75&#160;%</th><th>95&#160;%</th>",
               numbering) +
           rows + close_table;
}

}  // namespace deixis::results
