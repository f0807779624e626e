// The evaluation's views of space: the test points by density, and maps over x and z.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "evaluation_figures.hpp"
#include "svg_drawing.hpp"

namespace deixis::results {

namespace {

struct Bounds {
    Vec3 low{std::numeric_limits<double>::max()};
    Vec3 high{std::numeric_limits<double>::lowest()};

    void add(const Vec3& point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
    /// An axis without length gets a little.
    void widen() {
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] - low[axis] < 0.1) {
                low[axis] -= 0.05;
                high[axis] += 0.05;
            }
    }
};

Bounds testBounds(const Evaluation& evaluation) {
    Bounds bounds;
    for (const TestPoint& point : evaluation.points) bounds.add(point.target);
    bounds.widen();
    return bounds;
}

/// Where the cells of a map begin and end along an axis: half-way between the places of a grid, or ten equal
/// parts.
std::vector<double> cellEdges(const Evaluation& evaluation, int axis) {
    constexpr std::size_t most_of_grid = 24;
    constexpr int parts = 10;
    std::vector<double> places;
    for (const TestPoint& point : evaluation.points) places.push_back(point.target[axis]);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<double> edges;
    if (places.size() > 1 && places.size() <= most_of_grid) {
        edges.push_back(places[0] - 0.5 * (places[1] - places[0]));
        for (std::size_t i = 1; i < places.size(); ++i) edges.push_back(0.5 * (places[i - 1] + places[i]));
        edges.push_back(places.back() + 0.5 * (places.back() - places[places.size() - 2]));
        return edges;
    }
    const Bounds bounds = testBounds(evaluation);
    for (int i = 0; i <= parts; ++i)
        edges.push_back(bounds.low[axis] + (bounds.high[axis] - bounds.low[axis]) * i / parts);
    return edges;
}

struct Cells {
    std::vector<double> x_edges, z_edges;
    std::vector<double> sums;
    std::vector<int> counts;

    explicit Cells(const Evaluation& evaluation)
        : x_edges(cellEdges(evaluation, 0)), z_edges(cellEdges(evaluation, 2)) {
        sums.resize((x_edges.size() - 1) * (z_edges.size() - 1), 0.0);
        counts.resize(sums.size(), 0);
    }
    void add(const Vec3& at, double value) {
        const auto part = [](const std::vector<double>& edges, double coordinate) {
            const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, coordinate);
            return static_cast<std::size_t>(above - edges.begin()) - 1;
        };
        const std::size_t cell = part(z_edges, at.z) * (x_edges.size() - 1) + part(x_edges, at.x);
        sums[cell] += value;
        ++counts[cell];
    }
    [[nodiscard]] std::optional<double> value(std::size_t i, std::size_t k) const {
        const std::size_t cell = k * (x_edges.size() - 1) + i;
        if (counts[cell] == 0) return std::nullopt;
        return sums[cell] / counts[cell];
    }
    [[nodiscard]] std::optional<std::pair<double, double>> range() const {
        std::optional<std::pair<double, double>> found;
        for (std::size_t cell = 0; cell < sums.size(); ++cell) {
            if (counts[cell] == 0) continue;
            const double value = sums[cell] / counts[cell];
            if (!found) found = {value, value};
            found = {std::min(found->first, value), std::max(found->second, value)};
        }
        return found;
    }
};

Cells accuracyCells(const Evaluation& evaluation, const SystemEvaluation& system) {
    Cells cells(evaluation);
    for (const MeasuredClip* clip : system.clips)
        if (clip->accuracy) cells.add(clip->target, clip->accuracy->reward);
    return cells;
}

struct MapFrame {
    Scale x, z;
    double bottom;
};

/// As seen from above with the agent looking up the page: its left, +x, lies on the left.
MapFrame mapFrame(const Cells& cells) {
    const double width = cells.x_edges.back() - cells.x_edges.front();
    const double depth = cells.z_edges.back() - cells.z_edges.front();
    const double height = std::clamp(220.0 * depth / width, 70.0, 260.0);
    const double bottom = 26.0 + height;
    return {{cells.x_edges.back(), cells.x_edges.front(), 48.0, 268.0},
            {cells.z_edges.front(), cells.z_edges.back(), bottom, 26.0},
            bottom};
}

