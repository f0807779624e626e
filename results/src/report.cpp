// The report's page: what stands where.
#include <fmt/core.h>

#include <algorithm>

#include "report_text.hpp"

namespace deixis::results {

namespace {

/// Tables are numbered in the order in which they stand.
class Numbering {
  public:
    std::string next() { return fmt::format("<b>Table {}.</b>", ++last_); }

  private:
    int last_ = 0;
};

const char* const dash = "&#8211;";

std::string cells(const Summary& summary, const Measure& measure) {
    const auto number = [&](bool known, double value) {
        return known ? scoreText(measure, value) : std::string(dash);
    };
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td>", number(summary.n > 0, summary.mean),
                       number(summary.by_participant.size() > 1, summary.sd_participants),
                       number(summary.n > 1, summary.sd_trials), summary.n);
}

std::string meansTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.measures.empty()) return "";
    std::string measures;
    std::string over;
    for (const Measure& measure : result.measures) {
        over += fmt::format("<th colspan=\"4\">{}</th>", escapeHtml(capitalised(measure.name)));
        measures += (measures.empty() ? "" : ", ") + escapeHtml(measure.name);
    }
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{} Means of each system: {}. n counts "
        "answers.</caption><thead><tr class=\"over\"><th></th>{}</tr><tr><th>System</th>",
        numbering.next(), measures, over);
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        out += "<th>Mean</th><th>SD participants</th><th>SD trials</th><th>n</th>";
    out += "</tr></thead><tbody>";
    for (const auto& system : result.systems) {
        out += fmt::format("<tr><th scope=\"row\">{}</th>", escapeHtml(system.system));
        for (std::size_t i = 0; i < result.measures.size(); ++i)
            out += cells(system.measures[i], result.measures[i]);
        out += "</tr>";
    }
    return out + "</tbody></table></div>";
}

/// Rows of one system stand next to each other, in the order of `levels`.
std::string levelTable(const AnalysisResult& result, const std::string& factor,
                       const std::vector<std::string>& levels, Numbering& numbering) {
    if (levels.empty()) return "";
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{} Accuracy by {}: proportion correct, mean &#177; standard "
        "deviation over trials{}.</caption><thead><tr><th>System</th>",
        numbering.next(), factor, factor == "layout" ? " (the paper's Table 1)" : "");
    for (const auto& level : levels) out += fmt::format("<th>{}</th><th>n</th>", escapeHtml(level));
    out += "</tr></thead><tbody>";
    std::size_t i = 0;
    for (const LevelResult& row : result.levels) {
        if (row.factor != factor) continue;
        if (i % levels.size() == 0)
            out += fmt::format("<tr{}><th scope=\"row\">{}</th>", i == 0 ? " class=\"all\"" : "",
                               escapeHtml(row.system));
        if (row.n == 0)
            out += fmt::format("<td>{}</td>", dash);
        else
            out += fmt::format("<td>{:.2f} &#177; {}</td>", row.mean,
                               row.n > 1 ? fmt::format("{:.2f}", row.sd_trials) : std::string(dash));
        out += fmt::format("<td>{}</td>", row.n);
        if (++i % levels.size() == 0) out += "</tr>";
    }
    return out + "</tbody></table></div>";
}

std::string verdict(const SignedRankTest& test, bool significant) {
    if (test.n_pairs == 0) return "<td class=\"text not\">no participant has both</td>";
    if (!significant) return "<td class=\"text not\">not significant</td>";
    return fmt::format("<td class=\"text sig\">{} higher</td>", test.w_plus > test.w_minus ? "A" : "B");
}

