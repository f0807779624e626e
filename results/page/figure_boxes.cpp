#include "results/page/figure_boxes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "results/page/number_text.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

constexpr double bracket_height_px = 20.0;

/// Of the vertical axis, in the values' unit.
struct BoxAxis {
    double low = 0.0, high = 1.0;  ///< of the scale
    double room = 0.0;             ///< below and above it, so that points at its ends are whole
    double height_px = 0.0;
    [[nodiscard]] double perPixel() const { return (high - low + 2.0 * room) / height_px; }
};

/// A bracket over systems `left` < `right`, on level 0 or above.
struct Bracket {
    std::size_t left = 0, right = 0, level = 0;
    double p = 1.0;
};

/// The short ones below, none over another of its level.
std::vector<Bracket> bracketsOf(const BoxPlot& plot) {
    std::vector<Bracket> brackets;
    for (const BoxPlot::Pair& pair : plot.brackets) {
        const auto [left, right] = std::minmax(pair.a, pair.b);
        brackets.push_back({left, right, 0, pair.p});
    }
    std::stable_sort(brackets.begin(), brackets.end(), [](const Bracket& a, const Bracket& b) {
        return std::pair(a.right - a.left, a.left) < std::pair(b.right - b.left, b.left);
    });
    for (auto one = brackets.begin(); one != brackets.end(); ++one)
        while (std::any_of(brackets.begin(), one, [&](const Bracket& other) {
            return other.level == one->level && other.left < one->right && one->left < other.right;
        }))
            ++one->level;
    return brackets;
}

/// Where the boxes stand: at 0, 1, ..., with room between groups.
struct BoxPlaces {
    std::vector<double> x{};            ///< of each box
    std::vector<std::size_t> colour{};  ///< likewise; the same for the same place in each group
    std::vector<double> groups{};       ///< the middles of the groups
    double right = 0.5;                 ///< where the last one's room ends

    explicit BoxPlaces(const BoxPlot& plot) {
        constexpr double between_groups = 0.8;
        std::vector<std::size_t> sizes;
        for (const BoxPlot::Group& group : plot.groups) sizes.push_back(group.boxes);
        if (sizes.empty()) sizes.push_back(plot.boxes.size());
        double at = 0.0;
        for (const std::size_t size : sizes) {
            groups.push_back(at + 0.5 * (static_cast<double>(size) - 1.0));
            for (std::size_t i = 0; i < size; ++i) {
                x.push_back(at + static_cast<double>(i));
                colour.push_back(i);
            }
            at += static_cast<double>(size) + between_groups;
        }
        if (!x.empty()) right = x.back() + 0.5;
    }
};

/// What is drawn of all systems.
struct BoxParts {
    FigureJson outlines = FigureJson::array();
    FigureJson lines = FigureJson::array();  ///< whiskers and their ends
    FigureJson medians = FigureJson::array();
    FigureJson means = FigureJson::array();
    FigureJson points = FigureJson::array();
    FigureJson nothing = FigureJson::array();  ///< names of systems without answers
};

