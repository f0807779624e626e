// Box plots as in Deichler et al. 2023, Figure 7, and Yoon et al. 2021, Figure 7: notched, with every
// participant's mean as a point and brackets between the systems that differ.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report_figures.hpp"
#include "results/descriptive.hpp"

namespace deixis::results {

namespace {

constexpr double plot_height_px = 280.0;
constexpr double bracket_height_px = 20.0;
constexpr std::size_t most_brackets = 15;

/// Of the vertical axis, in the measure's unit.
struct BoxAxis {
    double low = 0.0, high = 1.0;  ///< of the scale
    double room = 0.0;             ///< below and above it, so that points at its ends are whole
    [[nodiscard]] double perPixel() const { return (high - low + 2.0 * room) / plot_height_px; }
};

/// A bracket over systems `left` < `right`, on level 0 or above.
struct Bracket {
    std::size_t left = 0, right = 0, level = 0;
    double p = 1.0;
};

std::size_t placeOf(const AnalysisResult& result, const std::string& system) {
    return static_cast<std::size_t>(
        std::find(result.table.systems.begin(), result.table.systems.end(), system) -
        result.table.systems.begin());
}

/// Of the pairs that differ; the short ones below, none over another of its level.
std::vector<Bracket> bracketsOf(const AnalysisResult& result, const std::string& measure) {
    std::vector<Bracket> brackets;
    for (const Comparison& pair : result.pairwise) {
        if (pair.measure != measure || !pair.significant) continue;
        const auto [left, right] = std::minmax({placeOf(result, pair.a), placeOf(result, pair.b)});
        brackets.push_back({left, right, 0, *pair.p_holm});
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

FigureJson layerOf(FigureJson values, FigureJson mark, FigureJson encoding) {
    return {{"data", {{"values", std::move(values)}}},
            {"mark", std::move(mark)},
            {"encoding", std::move(encoding)}};
}

/// A colour that stands in the data.
FigureJson ownColour() {
    return {{"field", "colour"}, {"type", "nominal"}, {"scale", nullptr}};
}

/// What is drawn of all systems.
struct BoxParts {
    FigureJson outlines = FigureJson::array();
    FigureJson lines = FigureJson::array();  ///< whiskers and their ends
    FigureJson medians = FigureJson::array();
    FigureJson means = FigureJson::array();
    FigureJson points = FigureJson::array();
    FigureJson nothing = FigureJson::array();  ///< names of systems without answers
};

void addBox(BoxParts& parts, const BoxSummary& box, const BoxAxis& axis, const Measure& measure,
            const std::string& system, std::size_t place, double half, const std::string& colour) {
    const auto x = static_cast<double>(place);
    const std::string tip = fmt::format(
        "{}: median {} (notch {} to {}), middle half {} to {}, mean {}, n = {}", system,
        scoreText(measure, box.median), scoreText(measure, box.notch_low), scoreText(measure, box.notch_high),
        scoreText(measure, box.q25), scoreText(measure, box.q75), scoreText(measure, box.mean), box.n);
    const auto within = [&](double value) {
        return std::clamp(value, axis.low - axis.room, axis.high + axis.room);
    };
    const double waist = 0.55 * half;
    const std::vector<std::pair<double, double>> corners{{half, box.q25},
                                                         {half, within(box.notch_low)},
                                                         {waist, box.median},
                                                         {half, within(box.notch_high)},
                                                         {half, box.q75},
                                                         {-half, box.q75},
                                                         {-half, within(box.notch_high)},
                                                         {-waist, box.median},
                                                         {-half, within(box.notch_low)},
                                                         {-half, box.q25}};
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

void addPoints(BoxParts& parts, const std::vector<double>& values, const BoxAxis& axis,
               const Measure& measure, const std::string& system, std::size_t place, double half,
               const std::string& colour) {
    const auto places = sidewaysPlaces(values, 5.0 * axis.perPixel(), 0.85 * half);
    for (std::size_t i = 0; i < values.size(); ++i)
        parts.points.push_back({{"x", static_cast<double>(place) + places[i]},
                                {"y", values[i]},
                                {"colour", colour},
                                {"tip", fmt::format("{}: {}", system, scoreText(measure, values[i]))}});
}

FigureJson xy() {
    return {{"x", quantity("x")}, {"y", quantity("y")}, {"tooltip", {{"field", "tip"}}}};
}

FigureJson bracketLayers(const std::vector<Bracket>& brackets, const BoxAxis& axis) {
    FigureJson lines = FigureJson::array();
    FigureJson stars = FigureJson::array();
    for (std::size_t i = 0; i < brackets.size(); ++i) {
        const Bracket& one = brackets[i];
        const double left = static_cast<double>(one.left) + 0.06;
        const double right = static_cast<double>(one.right) - 0.06;
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

FigureJson boxLayers(BoxParts parts) {
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
    point["color"] = ownColour();
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

/// Numbers at whole steps of a scale, at most some ten; of accuracy at each fifth.
FigureJson scaleValues(const Measure& measure) {
    FigureJson values = FigureJson::array();
    if (measure.kind == MeasureKind::accuracy) {
        for (int fifth = 0; fifth <= 5; ++fifth) values.push_back(fifth / 5.0);
        return values;
    }
    const double range = measure.high - measure.low;
    const int every = range <= 10.0    ? 1
                      : range <= 50.0  ? 5
                      : range <= 100.0 ? 20
                                       : static_cast<int>(range / 5.0);
    for (int step = static_cast<int>(measure.low); step <= static_cast<int>(measure.high); step += every)
        values.push_back(step);
    return values;
}

FigureJson chanceLayers(const Measure& measure, double right) {
    FigureJson at = FigureJson::array({{{"y", 1.0 / measure.balls}}});
    return {
        layerOf(at, {{"type", "rule"}, {"color", even_colour}, {"strokeDash", {5, 4}}},
                {{"y", quantity("y")}}),
        layerOf(at,
                {{"type", "text"}, {"text", "chance"}, {"align", "left"}, {"dx", 5}, {"color", soft_colour}},
                {{"x", {{"datum", right}}}, {"y", quantity("y")}})};
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

std::string boxLabel(const AnalysisResult& result, std::size_t index, std::size_t differing) {
    std::string medians;
    for (const SystemResult& system : result.systems)
        if (const auto box = boxSummary(system.measures[index].by_participant))
            medians += fmt::format("{}{} {}", medians.empty() ? "" : ", ", system.system,
                                   scoreText(result.measures[index], box->median));
    std::string label = fmt::format("Box plots of the participants' means of {} by system; medians: {}.",
                                    result.measures[index].name, medians);
    if (result.participants > 1 && result.systems.size() > 1)
        label += fmt::format(" {} of {} pairs of systems differ significantly.", differing,
                             result.systems.size() * (result.systems.size() - 1) / 2);
    return label;
}

}  // namespace

Figure boxPlot(const AnalysisResult& result, std::size_t index, Numbering& figures) {
    const Measure& measure = result.measures[index];
    const bool accuracy = measure.kind == MeasureKind::accuracy;
    BoxAxis axis{measure.low, measure.high, 0.0};
    if (!(axis.high > axis.low)) axis.high = axis.low + 1.0;
    axis.room = 0.03 * (axis.high - axis.low);
    const std::size_t count = std::max<std::size_t>(1, result.systems.size());
    const double half = std::min(0.3, 0.1 * static_cast<double>(count));

    BoxParts parts;
    std::vector<std::vector<std::string>> names;
    for (std::size_t i = 0; i < result.systems.size(); ++i) {
        const SystemResult& system = result.systems[i];
        const std::vector<double>& values = system.measures[index].by_participant;
        names.push_back(brokenName(system.system));
        if (const auto box = boxSummary(values)) {
            addBox(parts, *box, axis, measure, system.system, i, half, systemColour(i));
            addPoints(parts, values, axis, measure, system.system, i, half, systemColour(i));
        } else {
            parts.nothing.push_back({{"x", i}, {"y", 0.5 * (axis.low + axis.high)}, {"tip", "no answers"}});
        }
    }
    std::vector<Bracket> brackets = bracketsOf(result, measure.name);
    const std::size_t differing = brackets.size();
    if (differing > most_brackets) brackets.clear();
    std::size_t levels = 0;
    for (const Bracket& one : brackets) levels = std::max(levels, one.level + 1);

    FigureJson x_axis = nameAxis(names);
    slantWhereNarrow(x_axis, names);
    FigureJson y_axis{
        {"values", scaleValues(measure)},
        {"title", accuracy ? "right choices"
                           : fmt::format("{} ({:g} to {:g})", measure.name, measure.low, measure.high)}};
    if (accuracy)
        y_axis["labelExpr"] = "format(100 * datum.value, '.0f') + '\u00a0%'";
    else
        y_axis["format"] = ".0f";
    const double bracket_room = static_cast<double>(levels) * bracket_height_px;
    FigureJson boxes = boxLayers(std::move(parts));
    FigureJson& x = boxes.front()["encoding"]["x"];
    x["scale"] = {{"domain", {-0.5, static_cast<double>(count) - 0.5}}, {"nice", false}, {"zero", false}};
    x["axis"] = std::move(x_axis);
    FigureJson& y = boxes.front()["encoding"]["y"];
    y["scale"] = {{"domain", {axis.low - axis.room, axis.high + axis.room + bracket_room * axis.perPixel()}},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = std::move(y_axis);
    FigureJson layers = FigureJson::array();
    if (accuracy && measure.balls > 1)
        for (auto& layer : chanceLayers(measure, static_cast<double>(count) - 0.5))
            layers.push_back(std::move(layer));
    for (auto& layer : boxes) layers.push_back(std::move(layer));
    for (auto& layer : bracketLayers(brackets, axis)) layers.push_back(std::move(layer));
    FigureJson spec{{"height", plot_height_px + bracket_room}, {"layer", std::move(layers)}};

    std::string caption =
        fmt::format("{} {}: participants' means.", figures.next(),
                    accuracy ? "Referential accuracy" : escapeHtml(capitalised(measure.name)));
    if (!brackets.empty())
        caption += fmt::format(
            " Brackets: pairs that differ at &#945;&#160;=&#160;{} after Holm's correction "
            "(*&#160;p&#160;&#8804;"
            "&#160;0.05, **&#160;&#8804;&#160;0.01, ***&#160;&#8804;&#160;0.001).",
            result.alpha);
    else if (differing > 0)
        caption +=
            fmt::format(" {} pairs of systems differ, too many for brackets: see the tests.", differing);
    return {fmt::format("means-{}", index + 1), std::move(caption), boxLabel(result, index, differing),
            std::move(spec), result.systems.size() > 6};
}

}  // namespace deixis::results