/// Empty where no participant has answers to compare.
std::string testTable(const std::vector<Comparison>& comparisons, const Measure& measure,
                      const std::string& factor, const std::string& caption, Numbering& numbering) {
    const auto belongs = [&](const Comparison& c) { return c.measure == measure.name && c.factor == factor; };
    if (std::none_of(comparisons.begin(), comparisons.end(),
                     [&](const Comparison& c) { return belongs(c) && c.test.n_pairs > 0; }))
        return "";
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{} {}{} n counts participants.</caption><thead><tr>{}<th "
        "class=\"text\">A</th><th class=\"text\">B</th><th>A &#8722; "
        "B</th><th>n</th><th>zeros</th><th>W+</th>"
        "<th>W&#8722;</th><th>p</th><th>p (Holm)</th><th class=\"text\">Result</th></tr></thead><tbody>",
        numbering.next(), caption,
        measure.kind == MeasureKind::accuracy ? " (A &#8722; B in percentage points)." : ".",
        factor.empty() ? "" : "<th>System</th>");
    for (const auto& comparison : comparisons) {
        if (!belongs(comparison)) continue;
        const SignedRankTest& test = comparison.test;
        out += "<tr>";
        if (!factor.empty()) out += fmt::format("<th scope=\"row\">{}</th>", escapeHtml(comparison.system));
        out += fmt::format(
            "<td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td><td>{}</td>{}</tr>",
            escapeHtml(comparison.a), escapeHtml(comparison.b),
            test.n_pairs > 0 ? scoreText(measure, comparison.mean_difference) : dash, test.n_pairs,
            test.n_zero, test.w_plus, test.w_minus, pText(test.p_two_sided), pText(comparison.p_holm),
            verdict(test, comparison.significant));
    }
    return out + "</tbody></table></div>";
}

std::string preferenceTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.preferences.empty()) return "";
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{} Preferences: answers for A, for neither and for B; mean of "
        "the "
        "participants' means (positive: A). n counts participants.</caption><thead><tr><th "
        "class=\"text\">A</th>"
        "<th class=\"text\">B</th><th>for A</th><th>equal</th><th>for "
        "B</th><th>Mean</th><th>n</th><th>zeros</th>"
        "<th>W+</th><th>W&#8722;</th><th>p</th><th>p (Holm)</th><th "
        "class=\"text\">Result</th></tr></thead><tbody>",
        numbering.next());
    const Measure scale{"preference", MeasureKind::preference, -2.0, 2.0, 0, 0};
    for (const auto& pair : result.preferences)
        out += fmt::format(
            "<tr><td class=\"text\">{}</td><td "
            "class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>",
            escapeHtml(pair.a), escapeHtml(pair.b), pair.prefers_a, pair.ties, pair.prefers_b,
            scoreText(scale, pair.mean), pair.test.n_pairs, pair.test.n_zero, pair.test.w_plus,
            pair.test.w_minus, pText(pair.test.p_two_sided), pText(pair.p_holm),
            verdict(pair.test, pair.significant));
    return out + "</tbody></table></div>";
}

std::string tests(const AnalysisResult& result, Numbering& numbering) {
    std::string out = "<h2>Tests</h2>";
    if (result.participants < 2)
        return out +
               "<p>The tests compare participants' means over participants. With one participant there is "
               "nothing to "
               "test yet; the tests appear here from the second participant on.</p>";
    std::string tables;
    if (result.systems.size() > 1)
        for (const Measure& measure : result.measures)
            tables += testTable(result.pairwise, measure, "",
                                escapeHtml(capitalised(measure.name)) + ", all pairs of systems", numbering);
    for (const Measure& measure : result.measures)
        for (const char* factor : {"layout", "distance"})
            tables += testTable(
                result.level_tests, measure, factor,
                fmt::format("{}, {}s within each system", escapeHtml(capitalised(measure.name)), factor),
                numbering);
    tables += preferenceTable(result, numbering);
    return tables.empty() ? "" : out + tables;
}

std::string scoresTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.scores.empty()) return "";
    std::string out = fmt::format(
        "<h2>Questionnaires</h2><div class=\"scroll\"><table><caption>{} Scores over "
        "participants.</caption><thead>"
        "<tr><th>Stage</th><th "
        "class=\"text\">Score</th><th>Mean</th><th>SD</th><th>n</th></tr></thead><tbody>",
        numbering.next());
    for (const auto& score : result.scores)
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td "
            "class=\"text\">{}</td><td>{:.2f}</td><td>{}</td><td>{}</td></tr>",
            escapeHtml(score.stage), escapeHtml(score.score), score.mean,
            score.n > 1 ? fmt::format("{:.2f}", score.sd) : std::string(dash), score.n);
    return out + "</tbody></table></div>";
}

