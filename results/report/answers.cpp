// Bars of shares that stand around a middle: the answers on a rating's scale, and the preferences of pairs.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figures.hpp"

namespace deixis::results {

namespace {

struct BarRow {
    std::vector<std::string> name;  ///< lines
    std::string spoken;
    std::vector<int> counts;  ///< of the steps
};

/// Brown over grey to teal (ColorBrewer's BrBG), told apart by people of all colour vision; `share` in [0,
/// 1].
std::string stepColour(double share) {
    constexpr std::array<std::array<double, 3>, 5> stops{
        {{166, 97, 26}, {223, 194, 125}, {217, 217, 213}, {128, 205, 193}, {1, 133, 113}}};
    const double at = share * (stops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    std::string colour = "#";
    for (std::size_t i = 0; i < 3; ++i)
        colour +=
            fmt::format("{:02x}", std::lround(stops[below][i] + (at - static_cast<double>(below)) *
                                                                    (stops[below + 1][i] - stops[below][i])));
    return colour;
}

/// Of n steps; an even number has none in the middle, and so no grey.
std::vector<std::string> stepColours(std::size_t n) {
    std::vector<std::string> colours;
    for (std::size_t i = 0; i < n; ++i)
        colours.push_back(stepColour(n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5));
    return colours;
}

/// Near black or near white, whichever reads better; neither is a colour that dark screens change.
const char* textOn(const std::string& colour) {
    const auto part = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16); };
    return 299 * part(1) + 587 * part(3) + 114 * part(5) < 125000 ? "#fefefe" : "#111111";
}

struct Bars {
    FigureJson parts = FigureJson::array();
    double low = 0.0, high = 0.0;  ///< how far they reach
};

void addBar(Bars& bars, const BarRow& row, std::size_t place, const std::vector<std::string>& steps,
            const std::vector<std::string>& colours) {
    int all = 0;
    for (const int count : row.counts) all += count;
    if (all == 0) return;
    const std::size_t n = row.counts.size();
    double at = 0.0;  // where the bar begins: what lies below the middle, and half of a middle step
    for (std::size_t i = 0; i < n / 2; ++i) at -= static_cast<double>(row.counts[i]) / all;
    if (n % 2 == 1) at -= 0.5 * row.counts[n / 2] / all;
    bars.low = std::min(bars.low, at);
    for (std::size_t i = 0; i < n; ++i) {
        const double share = static_cast<double>(row.counts[i]) / all;
        if (row.counts[i] > 0)
            bars.parts.push_back({{"y", static_cast<double>(place) - 0.36},
                                  {"y2", static_cast<double>(place) + 0.36},
                                  {"x", at},
                                  {"x2", at + share},
                                  {"step", steps[i]},
                                  {"share", share},
                                  {"ink", textOn(colours[i])},
                                  {"tip", fmt::format("{}, {}: {} of {} answers ({:.1f} %)", row.spoken,
                                                      steps[i], row.counts[i], all, 100.0 * share)}});
        at += share;
    }
    bars.high = std::max(bars.high, at);
}

FigureJson barsSpec(const std::vector<BarRow>& rows, const std::vector<std::string>& steps,
                    const std::vector<std::string>& colours) {
    Bars bars;
    std::vector<std::vector<std::string>> names;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        names.push_back(rows[i].name);
        addBar(bars, rows[i], i, steps, colours);
    }
    const double reach = bars.high - bars.low + 0.04;
    const FigureJson tip{{"field", "tip"}};
    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {bars.low - 0.02, bars.high + 0.02}}, {"nice", false}};
    x["axis"] = {{"title", "share of answers"},
                 {"labelExpr", "format(100 * abs(datum.value), '.0f') + '\u00a0%'"},
                 {"grid", true},
                 {"tickCount", {{"expr", "ceil(width / 60)"}}}};
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {-0.5, static_cast<double>(rows.size()) - 0.5}},
                  {"reverse", true},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = rowAxis(names);
    std::size_t longest = 1;
    for (const std::string& step : steps) longest = std::max(longest, step.size());
    // As many beside each other as have room beside the rows' names, by the place that the figure has: its
    // own width is only known once the legend is laid out.
    const FigureJson legend{
        {"columns",
         {{"expr",
           fmt::format(
               "(width > 0 && containerSize()[0] > 0 ? max(1, floor((containerSize()[0] - 175) / {})) "
               ": {})",
               34 + 8 * longest, steps.size())}}}};
    const FigureJson middle{{"data", {{"values", {FigureJson::object()}}}},
                            {"mark", {{"type", "rule"}, {"color", soft_colour}}},
                            {"encoding", {{"x", {{"datum", 0}}}}}};
    const FigureJson parts{{"mark", "rect"},
                           {"encoding",
                            {{"x", std::move(x)},
                             {"x2", {{"field", "x2"}}},
                             {"y", std::move(y)},
                             {"y2", {{"field", "y2"}}},
                             {"color",
                              {{"field", "step"},
                               {"type", "ordinal"},
                               {"scale", {{"domain", steps}, {"range", colours}}},
                               {"legend", legend}}},
                             {"tooltip", tip}}}};
    const FigureJson numbers{
        {"transform",
         {{{"calculate", "(datum.x + datum.x2) / 2"}, {"as", "middle"}},
          {{"calculate", "(datum.y + datum.y2) / 2"}, {"as", "centre"}},
          {{"filter", fmt::format("datum.share * width / {} > 34", reach)}}}},  // where there is room for it
        {"mark", {{"type", "text"}, {"baseline", "middle"}, {"fontSize", 12}}},
        {"encoding",
         {{"x", quantity("middle")},
          {"y", quantity("centre")},
          {"text", {{"field", "share"}, {"type", "quantitative"}, {"format", ".0%"}}},
          {"color", {{"field", "ink"}, {"type", "nominal"}, {"scale", nullptr}}},
          {"tooltip", tip}}}};
    return {{"height", 44 * rows.size()},
            {"data", {{"values", std::move(bars.parts)}}},
            {"layer", {middle, parts, numbers}}};
}

}  // namespace

