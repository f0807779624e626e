// The report's page: what stands where.
#include <fmt/core.h>

#include <algorithm>

#include "bradley_terry_outputs.hpp"
#include "report_details.hpp"
#include "report_figures.hpp"
#include "report_tests.hpp"
#include "report_text.hpp"

namespace deixis::results {

namespace {

std::string cells(const Summary& summary, const Measure& measure) {
    const auto number = [&](bool known, double value) {
        return known ? scoreText(measure, value) : std::string(dash);
    };
    const std::string interval = summary.interval
                                     ? intervalText(measure, summary.interval->lower, summary.interval->upper)
                                     : std::string(dash);
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                       number(summary.n > 0, summary.mean), interval,
                       number(summary.by_participant.size() > 1, summary.sd_participants),
                       number(summary.n > 1, summary.sd_trials), summary.n);
}

std::string meansTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.measures.empty()) return "";
    std::string out = fmt::format(
        "<div class=\"scroll\"><table><caption>{} Means of each system. Interval: {:g}&#160;%, bootstrap "
        "over "
        "participants. n counts answers.</caption><thead><tr><th>Measure</th><th class=\"text\">System</th>"
        "<th>Mean</th><th>Interval</th><th>SD participants</th><th>SD "
        "trials</th><th>n</th></tr></thead><tbody>",
        numbering.next(), 100.0 * result.options.level);
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        for (const auto& system : result.systems)
            out += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td>{}</tr>",
                               escapeHtml(capitalised(result.measures[i].name)), escapeHtml(system.system),
                               cells(system.measures[i], result.measures[i]));
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
    entry("Data", escapeHtml(table.database));
    entry("Answers (SHA-256)", answersHash(table));
    if (!table.study_hash.empty()) {
        entry("Study", escapeHtml(table.study_name));
        entry("Study file (SHA-256)", escapeHtml(table.study_hash));
        entry("Recorded by", joined(table.program_versions));
        entry("Avatar (SHA-256)", joined(table.avatar_hashes));
    }
    entry("Settings",
          fmt::format("&#945; = {}, intervals at {:g}&#160;%, {} bootstrap resamples, seed {}", result.alpha,
                      100.0 * result.options.level, result.options.resamples, result.options.seed));
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
        "<style>{}{}</style>\n</head>\n<body>\n<h1>{}</h1>\n"
        "<p class=\"lead\">{} participant{} &#183; {} answers &#183; {} systems{}</p>\n",
        escapeHtml(table.study_title), report_css, figure_css, escapeHtml(table.study_title),
        result.participants, result.participants == 1 ? "" : "s", table.rows.size(), table.systems.size(),
        table.stations.empty() ? "" : " &#183; station: " + stationKinds(table));
    if (result.synthetic)
        out +=
            "<p class=\"synthetic\"><b>Simulated participants:</b> these numbers test the pipeline and are "
            "no evidence "
            "about people.</p>\n";
    out += findingsHtml(result);
    Numbering figures("Figure");
    out += figuresHtml(result, figures);
    Numbering numbering;
    // One after another: the tables count.
    if (!result.measures.empty()) {
        out += "\n<h2>Means</h2>\n" + meansTable(result, numbering);
        out += "\n" + distributionsHtml(result, numbering);
        out += "\n" + levelTable(result, "layout", table.layouts, numbering);
        out += "\n" + levelTable(result, "distance", table.distances, numbering);
    }
    out += "\n" + testsHtml(result, numbering);
    out += "\n" + differencesHtml(result, figures);
    out += "\n" + bradleyTerryHtml(result, numbering);
    out += "\n" + sensitivityHtml(result, numbering);
    out += "\n" + detailsHtml(result, numbering);
    out += "\n" + scoresTable(result, numbering);
    out += "\n" + checksAndLeftOut(result, numbering);
    out += "\n" + presenceHtml(result, numbering);
    if (!result.remarks.empty()) {
        out += "\n<h2>Remarks</h2><ul class=\"findings\">";
        for (const auto& remark : result.remarks) out += "<li>" + escapeHtml(remark) + "</li>";
        out += "</ul>";
    }
    out += "\n<h2>Methods</h2>" + methodsHtml(result) + "\n" + provenance(result);
    out += figuresEnd();
    return out + "\n</body>\n</html>\n";
}

}  // namespace deixis::results
