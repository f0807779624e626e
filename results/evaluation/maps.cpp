// The evaluation's views of space: the test points by density, and maps from above and from behind.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "figures.hpp"
#include "results/page/figure_places.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t max_space_points = 1000;
constexpr double map_row_px = 150.0;

std::vector<Vec3> testPlaces(const Evaluation& evaluation) {
    std::vector<Vec3> places;
    for (const TestPoint& point : evaluation.points) places.push_back(point.target);
    return places;
}

/// Where the cells of a map begin and end along an axis: half-way between the places of a grid, or ten equal
/// parts.
std::vector<double> cellEdges(const std::vector<Vec3>& test_places, int axis) {
    constexpr std::size_t max_of_grid = 24;
    constexpr int parts = 10;
    std::vector<double> places;
    for (const Vec3& place : test_places) places.push_back(place[axis]);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<double> edges;
    if (places.size() > 1 && places.size() <= max_of_grid) {
        edges.push_back(places[0] - 0.5 * (places[1] - places[0]));
        for (std::size_t i = 1; i < places.size(); ++i) edges.push_back(0.5 * (places[i - 1] + places[i]));
        edges.push_back(places.back() + 0.5 * (places.back() - places[places.size() - 2]));
        return edges;
    }
    const SpaceBox space = SpaceBox::around(test_places).widened(0.0);
    for (int i = 0; i <= parts; ++i)
        edges.push_back(space.low[axis] + (space.high[axis] - space.low[axis]) * i / parts);
    return edges;
}

/// Means over x and another axis.
struct MapCells {
    int up;
    std::vector<double> x_edges, up_edges;
    std::vector<double> sums;
    std::vector<int> counts;

    MapCells(const std::vector<Vec3>& places, int up_axis)
        : up(up_axis), x_edges(cellEdges(places, 0)), up_edges(cellEdges(places, up_axis)) {
        sums.resize((x_edges.size() - 1) * (up_edges.size() - 1), 0.0);
        counts.resize(sums.size(), 0);
    }
    void add(const Vec3& at, double value) {
        const auto part = [](const std::vector<double>& edges, double coordinate) {
            const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, coordinate);
            return static_cast<std::size_t>(above - edges.begin()) - 1;
        };
        const std::size_t cell = part(up_edges, at[up]) * (x_edges.size() - 1) + part(x_edges, at.x);
        sums[cell] += value;
        ++counts[cell];
    }
};

/// The same values in both views.
struct BothMaps {
    MapCells above, behind;

    explicit BothMaps(const std::vector<Vec3>& places) : above(places, 2), behind(places, 1) {}
    void add(const Vec3& at, double value) {
        above.add(at, value);
        behind.add(at, value);
    }
    [[nodiscard]] SpaceBox space() const {
        return {{above.x_edges.front(), behind.up_edges.front(), above.up_edges.front()},
                {above.x_edges.back(), behind.up_edges.back(), above.up_edges.back()}};
    }
    /// Widens `range` by the means of the cells.
    void widen(std::pair<double, double>& range) const {
        for (const MapCells* cells : {&above, &behind})
            for (std::size_t i = 0; i < cells->sums.size(); ++i)
                if (cells->counts[i] > 0) {
                    range.first = std::min(range.first, cells->sums[i] / cells->counts[i]);
                    range.second = std::max(range.second, cells->sums[i] / cells->counts[i]);
                }
    }
};

void drawCells(SpacePlot& plot, std::size_t row, SpaceView view, const MapCells& cells,
               const std::string& name, const char* what) {
    const std::size_t columns = cells.x_edges.size() - 1;
    for (std::size_t i = 0; i < cells.sums.size(); ++i) {
        if (cells.counts[i] == 0) continue;
        Vec3 low{cells.x_edges[i % columns], 0.0, 0.0};
        Vec3 high{cells.x_edges[i % columns + 1], 0.0, 0.0};
        low[cells.up] = cells.up_edges[i / columns];
        high[cells.up] = cells.up_edges[i / columns + 1];
        const Vec3 middle = 0.5 * (low + high);
        const double value = cells.sums[i] / cells.counts[i];
        plot.cell(row, view, low, high, value,
                  fmt::format("{}{:.3g} (mean of {} {}{}) around x {:.2f}, {} {:.2f} m", name, value,
                              cells.counts[i], what, cells.counts[i] == 1 ? "" : "s", middle.x,
                              cells.up == 1 ? 'y' : 'z', middle[cells.up]));
    }
}

void drawMaps(SpacePlot& plot, std::size_t row, const BothMaps& maps, const std::string& name,
              const char* what) {
    drawCells(plot, row, SpaceView::above, maps.above, name, what);
    drawCells(plot, row, SpaceView::behind, maps.behind, name, what);
}

}  // namespace