void drawCells(SvgDrawing& drawing, const Cells& cells, const MapFrame& frame, double low, double high) {
    drawing.rectangle(frame.x.from, frame.z.to, frame.x.to - frame.x.from, frame.bottom - frame.z.to,
                      R"(class="nothing")");
    for (std::size_t k = 0; k + 1 < cells.z_edges.size(); ++k)
        for (std::size_t i = 0; i + 1 < cells.x_edges.size(); ++i) {
            const auto value = cells.value(i, k);
            if (!value) continue;
            const double share = high > low ? (*value - low) / (high - low) : 0.5;
            const double x = frame.x(cells.x_edges[i + 1]);
            const double y = frame.z(cells.z_edges[k + 1]);
            drawing.rectangle(x, y, frame.x(cells.x_edges[i]) - x + 0.3, frame.z(cells.z_edges[k]) - y + 0.3,
                              fmt::format(R"(fill="{}")", sharedColour(share)));
        }
    // An axis that falls to the right: its ticks are drawn here, those of z by the drawing.
    const std::vector<double> ticks = roundTicks(frame.x.high, frame.x.low, 6);
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
    for (const double tick : ticks)
        drawing.text(frame.x(tick), frame.bottom + 16.0, "middle", tickText(tick, step));
    drawing.text(0.5 * (frame.x.from + frame.x.to), frame.bottom + 34.0, "middle",
                 "x (m), the agent's left on the left");
    const std::vector<double> depths = roundTicks(frame.z.low, frame.z.high, 5);
    const double depth_step = depths.size() > 1 ? depths[1] - depths[0] : 1.0;
    for (const double tick : depths)
        drawing.text(frame.x.from - 6.0, frame.z(tick) + 4.5, "end", tickText(tick, depth_step));
    drawing.textUpwards(13.0, 0.5 * (frame.z.from + frame.z.to), "z (m), ahead");
}

double mapHeight(const MapFrame& frame) {
    return frame.bottom + 42.0;
}

}  // namespace

std::string densityMapSvg(const Evaluation& evaluation) {
    Cells cells(evaluation);
    for (const TestPoint& point : evaluation.points) cells.add(point.target, point.density);
    const MapFrame frame = mapFrame(cells);
    SvgDrawing drawing(
        340.0, mapHeight(frame), "map-density", "Density over x and z",
        fmt::format("Mean over y of the density at {} test points, seen from above, and the {} "
                    "training targets as rings.",
                    evaluation.points.size(), evaluation.input.training.size()));
    const auto range = cells.range();
    const double high = range ? range->second : 1.0;
    drawCells(drawing, cells, frame, 0.0, high);
    for (const Vec3& target : evaluation.input.training) {
        if (target.x < frame.x.high || target.x > frame.x.low || target.z < frame.z.low ||
            target.z > frame.z.high)
            continue;
        drawing.circle(frame.x(target.x), frame.z(target.z), 2.2, R"(class="ring")");
    }
    colourBar(drawing, 280.0, frame.z.to, frame.bottom - frame.z.to, 0.0, high, "1/m\u00b3");
    return drawing.finish();
}

std::string accuracyMapSvg(const Evaluation& evaluation, std::size_t index) {
    std::optional<std::pair<double, double>> range;
    for (const SystemEvaluation& system : evaluation.systems)
        if (const auto its = accuracyCells(evaluation, system).range()) {
            if (!range) range = its;
            range = {std::min(range->first, its->first), std::max(range->second, its->second)};
        }
    const SystemEvaluation& system = evaluation.systems[index];
    const Cells cells = accuracyCells(evaluation, system);
    const MapFrame frame = mapFrame(cells);
    SvgDrawing drawing(
        340.0, mapHeight(frame), fmt::format("map-{}", index),
        fmt::format("Accuracy over x and z: {}", system.system),
        "Mean over y of the accuracy, seen from above; the scale is the same for all systems.");
    const auto [low, high] = range.value_or(std::pair{0.0, reward_ceiling});
    drawCells(drawing, cells, frame, low, high);
    colourBar(drawing, 280.0, frame.z.to, frame.bottom - frame.z.to, low, high, "accuracy");
    return drawing.finish();
}

namespace {

/// An orthographic view from ahead of the agent, to its left and above.
struct View {
    Vec3 centre{0.0};
    double scale = 1.0;
    double shift_x = 0.0;
    double shift_y = 0.0;

