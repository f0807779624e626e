// Participants' paired differences, with the estimate of their shift that belongs to the test.
#include <fmt/core.h>

#include <algorithm>

#include "report_figures.hpp"

namespace deixis::results {

namespace {

struct DifferenceRows {
    FigureJson points = FigureJson::array();
    FigureJson shifts = FigureJson::array();
    std::vector<std::vector<std::string>> names{};
    std::string spoken{};
};

std::vector<const Comparison*> comparedPairs(const AnalysisResult& result, const Measure& measure) {
    std::vector<const Comparison*> pairs;
    for (const Comparison& pair : result.pairwise)
        if (pair.measure == measure.name && !pair.differences.empty()) pairs.push_back(&pair);
    return pairs;
}

std::pair<double, double> reachOf(const std::vector<const Comparison*>& pairs) {
    double low = 0.0;
    double high = 0.0;
    for (const Comparison* pair : pairs) {
        for (const double difference : pair->differences) {
            low = std::min(low, difference);
            high = std::max(high, difference);
        }
        low = std::min(low, pair->test.hodges_lehmann.lower.value_or(low));
        high = std::max(high, pair->test.hodges_lehmann.upper.value_or(high));
    }
    return high > low ? std::pair{low, high} : std::pair{-1.0, 1.0};
}

void addPair(DifferenceRows& rows, const Comparison& pair, const Measure& measure, double apart) {
    const auto place = static_cast<double>(rows.names.size());
    rows.names.push_back({pair.a, "\u2212 " + pair.b});
    const auto sideways = sidewaysPlaces(pair.differences, apart, 0.24);
    const std::string names = fmt::format("{} \u2212 {}", pair.a, pair.b);
    for (std::size_t i = 0; i < sideways.size(); ++i)
        rows.points.push_back(
            {{"x", pair.differences[i]},
             {"y", place + 0.1 + sideways[i]},
             {"tip", fmt::format("{}: {}", names, scoreText(measure, pair.differences[i]))}});
    const HodgesLehmann& shift = pair.test.hodges_lehmann;
    if (!shift.estimate) return;
    const std::string found = fmt::format("{} {}", scoreText(measure, *shift.estimate),
                                          intervalText(measure, *shift.lower, *shift.upper));
    rows.shifts.push_back(
        {{"x", *shift.estimate},
         {"low", *shift.lower},
         {"high", *shift.upper},
         {"y", place - 0.32},
         {"colour", pair.significant ? systemColour(0) : std::string(even_colour)},
         {"fill", pair.significant ? systemColour(0) : std::string(paper_colour)},
         {"stars", pair.significant ? starsText(*pair.p_holm) : std::string()},
         {"tip", fmt::format("{}: shift {}, p (Holm) {}", names, found,
                             *pair.p_holm < 0.001 ? "< 0.001" : fmt::format("= {:.3f}", *pair.p_holm))}});
    rows.spoken += fmt::format(" {}: {}{}.", names, found, pair.significant ? ", significant" : "");
}

FigureJson shiftEncoding(const char* x) {
    return {{"x", quantity(x)},
            {"color", {{"field", "colour"}, {"type", "nominal"}, {"scale", nullptr}}},
            {"tooltip", {{"field", "tip"}}}};
}

}  // namespace

Figure differencesFigure(const AnalysisResult& result, std::size_t index, Numbering& figures) {
    const Measure& measure = result.measures[index];
    const auto pairs = comparedPairs(result, measure);
    const auto [low, high] = reachOf(pairs);
    const double room = 0.03 * (high - low);
    DifferenceRows rows;
    for (const Comparison* pair : pairs) addPair(rows, *pair, measure, 0.012 * (high - low));

    const bool accuracy = measure.kind == MeasureKind::accuracy;
    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {low - room, high + room}}, {"nice", false}};
    x["axis"] = {{"title", accuracy ? "difference, percentage points" : "difference, points of the scale"},
                 {"labelExpr", accuracy ? "format(100 * datum.value, '.0f')" : "datum.label"},
                 {"grid", true},
                 {"tickCount", {{"expr", "ceil(width / 60)"}}}};
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {-0.6, static_cast<double>(pairs.size()) - 0.5}},
                  {"reverse", true},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = rowAxis(rows.names);

    FigureJson interval = shiftEncoding("low");
    interval["x2"] = {{"field", "high"}};
    FigureJson estimate = shiftEncoding("x");
    estimate["stroke"] = estimate["color"];
    estimate.erase("color");
    estimate["fill"] = {{"field", "fill"}, {"type", "nominal"}, {"scale", nullptr}};
    FigureJson stars = shiftEncoding("high");
    stars["color"] = {{"value", ink_colour}};
    stars["text"] = {{"field", "stars"}};
    const FigureJson shifts{{"values", std::move(rows.shifts)}};
    FigureJson spec{
        {"height", 54 * pairs.size()},
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
    return {
        fmt::format("differences-{}", index + 1),
        fmt::format("{} {}: each participant's difference (points) and their shift with its interval "
                    "(Hodges&#8211;Lehmann; filled and starred where it is significant after Holm's "
                    "correction). Right of 0 the system named first is higher.",
                    figures.next(), escapeHtml(capitalised(measure.name))),
        fmt::format("Participants' differences in {} between the systems of each pair, with the shift and "
                    "its interval.{}",
                    measure.name, rows.spoken),
        std::move(spec)};
}

std::string differencesHtml(const AnalysisResult& result, Numbering& figures) {
    if (result.participants < 2) return "";
    std::string out;
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        if (!comparedPairs(result, result.measures[i]).empty())
            out += figureHtml(differencesFigure(result, i, figures));
    return out.empty() ? "" : "<h2>Paired differences</h2><div class=\"plots\">" + out + "</div>";
}

}  // namespace deixis::results
