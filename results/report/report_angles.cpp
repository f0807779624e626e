#include "report_angles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/answers/accuracy_by_angle.hpp"
#include "results/page/figure.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

using Rows = std::vector<AngleResult>;

std::string whoLooks(const std::string& eyes) {
    return eyes == "avatar" ? std::string("as the avatar&#8217;s eyes see it")
                            : fmt::format("as the participant sees it, {}", escapeHtml(eyes));
}

std::vector<std::string> eyesOf(const Rows& rows) {
    std::vector<std::string> out;
    for (const AngleResult& row : rows)
        if (out.empty() || out.back() != row.eyes) out.push_back(row.eyes);
    return out;
}

FigureJson specOf(const AnalysisResult& result, const Rows& rows, const std::string& eyes) {
    const auto& systems = result.table.systems;
    FigureJson points = FigureJson::array();
    FigureJson bands = FigureJson::array();
    for (const AngleResult& row : rows) {
        if (row.eyes != eyes) continue;
        const std::string band = angleBandText(row);
        if (row.system == "all") bands.push_back(band);
        if (row.system == "all" || row.choices == 0) continue;
        points.push_back({{"band", band},
                          {"system", row.system},
                          {"share", static_cast<double>(row.right) / row.choices},
                          {"n", row.choices},
                          {"tip", fmt::format("{}, {} degrees: {} of {} correct", row.system, band, row.right,
                                              row.choices)}});
    }
    FigureJson colours = FigureJson::array();
    for (std::size_t i = 0; i < systems.size(); ++i) colours.push_back(systemColour(i));
    FigureJson x{{"field", "band"},
                 {"type", "ordinal"},
                 {"scale", {{"domain", bands}}},
                 {"axis", {{"title", "degrees to the nearest distractor"}, {"labelAngle", 0}}}};
    FigureJson y = quantity("share");
    y["scale"] = {{"domain", {0.0, 1.0}}};
    y["axis"] = {{"title", "correct choices"}, {"format", ".0%"}, {"tickCount", 5}};
    FigureJson colour{{"field", "system"},
                      {"type", "nominal"},
                      {"scale", {{"domain", systems}, {"range", std::move(colours)}}},
                      {"legend", {{"title", nullptr}, {"orient", "bottom"}, {"columns", 2}}}};
    const FigureJson encoding{{"x", std::move(x)}, {"y", std::move(y)}, {"color", std::move(colour)}};
    FigureJson marked = encoding;
    marked["size"] = {{"field", "n"},
                      {"type", "quantitative"},
                      {"scale", {{"range", {15, 130}}, {"zero", true}}},
                      {"legend", nullptr}};
    marked["tooltip"] = {{"field", "tip"}};
    FigureJson layers = FigureJson::array();
    layers.push_back(layerOf(points, {{"type", "line"}, {"strokeWidth", 1.5}, {"opacity", 0.7}}, encoding));
    layers.push_back(
        layerOf(std::move(points), {{"type", "point"}, {"filled", true}, {"opacity", 1}}, std::move(marked)));
    return {{"height", 220}, {"layer", std::move(layers)}};
}

std::string tableOf(const AnalysisResult& result, const Rows& rows, Numbering& tables) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    std::string columns = "<th>Angle</th><th class=\"text\">degrees</th>";
    for (const std::string& system : systems) columns += fmt::format("<th>{}</th>", escapeHtml(system));
    std::string out = openTable(
        units::choices,
        "Correct choices by the angle from the target to the distractor that looks nearest to it: how many, "
        "of "
        "how "
        "many choices. The participant&#8217;s eyes stand where the layout puts them, at the study&#8217;s "
        "eye "
        "height. Nothing is tested here.",
        columns, tables, TableWidth::dense);
    for (std::size_t first = 0; first < rows.size(); ++first) {
        if (rows[first].system != "all" || rows[first].choices == 0) continue;
        out += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td>",
                           whoLooks(rows[first].eyes), angleBandText(rows[first]));
        for (const std::string& system : systems) {
            const auto cell = std::find_if(rows.begin(), rows.end(), [&](const AngleResult& row) {
                return row.eyes == rows[first].eyes && row.system == system &&
                       row.from_deg == rows[first].from_deg;
            });
            out += cell->choices == 0
                       ? fmt::format("<td>{}</td>", dash)
                       : fmt::format("<td>{:.0f}&#160;% ({} of {})</td>", 100.0 * cell->right / cell->choices,
                                     cell->right, cell->choices);
        }
        out += "</tr>";
    }
    return out + close_table;
}

}  // namespace

std::string anglesHtml(const AnalysisResult& result, Numbering& figures, Numbering& tables) {
    const Rows rows = accuracyByAngle(result.table);
    if (rows.empty()) return "";
    std::string out = "<div class=\"plots\">";
    int number = 0;
    for (const std::string& eyes : eyesOf(rows))
        out += figureHtml(
            {fmt::format("angles-{}", ++number),
             fmt::format("{} Correct choices by how near the nearest distractor looks to the target, "
                         "{}; larger points stand for more choices.",
                         figures.next(), whoLooks(eyes)),
             fmt::format("Share of correct choices by the angle from the target to its nearest "
                         "distractor ({}), a line for each system; the numbers stand in a table of "
                         "this page.",
                         eyes),
             specOf(result, rows, eyes)});
    return out + "</div>" + tableOf(result, rows, tables);
}

}  // namespace deixis::results