std::string checksAndLeftOut(const AnalysisResult& result, Numbering& numbering) {
    const ResponseTable& table = result.table;
    if (table.checks.empty() && table.left_out.empty()) return "";
    std::string out = "<h2>Attention checks and exclusions</h2>";
    if (!table.checks.empty()) {
        out += fmt::format(
            "<div class=\"scroll\"><table><caption>{} Attention checks of all participants, the excluded "
            "ones "
            "too.</caption><thead><tr><th>Stage</th><th "
            "class=\"text\">Kind</th><th>passed</th><th>failed</th></tr>"
            "</thead><tbody>",
            numbering.next());
        for (const auto& check : table.checks)
            out += fmt::format(
                "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td></tr>",
                escapeHtml(check.stage), escapeHtml(check.kind), check.passed, check.failed);
        out += "</tbody></table></div>";
    }
    if (table.left_out.empty()) return out + "<p>Nobody is left out.</p>";
    out += "<p>The answers of these participants are left out:</p><ul>";
    for (const auto& one : table.left_out)
        out += fmt::format("<li>{}: {} ({})</li>", escapeHtml(one.participant),
                           one.dropped ? "dropped out" : "excluded", escapeHtml(one.reason));
    return out + "</ul>";
}

std::string joined(const std::vector<std::string>& items) {
    std::string out;
    for (const auto& item : items) out += (out.empty() ? "" : ", ") + escapeHtml(item);
    return out;
}

std::string provenance(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::string out = "<h2>Where the numbers come from</h2><dl>";
    const auto entry = [&](const char* name, const std::string& html) {
        out += fmt::format("<dt>{}</dt><dd>{}</dd>", name, html);
    };
    entry("Database", escapeHtml(table.database));
    entry("Study", escapeHtml(table.study_name));
    entry("Study file (SHA-256)", escapeHtml(table.study_hash));
    entry("Recorded by", joined(table.program_versions));
    entry("Avatar (SHA-256)", joined(table.avatar_hashes));
    for (const auto& station : table.stations)
        entry("Station", fmt::format("{}{}: {} session{}{}", escapeHtml(station.kind),
                                     station.synthetic ? " (no person answers)" : "", station.sessions,
                                     station.sessions == 1 ? "" : "s",
                                     station.details.empty() ? "" : "; " + escapeHtml(station.details)));
    return out + "</dl>";
}

std::string stationKinds(const ResponseTable& table) {
    std::string out;
    std::string last;
    for (const auto& station : table.stations)
        if (station.kind != last) {
            out += (out.empty() ? "" : ", ") + escapeHtml(station.kind);
            last = station.kind;
        }
    return out;
}

}  // namespace

std::string renderReport(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{} &#8211; "
        "report</title>\n"
        "<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n"
        "<p class=\"lead\">{} participant{} &#183; {} answers &#183; {} systems &#183; station: {}</p>\n",
        escapeHtml(table.study_title), report_css, escapeHtml(table.study_title), result.participants,
        result.participants == 1 ? "" : "s", table.rows.size(), table.systems.size(), stationKinds(table));
    if (result.synthetic)
        out +=
            "<p class=\"synthetic\"><b>Simulated participants:</b> these numbers test the pipeline and are "
            "no evidence "
            "about people.</p>\n";
    out += findingsHtml(result);
    out += "\n<div class=\"plots\">";
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        out +=
            fmt::format("\n<figure><figcaption><b>{}</b> &#183; participants' means</figcaption>{}</figure>",
                        result.measures[i].kind == MeasureKind::accuracy
                            ? "Referential accuracy"
                            : escapeHtml(capitalised(result.measures[i].name)),
                        boxPlotSvg(result, i));
    if (!result.preferences.empty())
        out += fmt::format(
            "\n<figure><figcaption><b>Preference</b> &#183; answers for the one, for neither, for the "
            "other</figcaption>{}</figure>",
            preferencesSvg(result));
    out += "</div>";
    Numbering numbering;
    // One after another: the tables count.
    if (!result.measures.empty()) {
        out += "\n<h2>Means</h2>\n" + meansTable(result, numbering);
        out += "\n" + levelTable(result, "layout", table.layouts, numbering);
        out += "\n" + levelTable(result, "distance", table.distances, numbering);
    }
    out += "\n" + tests(result, numbering);
    out += "\n" + scoresTable(result, numbering);
    out += "\n" + checksAndLeftOut(result, numbering);
    if (!result.remarks.empty()) {
        out += "\n<h2>Remarks</h2><ul class=\"findings\">";
        for (const auto& remark : result.remarks) out += "<li>" + escapeHtml(remark) + "</li>";
        out += "</ul>";
    }
    out += "\n<h2>Methods</h2>" + methodsHtml(result) + "\n" + provenance(result);
    return out + "\n</body>\n</html>\n";
}

}  // namespace deixis::results
