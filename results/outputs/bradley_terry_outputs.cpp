#include "results/outputs/bradley_terry_outputs.hpp"

#include <fmt/format.h>

#include "results/page/report_tables.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using AbilityJson = nlohmann::ordered_json;

AbilityJson endsJson(const std::optional<BootstrapInterval>& interval) {
    return interval ? AbilityJson{{"lower", interval->lower}, {"upper", interval->upper}} : AbilityJson();
}

PlainCell lowerCell(const std::optional<BootstrapInterval>& interval) {
    return interval ? PlainCell(interval->lower) : PlainCell();
}

PlainCell upperCell(const std::optional<BootstrapInterval>& interval) {
    return interval ? PlainCell(interval->upper) : PlainCell();
}

}  // namespace

AbilityJson bradleyTerryJson(const AnalysisResult& result) {
    const BradleyTerry& fit = result.bradley_terry;
    if (fit.abilities.empty()) return {};
    AbilityJson out;
    out["ties"] = "half a win for each";
    out["participants"] = fit.participants;
    out["abilities"] = AbilityJson::array();
    for (const Ability& one : fit.abilities)
        out["abilities"].push_back({{"system", one.system},
                                    {"ability", numberOrNull(one.estimate)},
                                    {"bca", endsJson(one.bca)},
                                    {"percentile", endsJson(one.percentile)},
                                    {"wins", one.wins},
                                    {"ties", one.ties},
                                    {"losses", one.losses}});
    out["pairs"] = AbilityJson::array();
    for (const PairCount& pair : fit.pairs)
        out["pairs"].push_back({{"a", pair.a},
                                {"b", pair.b},
                                {"prefers_a", pair.prefers_a},
                                {"ties", pair.ties},
                                {"prefers_b", pair.prefers_b}});
    out["resamples_left_out"] = fit.resamples_left_out;
    out["note"] = fit.note.empty() ? AbilityJson() : AbilityJson(fit.note);
    return out;
}

PlainTable bradleyTerryTable(const AnalysisResult& result) {
    PlainTable out{"bradley_terry",
                   units::single_preferences,
                   "Abilities from preferences (Bradley and Terry); log odds, mean 0",
                   {{"system", ColumnType::text, Print::plain},
                    {"ability", ColumnType::number, Print::plain},
                    {"bca_lower", ColumnType::number, Print::plain, "BCa from"},
                    {"bca_upper", ColumnType::number, Print::plain, "to"},
                    {"percentile_lower", ColumnType::number, Print::plain, "percentile from"},
                    {"percentile_upper", ColumnType::number, Print::plain, "to"},
                    {"wins", ColumnType::whole, Print::plain},
                    {"ties", ColumnType::whole, Print::plain},
                    {"losses", ColumnType::whole, Print::plain}}};
    const auto whole = [](int count) { return PlainCell(static_cast<long long>(count)); };
    for (const Ability& one : result.bradley_terry.abilities)
        out.rows.push_back({one.system, plainCell(one.estimate), lowerCell(one.bca), upperCell(one.bca),
                            lowerCell(one.percentile), upperCell(one.percentile), whole(one.wins),
                            whole(one.ties), whole(one.losses)});
    return out;
}

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
