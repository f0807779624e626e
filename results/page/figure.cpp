#include "results/page/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/number.hpp"
#include "results/page/templates.hpp"

namespace deixis::results {

namespace {

/// JSON that can stand in a script element, in HTML and in XML.
std::string scriptJson(const FigureJson& json) {
    std::string out;
    for (const char c : json.dump(-1, ' ', false, FigureJson::error_handler_t::replace)) {
        if (c == '<' || c == '>' || c == '&')
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            out += c;
    }
    return out;
}

}  // namespace

std::string figureHtml(const Figure& figure) {
    FigureJson spec{{"$schema", "https://vega.github.io/schema/vega-lite/v6.json"},
                    {"description", figure.label},
                    {"width", "container"}};
    spec.update(figure.spec);
    return filled("figure.mustache", {{"name", figure.name},
                                      {"wide", figure.wide},
                                      {"label", figure.label},
                                      {"caption", figure.caption},
                                      {"spec", scriptJson(spec)}});
}

std::string figuresPlaced(const std::string& figures, FigurePlace place) {
    if (figures.empty()) return "";
    return filled("figures.mustache",
                  {{"place", place == FigurePlace::plots ? "plots" : "single"}, {"figures", figures}});
}

std::string systemColour(std::size_t index) {
    constexpr std::array colours{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"};
    return colours[index % colours.size()];
}

std::vector<std::string> brokenName(const std::string& name) {
    constexpr std::size_t fits = 12;
    const auto distance = [&](std::size_t at) {
        return std::abs(static_cast<double>(at) - static_cast<double>(name.size()) / 2.0);
    };
    std::size_t best = std::string::npos;
    for (std::size_t at = name.find_first_of("- "); at != std::string::npos;
         at = name.find_first_of("- ", at + 1))
        if (best == std::string::npos || distance(at) < distance(best)) best = at;
    if (name.size() <= fits || best == std::string::npos) return {name};
    return {name.substr(0, best + 1), name.substr(best + 1)};
}

std::vector<double> sidewaysPlaces(const std::vector<double>& values, double apart, double half) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> places(values.size(), 0.0);
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && values[order[end]] - values[order[first]] < apart) ++end;
        const std::size_t count = end - first;
        const double step =
            count > 1 ? std::min(0.2 * half, 2.0 * half / static_cast<double>(count - 1)) : 0.0;
        for (std::size_t i = 0; i < count; ++i)
            places[order[first + i]] = step * (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1));
        first = end;
    }
    return places;
}

std::vector<std::size_t> evenPicks(std::size_t count, std::size_t max) {
    std::vector<std::size_t> picks(std::min(count, max));
    for (std::size_t i = 0; i < picks.size(); ++i)
        picks[i] = picks.size() > 1 ? i * (count - 1) / (picks.size() - 1) : 0;
    return picks;
}

std::vector<double> thinnedValues(std::vector<double> values, std::size_t max) {
    std::sort(values.begin(), values.end());
    std::vector<double> thinned;
    for (const std::size_t at : evenPicks(values.size(), max)) thinned.push_back(values[at]);
    return thinned;
}

FigureJson nameAxis(const std::vector<std::vector<std::string>>& names) {
    std::vector<std::size_t> values(names.size());
    std::iota(values.begin(), values.end(), std::size_t{0});
    return {{"values", values},
            {"labelExpr",
             FigureJson(names).dump(-1, ' ', true, FigureJson::error_handler_t::replace) + "[datum.value]"},
            {"tickCount", names.size()},  // else Vega leaves out every second one where it is narrow
            {"labelLimit", 150},
            {"labelOverlap", false},
            {"grid", false},
            {"title", nullptr}};
}

FigureJson rowAxis(const std::vector<std::vector<std::string>>& names) {
    constexpr double line_px = 15.0;
    FigureJson axis = nameAxis(names);
    if (!names.empty()) axis["labelOffset"] = -0.5 * line_px * static_cast<double>(names.front().size() - 1);
    return axis;
}

double rounded(double value, int digits) {
    return finiteNumber(fmt::format("{:.{}g}", value, digits)).value_or(value);
}

FigureJson heightByWidth(const std::string& expression) {
    FigureJson patch{
        {{"op", "remove"}, {"path", "/height"}},
        {{"op", "add"}, {"path", "/signals/-"}, {"value", {{"name", "height"}, {"update", expression}}}}};
    return {{"embedOptions", {{"patch", std::move(patch)}}}};
}

FigureJson quantity(const char* field) {
    return {{"field", field}, {"type", "quantitative"}};
}

FigureJson ownColour(const char* field) {
    return {{"field", field}, {"type", "nominal"}, {"scale", nullptr}};
}

FigureJson layerOf(FigureJson values, FigureJson mark, FigureJson encoding) {
    return {{"data", {{"values", std::move(values)}}},
            {"mark", std::move(mark)},
            {"encoding", std::move(encoding)}};
}

}  // namespace deixis::results
