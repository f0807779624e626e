#include "results/outputs/bradley_terry_html.hpp"

#include <fmt/format.h>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

Section bradleyTerrySection(const AnalysisResult& result, Numbering& numbering) {
    const BradleyTerry& fit = result.bradley_terry;
    if (fit.abilities.empty()) return {};
    Table table = tables::abilities(result);
    std::vector<Shown> shown{"system", "ability", "bca", "percentile"};
    std::vector<std::string> names;  // of the columns below, which must stay
    for (const Ability& other : fit.abilities) names.push_back("to " + other.system);
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.columns.emplace_back(names[i], ColumnKind::number);
        table.columns.back().label = names[i];
        shown.emplace_back(names[i].c_str());
        for (Table::Row& row : table.rows) {
            const std::string system = row.cells.front().text();
            Cell& cell = row.cells.emplace_back();
            for (const PairCount& pair : fit.pairs)
                if (pair.a == system && pair.b == fit.abilities[i].system)
                    cell = fmt::format("{} / {} / {}", pair.prefers_a, pair.ties, pair.prefers_b);
                else if (pair.b == system && pair.a == fit.abilities[i].system)
                    cell = fmt::format("{} / {} / {}", pair.prefers_b, pair.ties, pair.prefers_a);
        }
    }
    std::string out = tableHtml(
        table,
        fmt::format(
            "Bradley and Terry's model: the log odds with which one system is preferred to another are "
            "the difference of their abilities, whose mean is 0; ties are half a win each. "
            "{:.4g}\u00a0% intervals from resampled participants: bias-corrected and accelerated (BCa), "
            "and percentiles. Right: wins, ties and losses against each other system.",
            100.0 * result.level),
        shown, numbering, dense_table);
    if (!fit.note.empty())
        out += noteHtml(
            fmt::format("{}: {}.", fit.abilities.front().estimate ? "Intervals" : "No abilities", fit.note));
    return {"Abilities from preferences", out};
}

}  // namespace deixis::results