Figure densityMap(const Evaluation& evaluation, Numbering& figures) {
    const auto places = testPlaces(evaluation);
    BothMaps maps(places);
    for (const TestPoint& point : evaluation.points) maps.add(point.target, point.density);
    std::pair<double, double> range{0.0, 0.0};
    maps.widen(range);
    SpacePlot plot({""}, maps.space());
    drawMaps(plot, 0, maps, "", "test point");
    for (const Vec3& target : evaluation.input.training) plot.dot(0, target);
    return {"density-map",
            fmt::format("{} Density of the training targets (1/m³) and the targets themselves (dots), "
                        "those within the map (the paper’s Figure\u00A010\u00A0B): {}",
                        figures.next(), spaceText(maps.space())),
            fmt::format("Maps of the density at {} test points from above and from behind the agent, with "
                        "the training targets as dots; densities up to {:.3g} per cubic metre.",
                        evaluation.points.size(), range.second),
            plot.spec(0.0, range.second > 0.0 ? range.second : 1.0, ".2~g", 1.3 * map_row_px), true};
}

Figure accuracyMaps(const Evaluation& evaluation, Numbering& figures) {
    const auto places = testPlaces(evaluation);
    std::vector<BothMaps> maps;
    std::vector<std::string> names;
    std::pair<double, double> range{std::numeric_limits<double>::max(),
                                    std::numeric_limits<double>::lowest()};
    for (const SystemEvaluation& system : evaluation.systems) {
        names.push_back(system.system);
        BothMaps& made = maps.emplace_back(places);
        for (const MeasuredClip* clip : system.clips)
            if (clip->accuracy) made.add(clip->target, clip->accuracy->reward);
        made.widen(range);
    }
    if (range.first > range.second) range = {0.0, motion::highest_pointing_reward};
    SpacePlot plot(names, maps.front().space());
    for (std::size_t row = 0; row < maps.size(); ++row)
        drawMaps(plot, row, maps[row], names[row] + ": ", "clip");
    return {"accuracy-map",
            fmt::format("{} Mean accuracy of each system by the target’s place (the paper’s "
                        "Figure\u00A010\u00A0C); one scale for all.",
                        figures.next()),
            fmt::format("Maps of the mean accuracy over the targets' places, from above and from behind the "
                        "agent, in a row for each of {} systems; {:.3f} to {:.3f}.",
                        names.size(), range.first, range.second),
            plot.spec(range.first, range.second > range.first ? range.second : range.first + 0.01, ".2f",
                      map_row_px),
            true};
}

namespace {

/// An orthographic view from ahead of the agent, to its left and above: right, down and towards the viewer.
Vec3 turnedToView(const Vec3& point) {
    static const double yaw = radiansFromDegrees(28.0);
    static const double pitch = radiansFromDegrees(20.0);
    const double right = std::cos(yaw) * point.x - std::sin(yaw) * point.z;
    const double nearer = std::sin(yaw) * point.x + std::cos(yaw) * point.z;
    return {right, -(std::cos(pitch) * point.y - std::sin(pitch) * nearer),
            std::sin(pitch) * point.y + std::cos(pitch) * nearer};
}

/// The floor's outline and the upright nearest to the viewer's left.
FigureJson boxLines(const SpaceBox& b) {
    const std::array<Vec3, 4> floor{{{b.low.x, b.low.y, b.high.z},
                                     {b.high.x, b.low.y, b.high.z},
                                     {b.high.x, b.low.y, b.low.z},
                                     {b.low.x, b.low.y, b.low.z}}};
    FigureJson lines = FigureJson::array();
    const auto line = [&](const Vec3& start, const Vec3& end) {
        const Vec3 from = turnedToView(start);
        const Vec3 to = turnedToView(end);
        lines.push_back(
            {{"x", rounded(from.x)}, {"y", rounded(from.y)}, {"x2", rounded(to.x)}, {"y2", rounded(to.y)}});
    };
    for (std::size_t i = 0; i < 4; ++i) line(floor[i], floor[(i + 1) % 4]);
    line(floor[0], {b.low.x, b.high.y, b.high.z});
    return lines;
}

struct BoxName {
    Vec3 at;
    const char* axis;
    double low, high;
    FigureJson mark;
};

FigureJson nameLayer(const BoxName& name) {
    const Vec3 at = turnedToView(name.at);
    FigureJson mark{
        {"type", "text"},
        {"color", soft_colour},
        {"text", fmt::format("{} {} to {} m", name.axis, fixedText(name.low, 1), fixedText(name.high, 1))}};
    mark.update(name.mark);
    return layerOf({{{"x", rounded(at.x)}, {"y", rounded(at.y)}}}, std::move(mark), FigureJson::object());
}

/// Of many test points as many as can be drawn, evenly along the density, and the nearer after the farther,
/// which they hide.
FigureJson drawnPoints(const Evaluation& evaluation) {
    std::vector<const TestPoint*> points;
    for (const TestPoint& point : evaluation.points) points.push_back(&point);
    std::stable_sort(points.begin(), points.end(),
                     [](const auto* a, const auto* b) { return a->density < b->density; });
    std::vector<std::pair<Vec3, const TestPoint*>> seen;
    for (const std::size_t pick : evenPicks(points.size(), max_space_points))
        seen.emplace_back(turnedToView(points[pick]->target), points[pick]);
    std::stable_sort(seen.begin(), seen.end(),
                     [](const auto& a, const auto& b) { return a.first.z < b.first.z; });
    FigureJson values = FigureJson::array();
    for (const auto& [at, point] : seen)
        values.push_back(
            {{"x", rounded(at.x)},
             {"y", rounded(at.y)},
             {"density", rounded(point->density)},
             {"tip", fmt::format("{}: {:.3g} per m\u00b3 at {:.2f}, {:.2f}, {:.2f} m", point->target_id,
                                 point->density, point->target.x, point->target.y, point->target.z)}});
    return values;
}

}  // namespace

