// The report's page: what stands where.
#include <fmt/core.h>

#include <algorithm>

#include "report_text.hpp"

namespace deixis::results {

namespace {

std::string cells(const Summary& summary, std::size_t participants, const std::string& measure) {
    const auto number = [&](bool known, double value) {
        return known ? scoreText(measure, value) : std::string("&#8211;");
    };
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td>", number(summary.n > 0, summary.mean),
                       number(participants > 1, summary.sd_participants),
                       number(summary.n > 1, summary.sd_trials), summary.n);
}

std::string meansTable(const AnalysisResult& result) {
    std::string out =
        "<div class=\"scroll\"><table><caption><b>Table 1.</b> Accuracy and naturalness of each system. n "
        "counts "
        "answers.</caption><thead><tr class=\"over\"><th></th><th colspan=\"4\">Accuracy</th><th "
        "colspan=\"4\">"
        "Naturalness</th></tr><tr><th>System</th>";
    for (int measure = 0; measure < 2; ++measure)
        out += "<th>Mean</th><th>SD participants</th><th>SD trials</th><th>n</th>";
    out += "</tr></thead><tbody>";
    for (const auto& system : result.systems)
        out +=
            fmt::format("<tr><th scope=\"row\">{}</th>{}{}</tr>", escapeHtml(system.system),
                        cells(system.accuracy, system.accuracy_by_participant.size(), "accuracy"),
                        cells(system.naturalness, system.naturalness_by_participant.size(), "naturalness"));
    return out + "</tbody></table></div>";
}

/// The results of one row group of result.layouts stand next to each other, in the order of table.layouts.
std::string layoutTable(const AnalysisResult& result) {
    const auto& layouts = result.table.layouts;
    if (layouts.empty()) return "";
    std::string out =
        "<div class=\"scroll\"><table><caption><b>Table 2.</b> Accuracy by layout: proportion correct, mean "
        "&#177; "
        "standard deviation over trials (the paper's Table 1).</caption><thead><tr><th>System</th>";
    for (const auto& layout : layouts) out += fmt::format("<th>{}</th><th>n</th>", escapeHtml(layout));
    out += "</tr></thead><tbody>";
    for (std::size_t i = 0; i < result.layouts.size(); ++i) {
        const LayoutResult& row = result.layouts[i];
        if (i % layouts.size() == 0)
            out += fmt::format("<tr{}><th scope=\"row\">{}</th>", i == 0 ? " class=\"all\"" : "",
                               escapeHtml(row.system));
        if (row.n == 0)
            out += "<td>&#8211;</td>";
        else
            out += fmt::format("<td>{:.2f} &#177; {}</td>", row.mean,
                               row.n > 1 ? fmt::format("{:.2f}", row.sd_trials) : std::string("&#8211;"));
        out += fmt::format("<td>{}</td>", row.n);
        if (i % layouts.size() == layouts.size() - 1) out += "</tr>";
    }
    return out + "</tbody></table></div>";
}

std::string verdict(const Comparison& comparison) {
    if (comparison.test.n == 0) return "<td class=\"text not\">no participant has both</td>";
    if (!comparison.significant) return "<td class=\"text not\">not significant</td>";
    return fmt::format("<td class=\"text sig\">{} higher</td>",
                       comparison.test.w_plus > comparison.test.w_minus ? "A" : "B");
}

/// Empty where no participant has answers to compare.
std::string testTable(const std::vector<Comparison>& comparisons, const std::string& measure,
                      const std::string& caption) {
    const auto tested = [&](const Comparison& c) { return c.measure == measure && c.test.n > 0; };
    if (std::none_of(comparisons.begin(), comparisons.end(), tested)) return "";
    const bool layout = measure == "layout";
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{}</caption><thead><tr>{}<th class=\"text\">A</th>"
        "<th class=\"text\">B</th><th>A &#8722; B</th><th>n</th><th>zeros</th><th>W+</th>"
        "<th>W&#8722;</th><th>p</th><th>p (Holm)</th><th class=\"text\">Result</th></tr></thead><tbody>",
        caption, layout ? "<th>System</th>" : "");
    for (const auto& comparison : comparisons) {
        if (comparison.measure != measure) continue;
        const SignedRankTest& test = comparison.test;
        out += "<tr>";
        if (layout) out += fmt::format("<th scope=\"row\">{}</th>", escapeHtml(comparison.system));
        out += fmt::format(
            "<td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td><td>{}</td>{}</tr>",
            escapeHtml(comparison.a), escapeHtml(comparison.b),
            test.n > 0 ? scoreText(measure, comparison.mean_difference) : "&#8211;", test.n, test.n_zero,
            test.w_plus, test.w_minus, pText(test.p), pText(comparison.p_holm), verdict(comparison));
    }
    return out + "</tbody></table></div>";
}

std::string tests(const AnalysisResult& result) {
    std::string out = "<h2>Tests</h2>";
    if (result.participants < 2)
        return out +
               "<p>The tests compare participants' means over participants. With one participant there is "
               "nothing to "
               "test yet; the tests appear here from the second participant on.</p>";
    if (result.systems.size() > 1) {
        out += testTable(result.pairwise, "accuracy",
                         "<b>Table 3.</b> Accuracy, all pairs of systems (A &#8722; B in percentage points). "
                         "n counts participants.");
        out += testTable(result.pairwise, "naturalness",
                         "<b>Table 4.</b> Naturalness, all pairs of systems. n counts participants.");
    }
    if (!result.layout_tests.empty())
        out += testTable(result.layout_tests, "layout",
                         "<b>Table 5.</b> Accuracy, layouts within each system (A &#8722; B in percentage "
                         "points). n counts participants.");
    return out;
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
    entry("Recorded by", "deixis " + joined(table.program_versions));
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
    for (const auto& [measure, title] :
         {std::pair{"accuracy", "Referential accuracy"}, std::pair{"naturalness", "Naturalness"}})
        out +=
            fmt::format("\n<figure><figcaption><b>{}</b> &#183; participants' means</figcaption>{}</figure>",
                        title, boxPlotSvg(result, measure));
    out +=
        "</div>\n<h2>Means</h2>\n" + meansTable(result) + "\n" + layoutTable(result) + "\n" + tests(result);
    if (!result.remarks.empty()) {
        out += "\n<h2>Remarks</h2><ul class=\"findings\">";
        for (const auto& remark : result.remarks) out += "<li>" + escapeHtml(remark) + "</li>";
        out += "</ul>";
    }
    out += "\n<h2>Methods</h2>" + methodsHtml(result) + "\n" + provenance(result);
    return out + "\n</body>\n</html>\n";
}

}  // namespace deixis::results
