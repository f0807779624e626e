#include "angles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/answers/accuracy_by_angle.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/figure.hpp"
#include "results/page/html_table.hpp"

namespace deixis::results {

namespace {

using Rows = std::vector<AngleResult>;

std::string whoLooks(const std::string& eyes) {
    return eyes == "avatar" ? std::string("as seen by the avatar")
                            : fmt::format("as seen by the participant, {}", eyes);
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

std::string angleTable(const AnalysisResult& result, const Rows& rows, Numbering& numbering) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    Table angles = tables::angles(result);
    angles.columns.push_back({"looks", ColumnKind::text, {.label = "Angle"}});
    angles.columns.push_back({"degrees", ColumnKind::text});
    std::vector<std::string> bands;  // in which somebody chose
    for (std::size_t i = 0; i < rows.size(); ++i) {
        angles.rows[i].cells.insert(angles.rows[i].cells.end(),
                                    {whoLooks(rows[i].eyes), angleBandText(rows[i])});
        if (rows[i].system == "all" && rows[i].choices > 0)
            bands.push_back(rows[i].eyes + angleBandText(rows[i]));
    }
    std::size_t place = 0;
    std::erase_if(angles.rows, [&](const Table::Row&) {
        const AngleResult& row = rows[place++];
        return std::find(bands.begin(), bands.end(), row.eyes + angleBandText(row)) == bands.end();
    });
    const auto share = [right = angles.at("right"),
                        of = angles.at("choices")](const Table::Row& row) -> Cell {
        const auto chosen = *row.cells[right].as<long long>();
        const auto choices = *row.cells[of].as<long long>();
        if (choices == 0) return {};
        return fmt::format("{:.0f}\u00a0% ({} of {})",
                           100.0 * static_cast<double>(chosen) / static_cast<double>(choices), chosen,
                           choices);
    };
    return tableHtml(wide(angles, {"looks", "degrees"}, "system", systems,
                          {{[](const std::string& system) { return system; }, share}}),
                     "Correct choices by the angle from the target to the distractor that looks nearest to "
                     "it: how many, of how many choices. The participant\u2019s eyes are at the "
                     "layout\u2019s place and the study\u2019s eye height. Nothing is tested here.",
                     numbering, dense_table);
}

}  // namespace

std::string anglesHtml(const AnalysisResult& result, Numbering& figures, Numbering& numbering) {
    const Rows rows = accuracyByAngle(result.table);
    if (rows.empty()) return "";
    std::string out;
    int number = 0;
    for (const std::string& eyes : eyesOf(rows))
        out += figureHtml(
            {fmt::format("angles-{}", ++number),
             fmt::format("{} Correct choices by the angle between target and nearest distractor, {}; larger "
                         "points mean more choices.",
                         figures.next(), escapeHtml(whoLooks(eyes))),
             fmt::format("Share of correct choices by the angle from the target to its nearest "
                         "distractor ({}), one line per system; a table of this page has the numbers.",
                         eyes),
             specOf(result, rows, eyes)});
    return figuresPlaced(out) + angleTable(result, rows, numbering);
}

}  // namespace deixis::results
