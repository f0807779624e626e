#include "results/outputs/bradley_terry_outputs.hpp"

#include <fmt/format.h>

#include "results/page/report_tables.hpp"

namespace deixis::results {

std::string bradleyTerryHtml(const AnalysisResult& result, Numbering& numbering) {
    const BradleyTerry& fit = result.bradley_terry;
    if (fit.abilities.empty()) return "";
    const Measure points{"ability", MeasureKind::preference, 0.0, 0.0, 0, 0};  // two decimals
    std::string against;
    for (const Ability& one : fit.abilities) against += fmt::format("<th>to {}</th>", escapeHtml(one.system));
    std::string out =
        "<h2>Abilities from preferences</h2>" +
        openTable(units::single_preferences,
                  fmt::format(
                      "Bradley and Terry's model: the log odds with which one system is preferred to another "
                      "are the difference of their abilities, whose mean is 0; ties are half a win each. "
                      "{:.4g}&#160;% intervals from resampled participants: bias-corrected and accelerated "
                      "(BCa), and percentiles. Right: wins, ties and losses against each other system.",
                      100.0 * result.level),
                  "<th>System</th><th>Ability</th><th>BCa</th><th>Percentiles</th>" + against, numbering,
                  TableWidth::dense);
    const auto ends = [&](const std::optional<BootstrapInterval>& interval) {
        return interval ? intervalText(points, interval->lower, interval->upper) : dash;
    };
    for (const Ability& one : fit.abilities) {
        out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>",
                           escapeHtml(one.system), one.estimate ? scoreText(points, *one.estimate) : dash,
                           ends(one.bca), ends(one.percentile));
        for (const Ability& other : fit.abilities) {
            std::string cell = dash;
            for (const PairCount& pair : fit.pairs)
                if (pair.a == one.system && pair.b == other.system)
                    cell = fmt::format("{} / {} / {}", pair.prefers_a, pair.ties, pair.prefers_b);
                else if (pair.a == other.system && pair.b == one.system)
                    cell = fmt::format("{} / {} / {}", pair.prefers_b, pair.ties, pair.prefers_a);
            out += fmt::format("<td>{}</td>", cell);
        }
        out += "</tr>";
    }
    out += close_table;
    if (!fit.note.empty())
        out +=
            fmt::format("<p class=\"small\">{}: {}.</p>",
                        fit.abilities.front().estimate ? "Intervals" : "No abilities", escapeHtml(fit.note));
    return out;
}

}  // namespace deixis::results