void addBox(BoxParts& parts, const BoxPlot& plot, const BoxPlaces& places, const BoxSummary& box,
            std::size_t place, double half) {
    const double x = places.x[place];
    const std::string colour = systemColour(places.colour[place]);
    const bool notched = box.notched();
    const std::string notch =
        notched ? fmt::format(" (notch {} to {})", plot.text(box.notch_low), plot.text(box.notch_high))
                : std::string();
    const std::string tip = fmt::format("{}: median {}{}, middle half {} to {}, mean {}, n = {}",
                                        plot.boxes[place].name, plot.text(box.median), notch,
                                        plot.text(box.q25), plot.text(box.q75), plot.text(box.mean), box.n);
    const double waist = notched ? 0.55 * half : half;
    const double notch_low = notched ? box.notch_low : box.q25;
    const double notch_high = notched ? box.notch_high : box.q75;
    const std::vector<std::pair<double, double>> corners{
        {half, box.q25},  {half, notch_low},   {waist, box.median},  {half, notch_high}, {half, box.q75},
        {-half, box.q75}, {-half, notch_high}, {-waist, box.median}, {-half, notch_low}, {-half, box.q25}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        parts.outlines.push_back({{"box", place},
                                  {"corner", i},
                                  {"x", x + corners[i].first},
                                  {"y", corners[i].second},
                                  {"colour", colour},
                                  {"tip", tip}});
    const auto line = [&](FigureJson& lines, double x1, double y1, double x2, double y2) {
        lines.push_back({{"x", x1}, {"y", y1}, {"x2", x2}, {"y2", y2}, {"colour", colour}, {"tip", tip}});
    };
    line(parts.lines, x, box.q05, x, box.q25);
    line(parts.lines, x, box.q75, x, box.q95);
    line(parts.lines, x - 0.4 * half, box.q05, x + 0.4 * half, box.q05);
    line(parts.lines, x - 0.4 * half, box.q95, x + 0.4 * half, box.q95);
    line(parts.medians, x - waist, box.median, x + waist, box.median);
    parts.means.push_back({{"x", x}, {"y", box.mean}, {"tip", tip}});
}

void addPoints(BoxParts& parts, const BoxPlot& plot, const BoxPlaces& at, const BoxAxis& axis,
               std::size_t place, double half) {
    const auto& [name, all] = plot.boxes[place];
    const std::vector<double> values = thinnedValues(all, plot.max_points);
    const auto places = sidewaysPlaces(values, 5.0 * axis.perPixel(), 0.85 * half);
    for (std::size_t i = 0; i < values.size(); ++i) {
        parts.points.push_back({{"x", at.x[place] + places[i]},
                                {"y", values[i]},
                                {"colour", systemColour(at.colour[place])},
                                {"tip", fmt::format("{}: {}", name, plot.text(values[i]))}});
        if (!plot.groups.empty()) parts.points.back()["box"] = name;
    }
}

FigureJson xy() {
    return {{"x", quantity("x")}, {"y", quantity("y")}, {"tooltip", {{"field", "tip"}}}};
}

FigureJson bracketLayers(const std::vector<Bracket>& brackets, const BoxPlaces& places, const BoxAxis& axis) {
    FigureJson lines = FigureJson::array();
    FigureJson stars = FigureJson::array();
    for (std::size_t i = 0; i < brackets.size(); ++i) {
        const Bracket& one = brackets[i];
        const double left = places.x[one.left] + 0.06;
        const double right = places.x[one.right] - 0.06;
        const double y = axis.high + axis.room +
                         (static_cast<double>(one.level) + 0.55) * bracket_height_px * axis.perPixel();
        const double foot = y - 5.0 * axis.perPixel();
        int corner = 0;
        for (const auto& [x, at] :
             {std::pair{left, foot}, std::pair{left, y}, std::pair{right, y}, std::pair{right, foot}})
            lines.push_back({{"bracket", i}, {"corner", corner++}, {"x", x}, {"y", at}});
        stars.push_back({{"x", 0.5 * (left + right)},
                         {"y", y},
                         {"stars", starsText(one.p)},
                         {"tip", one.p < 0.001 ? std::string("p (Holm) < 0.001")
                                               : fmt::format("p (Holm) = {:.3f}", one.p)}});
    }
    FigureJson text = xy();
    text["text"] = {{"field", "stars"}};
    return {
        layerOf(std::move(lines), {{"type", "line"}, {"color", soft_colour}, {"strokeWidth", 1.2}},
                {{"x", quantity("x")},
                 {"y", quantity("y")},
                 {"order", quantity("corner")},
                 {"detail", {{"field", "bracket"}}}}),
        layerOf(std::move(stars), {{"type", "text"}, {"baseline", "middle"}, {"dy", -4}}, std::move(text))};
}

/// The colours of the boxes of a group, with a legend.
FigureJson groupedColour(const BoxPlot& plot) {
    std::vector<std::string> names;
    std::vector<std::string> colours;
    std::size_t longest = 1;
    for (std::size_t i = 0; i < plot.groups.front().boxes; ++i) {
        names.push_back(plot.boxes[i].name);
        colours.push_back(systemColour(i));
        longest = std::max(longest, names.back().size());
    }
    // As many beside each other as have room.
    const std::string columns = fmt::format(
        "(width > 0 && containerSize()[0] > 0 ? max(1, floor((containerSize()[0] - 80) / {})) : {})",
        44 + 8 * longest, names.size());
    return {{"field", "box"},
            {"type", "nominal"},
            {"scale", {{"domain", names}, {"range", colours}}},
            {"legend", {{"columns", {{"expr", columns}}}}}};
}

FigureJson boxLayers(const BoxPlot& plot, BoxParts parts) {
    FigureJson layers = FigureJson::array();
    FigureJson outline = xy();
    outline["order"] = quantity("corner");
    outline["detail"] = {{"field", "box"}};
    outline["fill"] = outline["stroke"] = ownColour();
    FigureJson line = xy();
    line["x2"] = {{"field", "x2"}};
    line["y2"] = {{"field", "y2"}};
    FigureJson coloured_line = line;
    coloured_line["color"] = ownColour();
    FigureJson point = xy();
    point["color"] = plot.groups.empty() ? ownColour() : groupedColour(plot);
    FigureJson words = xy();
    words["text"] = {{"field", "tip"}};
    layers.push_back(
        layerOf(std::move(parts.lines), {{"type", "rule"}, {"strokeWidth", 1.5}}, coloured_line));
    layers.push_back(layerOf(std::move(parts.outlines),
                             {{"type", "line"},
                              {"interpolate", "linear-closed"},
                              {"filled", true},
                              {"fillOpacity", 0.18},
                              {"strokeWidth", 1.5}},
                             std::move(outline)));
    layers.push_back(layerOf(std::move(parts.points), {{"type", "circle"}, {"size", 20}, {"opacity", 0.55}},
                             std::move(point)));
    layers.push_back(layerOf(std::move(parts.medians),
                             {{"type", "rule"}, {"strokeWidth", 2.5}, {"color", ink_colour}},
                             std::move(line)));
    layers.push_back(layerOf(std::move(parts.means),
                             {{"type", "point"},
                              {"shape", "diamond"},
                              {"size", 80},
                              {"filled", true},
                              {"fill", paper_colour},
                              {"stroke", ink_colour},
                              {"strokeWidth", 1.5},
                              {"opacity", 1}},
                             xy()));
    if (!parts.nothing.empty()) layers.push_back(layerOf(std::move(parts.nothing), "text", std::move(words)));
    return layers;
}

FigureJson levelLayers(const std::vector<BoxPlot::Level>& levels, double right) {
    if (levels.empty()) return FigureJson::array();
    FigureJson lines = FigureJson::array();
    FigureJson words = FigureJson::array();
    for (const BoxPlot::Level& level : levels) {
        if (level.across) lines.push_back({{"y", level.value}});
        words.push_back({{"y", level.value}, {"words", level.words}});
    }
    return {
        layerOf(std::move(lines), {{"type", "rule"}, {"color", even_colour}, {"strokeDash", {5, 4}}},
                {{"y", quantity("y")}}),
        layerOf(
            std::move(words),
            {{"type", "text"}, {"align", "left"}, {"baseline", "middle"}, {"dx", 5}, {"color", soft_colour}},
            {{"x", {{"datum", right}}}, {"y", quantity("y")}, {"text", {{"field", "words"}}}})};
}

/// Names lie slanting where they have no room side by side.
void slantWhereNarrow(FigureJson& axis, const std::vector<std::vector<std::string>>& names) {
    constexpr double character_px = 7.6;
    const auto length = [](const std::vector<std::string>& lines) {
        std::size_t longest = 0;
        for (const std::string& line : lines) longest = std::max(longest, line.size());
        return static_cast<double>(longest);
    };
    double room_px = 0.0;  // between the middles of two names
    for (std::size_t i = 1; i < names.size(); ++i)
        room_px = std::max(room_px, 0.5 * (length(names[i - 1]) + length(names[i])) * character_px + 8.0);
    // By the place that the figure has: its width without the other axis is only known once the names are
    // laid out.
    const double place_px = room_px * static_cast<double>(names.size()) + 75.0;
    const auto either = [&](const char* slanting, const char* level) {
        return FigureJson{{"expr", fmt::format("(width > 0 && containerSize()[0] < {:.0f} ? {} : {})",
                                               place_px, slanting, level)}};
    };
    axis["labelAngle"] = either("-40", "0");
    axis["labelAlign"] = either("'right'", "'center'");
    axis["labelBaseline"] = "top";
}

}  // namespace