    /// Right, down and towards the viewer.
    [[nodiscard]] Vec3 turned(const Vec3& point) const {
        static const double yaw = radiansFromDegrees(28.0);
        static const double pitch = radiansFromDegrees(20.0);
        const Vec3 p = point - centre;
        const double right = std::cos(yaw) * p.x - std::sin(yaw) * p.z;
        const double nearer = std::sin(yaw) * p.x + std::cos(yaw) * p.z;
        return {right, -(std::cos(pitch) * p.y - std::sin(pitch) * nearer),
                std::sin(pitch) * p.y + std::cos(pitch) * nearer};
    }
    [[nodiscard]] Vec3 operator()(const Vec3& point) const {
        const Vec3 at = turned(point);
        return {shift_x + scale * at.x, shift_y + scale * at.y, at.z};
    }
};

constexpr double grid_width = 320.0;

View viewOf(const Bounds& bounds) {
    View view;
    view.centre = 0.5 * (bounds.low + bounds.high);
    double left = 0.0, right = 0.0, top = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at = view.turned({(corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                                     (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                                     (corner & 4) != 0 ? bounds.high.z : bounds.low.z});
        left = std::min(left, at.x);
        right = std::max(right, at.x);
        top = std::min(top, at.y);
    }
    view.scale = grid_width / (right - left);
    view.shift_x = 24.0 - view.scale * left;
    view.shift_y = 20.0 - view.scale * top;
    return view;
}

/// The floor's outline and one upright, with their ends named.
double drawBox(SvgDrawing& drawing, const Bounds& b, const View& view) {
    const std::array<Vec3, 4> floor{{{b.low.x, b.low.y, b.high.z},
                                     {b.high.x, b.low.y, b.high.z},
                                     {b.high.x, b.low.y, b.low.z},
                                     {b.low.x, b.low.y, b.low.z}}};
    double lowest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 from = view(floor[i]);
        const Vec3 to = view(floor[(i + 1) % 4]);
        lowest = std::max(lowest, from.y);
        drawing.line(from.x, from.y, to.x, to.y, "axis");
    }
    const Vec3 foot = view(floor[0]);
    const Vec3 head = view({b.low.x, b.high.y, b.high.z});
    drawing.line(foot.x, foot.y, head.x, head.y, "axis");
    return lowest;
}

void nameBox(SvgDrawing& drawing, const Bounds& b, const View& view) {
    const auto along = [&](const Vec3& from, const Vec3& to, double dx, double dy, const char* anchor,
                           const std::string& words) {
        const Vec3 middle = view(0.5 * (from + to));
        drawing.text(middle.x + dx, middle.y + dy, anchor, words, "halo");
    };
    const auto range = [](const char* name, double low, double high) {
        return fmt::format("{} {} to {} m", name, tickText(low, 0.1), tickText(high, 0.1));
    };
    along({b.low.x, b.low.y, b.high.z}, {b.high.x, b.low.y, b.high.z}, -12.0, 24.0, "middle",
          range("x", b.low.x, b.high.x));
    along({b.high.x, b.low.y, b.high.z}, {b.high.x, b.low.y, b.low.z}, 8.0, 18.0, "start",
          range("z", b.low.z, b.high.z));
    const Vec3 upright = view({b.low.x, 0.5 * (b.low.y + b.high.y), b.high.z});
    drawing.textUpwards(upright.x - 10.0, upright.y, range("y", b.low.y, b.high.y));
}

}  // namespace

std::string densityGridSvg(const Evaluation& evaluation) {
    const Bounds bounds = testBounds(evaluation);
    const View view = viewOf(bounds);
    double lowest = 0.0;
    for (const double x : {bounds.low.x, bounds.high.x})
        lowest = std::max(lowest, view({x, bounds.low.y, bounds.high.z}).y);
    SvgDrawing drawing(
        440.0, lowest + 34.0, "grid", "Density of the training targets at the test points",
        fmt::format("{} test points in space, seen from ahead of the agent and above, coloured "
                    "by the kernel density estimate. The numbers stand in targets.csv.",
                    evaluation.points.size()));
    double highest = 0.0;
    std::vector<std::pair<Vec3, double>> seen;
    for (const TestPoint& point : evaluation.points) {
        seen.emplace_back(view(point.target), point.density);
        highest = std::max(highest, point.density);
    }
    // The nearer hide the farther.
    std::stable_sort(seen.begin(), seen.end(),
                     [](const auto& a, const auto& b) { return a.first.z < b.first.z; });
    drawBox(drawing, bounds, view);
    drawing.open("balls");
    for (const auto& [at, density] : seen)
        drawing.circle(at.x, at.y, 3.6,
                       fmt::format(R"(fill="{}")", sharedColour(highest > 0.0 ? density / highest : 0.0)));
    drawing.close();
    nameBox(drawing, bounds, view);
    colourBar(drawing, 380.0, 40.0, std::max(80.0, lowest - 60.0), 0.0, highest, "1/m\u00b3");
    return drawing.finish();
}

}  // namespace deixis::results
