#include "bradley_terry_outputs.hpp"

#include <fmt/format.h>

#include "json_values.hpp"

namespace deixis::results {

namespace {

using AbilityJson = nlohmann::ordered_json;

std::optional<double> lowerOf(const Ability& one) {
    return one.interval ? std::optional<double>(one.interval->lower) : std::nullopt;
}

std::optional<double> upperOf(const Ability& one) {
    return one.interval ? std::optional<double>(one.interval->upper) : std::nullopt;
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
                                    {"lower", numberOrNull(lowerOf(one))},
                                    {"upper", numberOrNull(upperOf(one))},
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
                   "Abilities from preferences (Bradley and Terry); log odds, mean 0",
                   {{"system", ColumnType::text, Print::plain},
                    {"ability", ColumnType::number, Print::plain},
                    {"lower", ColumnType::number, Print::plain},
                    {"upper", ColumnType::number, Print::plain},
                    {"wins", ColumnType::whole, Print::plain},
                    {"ties", ColumnType::whole, Print::plain},
                    {"losses", ColumnType::whole, Print::plain}}};
    const auto whole = [](int count) { return PlainCell(static_cast<long long>(count)); };
    for (const Ability& one : result.bradley_terry.abilities)
        out.rows.push_back({one.system, plainCell(one.estimate), plainCell(lowerOf(one)),
                            plainCell(upperOf(one)), whole(one.wins), whole(one.ties), whole(one.losses)});
    return out;
}

std::string bradleyTerryHtml(const AnalysisResult& result, Numbering& numbering) {
    const BradleyTerry& fit = result.bradley_terry;
    if (fit.abilities.empty()) return "";
    const Measure points{"ability", MeasureKind::preference, 0.0, 0.0, 0, 0};  // two decimals
    std::string against;
    for (const Ability& one : fit.abilities) against += fmt::format("<th>to {}</th>", escapeHtml(one.system));
    std::string out = fmt::format(
        "<h2>Abilities from preferences</h2><div class=\"scroll\"><table><caption>{} Bradley and Terry's "
        "model: "
        "the log odds with which one system is preferred to another are the difference of their abilities, "
        "whose mean is 0; ties are half a win each. {:.4g}&#160;% intervals from resampled participants. "
        "Right: wins, ties and losses against each other system.</caption><thead><tr><th>System</th>"
        "<th>Ability</th><th>Interval</th>{}</tr></thead><tbody>",
        numbering.next(), 100.0 * result.options.level, against);
    for (const Ability& one : fit.abilities) {
        out +=
            fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td>", escapeHtml(one.system),
                        one.estimate ? scoreText(points, *one.estimate) : dash,
                        one.interval ? intervalText(points, one.interval->lower, one.interval->upper) : dash);
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
    out += "</tbody></table></div>";
    if (!fit.note.empty())
        out +=
            fmt::format("<p class=\"small\">{}: {}.</p>",
                        fit.abilities.front().estimate ? "Intervals" : "No abilities", escapeHtml(fit.note));
    return out;
}

}  // namespace deixis::results
