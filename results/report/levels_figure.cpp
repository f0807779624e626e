// Means under the levels of a within-participants factor, as in Deichler et al. 2023, Table 1, drawn.
#include <fmt/core.h>

#include <algorithm>

#include "figures.hpp"

namespace deixis::results {

namespace {

/// The rows of one measure and factor; of "all" where each system has one level, else of the systems.
struct LevelLines {
    std::vector<std::string> levels;
    std::vector<std::string> systems;
    std::vector<const LevelResult*> rows;
};

LevelLines linesOf(const AnalysisResult& result, const Measure& measure, const Factor& factor) {
    LevelLines out;
    std::vector<const LevelResult*> all;
    bool crossed = false;
    for (const std::string& system : result.table.systems) {
        int answered = 0;
        for (const LevelResult& row : result.levels)
            if (row.measure == measure.name && row.factor == factor.name && row.system == system &&
                row.n > 0) {
                out.rows.push_back(&row);
                ++answered;
            }
        crossed = crossed || answered > 1;
    }
    for (const LevelResult& row : result.levels)
        if (row.measure == measure.name && row.factor == factor.name && row.system == "all") {
            out.levels.push_back(row.level);
            all.push_back(&row);
        }
    out.systems = crossed ? result.table.systems : std::vector<std::string>{"all"};
    if (!crossed) out.rows = std::move(all);
    return out;
}

FigureJson pointsOf(const LevelLines& lines, const Measure& measure) {
    const auto placeIn = [](const std::vector<std::string>& names, const std::string& name) {
        return static_cast<double>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const double step = std::min(0.12, 0.5 / static_cast<double>(lines.systems.size()));
    FigureJson points = FigureJson::array();
    for (const LevelResult* row : lines.rows) {
        const Summary& of = row->over_participants;
        const double aside = step * (placeIn(lines.systems, row->system) -
                                     0.5 * static_cast<double>(lines.systems.size() - 1));
        const double low = of.interval ? of.interval->lower : of.mean;
        const double high = of.interval ? of.interval->upper : of.mean;
        points.push_back(
            {{"x", placeIn(lines.levels, row->level) + aside},
             {"y", of.mean},
             {"low", low},
             {"high", high},
             {"system", row->system},
             {"tip", fmt::format("{}, {}: {}{}, {} participants", row->system, row->level,
                                 scoreText(measure, of.mean),
                                 of.interval ? " " + intervalText(measure, low, high) : std::string(),
                                 of.by_participant.size())}});
    }
    return points;
}

FigureJson levelsSpec(const LevelLines& lines, const Measure& measure) {
    std::vector<std::string> colours;
    std::size_t longest = 1;
    for (std::size_t i = 0; i < lines.systems.size(); ++i) {
        colours.push_back(systemColour(i));
        longest = std::max(longest, lines.systems[i].size());
    }
    std::vector<std::vector<std::string>> names;
    for (const std::string& level : lines.levels) names.push_back(brokenName(level));
    FigureJson x = quantity("x");
    x["scale"] = {
        {"domain", {-0.5, static_cast<double>(names.size()) - 0.5}}, {"nice", false}, {"zero", false}};
    x["axis"] = nameAxis(names);
    const double room = 0.03 * (measure.high - measure.low);
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {measure.low - room, measure.high + room}}, {"nice", false}, {"zero", false}};
    y["axis"] = scaleAxis(measure);
    // As many beside each other as have room, by the place that the figure has: its own width is only known
    // once the legend is laid out.
    const std::string columns = fmt::format(
        "(width > 0 && containerSize()[0] > 0 ? max(1, floor((containerSize()[0] - 80) / {})) : {})",
        44 + 8 * longest, lines.systems.size());
    FigureJson colour{{"field", "system"},
                      {"type", "nominal"},
                      {"scale", {{"domain", lines.systems}, {"range", colours}}},
                      {"legend", {{"columns", {{"expr", columns}}}}}};
    if (lines.systems.size() == 1) colour["legend"] = nullptr;
    FigureJson interval{{"x", x}, {"y", y}, {"color", colour}, {"tooltip", {{"field", "tip"}}}};
    interval["y"]["field"] = "low";
    interval["y2"] = {{"field", "high"}};
    const FigureJson point{{"x", x}, {"y", y}, {"color", colour}, {"tooltip", {{"field", "tip"}}}};
    return {{"height", 280},
            {"data", {{"values", pointsOf(lines, measure)}}},
            {"layer",
             {{{"mark", {{"type", "line"}, {"strokeWidth", 1.2}, {"opacity", 0.6}}}, {"encoding", point}},
              {{"mark", {{"type", "rule"}, {"strokeWidth", 2}}}, {"encoding", interval}},
              {{"mark", {{"type", "point"}, {"filled", true}, {"size", 70}, {"opacity", 1}}},
               {"encoding", point}}}}};
}

}  // namespace

std::optional<Figure> levelsFigure(const AnalysisResult& result, std::size_t index, const Factor& factor,
                                   Numbering& figures) {
    const Measure& measure = result.measures[index];
    const LevelLines lines = linesOf(result, measure, factor);
    if (lines.levels.size() < 2) return std::nullopt;
    const bool intervals = std::any_of(lines.rows.begin(), lines.rows.end(), [](const LevelResult* row) {
        return row->over_participants.interval.has_value();
    });
    std::string spoken;
    for (const LevelResult* row : lines.rows)
        spoken += fmt::format(" {}, {}: {}.", row->system, row->level,
                              scoreText(measure, row->over_participants.mean));
    const auto place = [&] {
        const auto factors = withinFactors(result.table);
        const auto at = std::find_if(factors.begin(), factors.end(),
                                     [&](const Factor& one) { return one.name == factor.name; });
        return at - factors.begin() + 1;
    }();
    return Figure{
        fmt::format("levels-{}-{}", place, index + 1),
        fmt::format("{} {} by {}: means of participants' means{}.", figures.next(),
                    escapeHtml(capitalised(measure.name)), escapeHtml(factor.name),
                    intervals ? fmt::format(" with {:g}\u00A0% intervals", 100.0 * result.level) : ""),
        fmt::format("Means of {} under the levels of {}.{}", measure.name, factor.name, spoken),
        levelsSpec(lines, measure), result.systems.size() > 6};
}

}  // namespace deixis::results