std::optional<StepCounts> stepCounts(const AnalysisResult& result, std::size_t index) {
    constexpr double max_steps = 10.0;
    const Measure& measure = result.measures[index];
    const auto whole = [](double value) { return value == std::floor(value); };
    if (measure.kind != MeasureKind::rating || !whole(measure.low) || !whole(measure.high) ||
        measure.high - measure.low >= max_steps || measure.high <= measure.low)
        return std::nullopt;
    StepCounts out;
    for (int step = static_cast<int>(measure.low); step <= static_cast<int>(measure.high); ++step)
        out.steps.push_back(step);
    out.counts.assign(result.systems.size(), std::vector<int>(out.steps.size(), 0));
    std::map<std::string, std::size_t> systems;
    for (std::size_t i = 0; i < result.table.systems.size(); ++i) systems[result.table.systems[i]] = i;
    for (const ResponseRow& row : result.table.rows) {
        if (row.measure != measure.name) continue;
        if (!whole(row.value) || row.value < measure.low || row.value > measure.high) return std::nullopt;
        ++out.counts[systems[row.system]][static_cast<std::size_t>(row.value - measure.low)];
    }
    return out;
}

Figure answersFigure(const AnalysisResult& result, std::size_t index, const StepCounts& counts,
                     Numbering& figures) {
    const Measure& measure = result.measures[index];
    std::vector<std::string> steps;
    for (const int step : counts.steps) steps.push_back(fmt::format("{}", step));
    std::vector<BarRow> rows;
    for (std::size_t i = 0; i < result.systems.size(); ++i)
        rows.push_back({{result.systems[i].system}, result.systems[i].system, counts.counts[i]});
    return {
        fmt::format("answers-{}", index + 1),
        fmt::format("{} {}: how often each step of the scale was chosen. The middle of the scale is at 0.",
                    figures.next(), escapeHtml(capitalised(measure.name))),
        fmt::format("Stacked bars of the answers on {} from {} to {}, a bar for each of {} systems; a table "
                    "of this page has the shares.",
                    measure.name, measure.low, measure.high, result.systems.size()),
        barsSpec(rows, steps, stepColours(steps.size()))};
}

Figure preferencesFigure(const AnalysisResult& result, Numbering& figures) {
    std::vector<BarRow> rows;
    std::string spoken;
    for (const PreferenceResult& pair : result.preferences) {
        rows.push_back({{"A: " + pair.a, "B: " + pair.b},
                        pair.a + " and " + pair.b,
                        {pair.prefers_a, pair.ties, pair.prefers_b}});
        spoken += fmt::format(" {} {}, neither {}, {} {}.", pair.a, pair.prefers_a, pair.ties, pair.b,
                              pair.prefers_b);
    }
    return {
        "preferences",
        fmt::format("{} Preference: answers for A, for neither and for B, whichever was on the left.",
                    figures.next()),
        "Stacked bars of the preferences of each pair of systems, in answers." + spoken,
        barsSpec(rows, {"for A", "neither", "for B"}, {stepColour(1.0), stepColour(0.5), stepColour(0.0)})};
}

}  // namespace deixis::results