FigureJson boxPlotSpec(const BoxPlot& plot) {
    BoxAxis axis{plot.low, plot.high, 0.0, plot.height_px};
    if (!(axis.high > axis.low)) axis.high = axis.low + 1.0;
    axis.room = 0.03 * (axis.high - axis.low);
    const BoxPlaces places(plot);
    const std::size_t count = std::max<std::size_t>(1, plot.boxes.size());
    const double half = std::min(0.3, 0.1 * static_cast<double>(count));

    BoxParts parts;
    std::vector<std::vector<std::string>> names;
    for (const BoxPlot::Group& group : plot.groups) names.push_back(brokenName(group.name));
    for (std::size_t i = 0; i < plot.boxes.size(); ++i) {
        if (plot.groups.empty()) names.push_back(brokenName(plot.boxes[i].name));
        if (const auto box = boxSummary(plot.boxes[i].values)) {
            addBox(parts, plot, places, *box, i, half);
            addPoints(parts, plot, places, axis, i, half);
        } else {
            parts.nothing.push_back(
                {{"x", places.x[i]}, {"y", 0.5 * (axis.low + axis.high)}, {"tip", plot.nothing}});
        }
    }
    const std::vector<Bracket> brackets = bracketsOf(plot);
    std::size_t levels = 0;
    for (const Bracket& one : brackets) levels = std::max(levels, one.level + 1);

    FigureJson x_axis = nameAxis(names);
    if (!plot.groups.empty()) {
        x_axis["values"] = places.groups;
        x_axis["labelExpr"] = FigureJson(names).dump(-1, ' ', true, FigureJson::error_handler_t::replace) +
                              "[indexof(" + FigureJson(places.groups).dump() + ", datum.value)]";
    }
    slantWhereNarrow(x_axis, names);
    const double bracket_room = static_cast<double>(levels) * bracket_height_px;
    FigureJson boxes = boxLayers(plot, std::move(parts));
    FigureJson& x = boxes.front()["encoding"]["x"];
    x["scale"] = {{"domain", {-0.5, places.right}}, {"nice", false}, {"zero", false}};
    x["axis"] = std::move(x_axis);
    FigureJson& y = boxes.front()["encoding"]["y"];
    y["scale"] = {{"domain", {axis.low - axis.room, axis.high + axis.room + bracket_room * axis.perPixel()}},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = plot.axis;
    FigureJson layers = levelLayers(plot.levels, places.right);
    for (auto& layer : boxes) layers.push_back(std::move(layer));
    for (auto& layer : bracketLayers(brackets, places, axis)) layers.push_back(std::move(layer));
    return {{"height", plot.height_px + bracket_room}, {"layer", std::move(layers)}};
}

std::string mediansText(const BoxPlot& plot) {
    std::string medians;
    for (const auto& [name, values] : plot.boxes)
        if (!values.empty())
            medians +=
                fmt::format("{}{} {}", medians.empty() ? "" : ", ", name, plot.text(quantile(values, 0.5)));
    return medians;
}

}  // namespace deixis::results
