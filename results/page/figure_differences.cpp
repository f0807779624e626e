#include "results/page/figure_differences.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

struct DrawnRows {
    FigureJson points = FigureJson::array();
    FigureJson shifts = FigureJson::array();
    std::vector<std::vector<std::string>> names{};
};

std::pair<double, double> reachOf(const std::vector<DifferencePlot::Row>& rows) {
    double low = 0.0;
    double high = 0.0;
    for (const auto& row : rows) {
        for (const double difference : row.differences) {
            low = std::min(low, difference);
            high = std::max(high, difference);
        }
        low = std::min(low, row.shift.lower.value_or(low));
        high = std::max(high, row.shift.upper.value_or(high));
    }
    return high > low ? std::pair{low, high} : std::pair{-1.0, 1.0};
}

void addRow(DrawnRows& drawn, const DifferencePlot& plot, const DifferencePlot::Row& row, double apart) {
    const auto place = static_cast<double>(drawn.names.size());
    drawn.names.push_back({row.a, "\u2212 " + row.b});
    const auto values = thinnedValues(row.differences, plot.max_points);
    const auto sideways = sidewaysPlaces(values, apart, 0.24);
    const std::string names = fmt::format("{} \u2212 {}", row.a, row.b);
    for (std::size_t i = 0; i < sideways.size(); ++i)
        drawn.points.push_back({{"x", values[i]},
                                {"y", place + 0.1 + sideways[i]},
                                {"tip", fmt::format("{}: {}", names, plot.text(values[i]))}});
    if (!row.shift.estimate) return;
    drawn.shifts.push_back(
        {{"x", *row.shift.estimate},
         {"low", row.shift.lower.value_or(*row.shift.estimate)},
         {"high", row.shift.upper.value_or(*row.shift.estimate)},
         {"y", place - 0.32},
         {"colour", row.significant ? systemColour(0) : std::string(even_colour)},
         {"fill", row.significant ? systemColour(0) : std::string(paper_colour)},
         {"stars", row.significant ? starsText(row.p_holm) : std::string()},
         {"tip", fmt::format("{}: shift {}, p (Holm) {}", names, shiftText(row.shift, plot.text),
                             row.p_holm < 0.001 ? "< 0.001" : fmt::format("= {:.3f}", row.p_holm))}});
}

FigureJson shiftEncoding(const char* x) {
    return {{"x", quantity(x)}, {"color", ownColour()}, {"tooltip", {{"field", "tip"}}}};
}

}  // namespace

FigureJson differencesSpec(const DifferencePlot& plot) {
    const auto [low, high] = reachOf(plot.rows);
    const double room = 0.03 * (high - low);
    DrawnRows rows;
    for (const auto& row : plot.rows) addRow(rows, plot, row, 0.012 * (high - low));

    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {low - room, high + room}}, {"nice", false}};
    x["axis"] = plot.axis;
    x["axis"]["grid"] = true;
    x["axis"]["tickCount"] = {{"expr", "ceil(width / 60)"}};
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {-0.6, static_cast<double>(plot.rows.size()) - 0.5}},
                  {"reverse", true},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = rowAxis(rows.names);

    FigureJson interval = shiftEncoding("low");
    interval["x2"] = {{"field", "high"}};
    FigureJson estimate = shiftEncoding("x");
    estimate["stroke"] = estimate["color"];
    estimate.erase("color");
    estimate["fill"] = ownColour("fill");
    FigureJson stars = shiftEncoding("high");
    stars["color"] = {{"value", ink_colour}};
    stars["text"] = {{"field", "stars"}};
    const FigureJson shifts{{"values", std::move(rows.shifts)}};
    return {
        {"height", 54 * plot.rows.size()},
        {"encoding", {{"y", std::move(y)}}},
        {"layer",
         {{{"data", {{"values", {FigureJson::object()}}}},
           {"mark", {{"type", "rule"}, {"color", soft_colour}, {"strokeWidth", 1.2}}},
           {"encoding", {{"x", {{"datum", 0}}}, {"y", nullptr}}}},
          {{"data", {{"values", std::move(rows.points)}}},
           {"mark", {{"type", "circle"}, {"size", 20}, {"opacity", 0.45}, {"color", soft_colour}}},
           {"encoding", {{"x", std::move(x)}, {"tooltip", {{"field", "tip"}}}}}},
          {{"data", shifts},
           {"mark", {{"type", "rule"}, {"strokeWidth", 3}}},
           {"encoding", std::move(interval)}},
          {{"data", shifts},
           {"mark",
            {{"type", "point"}, {"shape", "diamond"}, {"size", 90}, {"strokeWidth", 1.5}, {"opacity", 1}}},
           {"encoding", std::move(estimate)}},
          {{"data", shifts},
           {"mark", {{"type", "text"}, {"align", "left"}, {"baseline", "middle"}, {"dx", 5}, {"dy", 3}}},
           {"encoding", std::move(stars)}}}}};
}

std::string shiftsText(const DifferencePlot& plot) {
    std::string spoken;
    for (const auto& row : plot.rows)
        if (row.shift.estimate)
            spoken += fmt::format(" {} \u2212 {}: {}{}.", row.a, row.b, shiftText(row.shift, plot.text),
                                  row.significant ? ", significant" : "");
    return spoken;
}

}  // namespace deixis::results