Figure densitySpace(const Evaluation& evaluation, Numbering& figures) {
    const SpaceBox b = SpaceBox::around(testPlaces(evaluation)).widened(0.0);
    std::pair<double, double> across{0.0, 0.0};
    std::pair<double, double> down{0.0, 0.0};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at =
            turnedToView({(corner & 1) != 0 ? b.high.x : b.low.x, (corner & 2) != 0 ? b.high.y : b.low.y,
                          (corner & 4) != 0 ? b.high.z : b.low.z});
        if (corner == 0) {
            across = {at.x, at.x};
            down = {at.y, at.y};
        }
        across = {std::min(across.first, at.x), std::max(across.second, at.x)};
        down = {std::min(down.first, at.y), std::max(down.second, at.y)};
    }
    const double margin = 0.06 * (across.second - across.first);
    across = {across.first - margin, across.second + margin};
    down = {down.first - 0.4 * margin, down.second + margin};
    double highest = 0.0;
    for (const TestPoint& point : evaluation.points) highest = std::max(highest, point.density);

    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {across.first, across.second}}, {"nice", false}, {"zero", false}};
    x["axis"] = nullptr;
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {down.first, down.second}}, {"reverse", true}, {"nice", false}, {"zero", false}};
    y["axis"] = nullptr;
    FigureJson layers = FigureJson::array();
    layers.push_back(layerOf(boxLines(b), {{"type", "rule"}, {"color", even_colour}},
                             {{"x2", {{"field", "x2"}}}, {"y2", {{"field", "y2"}}}}));
    layers.push_back(
        layerOf(drawnPoints(evaluation),
                {{"type", "point"},
                 {"shape", "circle"},
                 {"size", evaluation.points.size() > 200 ? 42 : 110},
                 {"opacity", 1},
                 {"stroke", even_colour},
                 {"strokeWidth", 0.5}},
                {{"fill",
                  {{"field", "density"},
                   {"type", "quantitative"},
                   {"scale", {{"scheme", "viridis"}, {"domain", {0.0, highest > 0.0 ? highest : 1.0}}}},
                   {"legend", {{"format", ".2~g"}, {"gradientLength", 160}, {"tickCount", 3}}}}},
                 {"tooltip", {{"field", "tip"}}}}));
    const double middle_x = 0.5 * (b.low.x + b.high.x);
    const double middle_y = 0.5 * (b.low.y + b.high.y);
    for (const BoxName& name :
         {BoxName{{middle_x, b.low.y, b.high.z}, "x", b.low.x, b.high.x, {{"dx", -12}, {"dy", 18}}},
          BoxName{{b.high.x, b.low.y, 0.3 * b.low.z + 0.7 * b.high.z},
                  "z",
                  b.low.z,
                  b.high.z,
                  {{"dx", 10}, {"dy", 14}, {"align", "left"}}},
          BoxName{{b.low.x, middle_y, b.high.z}, "y", b.low.y, b.high.y, {{"dy", -12}, {"angle", 270}}}})
        layers.push_back(nameLayer(name));
    const double height_of_width = (down.second - down.first) / (across.second - across.first);
    return {"density-space",
            fmt::format(
                "{} Density of {} training targets (1/m³) at {} test points, seen from ahead of the "
                "agent and above (the paper’s Figure\u00A08).{} Kernel bandwidths x, y, z: {}.",
                figures.next(), evaluation.input.training.size(), evaluation.points.size(),
                evaluation.points.size() > max_space_points
                    ? fmt::format(" {} of the points are drawn, evenly along the density.", max_space_points)
                    : std::string(),
                bandwidthWords(evaluation)),
            fmt::format("{} test points in space, seen from ahead of the agent and above, coloured by the "
                        "kernel density estimate, up to {:.3g} per cubic metre.",
                        evaluation.points.size(), highest),
            {{"height", 260},
             {"usermeta", heightByWidth(fmt::format("{:.4f} * width", height_of_width))},
             {"encoding", {{"x", x}, {"y", y}}},
             {"layer", std::move(layers)}}};
}

}  // namespace deixis::results
